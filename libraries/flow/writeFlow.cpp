#include "flow/writeFlow.hpp"

#include "case/AtomicFolder.hpp"
#include "caseFields/storedFieldText.hpp"
#include "core/FileDescriptor.hpp"

#include <fcntl.h>

namespace isph
{

namespace
{

void writeText(const std::filesystem::path& path, const std::string& text)
{
    FileDescriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
    file.write(text);
    file.sync();
}

} // namespace

void writeFlow(const Case& flowCase, const std::string& timeName, const TimeState& state, const Scene& scene,
               IncompressibleFlow& flow)
{
    const FlowFiles& files = scene.files;
    AtomicFolder folder(flowCase.path(timeName));
    writeText(folder.path() / "U", storedFieldText(files.U, "U", 3));
    writeText(folder.path() / "p", storedFieldText(files.p, "p", 1));

    FieldWriter writer(folder.path() / "fields.h5", scene.lattice);
    writer.write("U", "m/s", flow.velocity());
    const RealField& kinematic = flow.pressure(state.time);
    if (files.pressureScale == 1) { writer.write("p", files.pressureUnit, kinematic); }
    else
    {
        RealField scaled = copyOf(kinematic);
        for (double& value : scaled[0]) { value *= files.pressureScale; }
        writer.write("p", files.pressureUnit, scaled);
    }
    flow.save(writer);
    writer.close();

    makeFolder(folder.path() / "uniform");
    // A restart that meets other transform plans ends in other bits; it compares this and says so.
    writeText(folder.path() / "uniform" / "time",
              timeStateText(state, timeName, "transformPlans  \"" + flow.planFingerprint() + "\";\n"));
    folder.commit();
}

} // namespace isph
