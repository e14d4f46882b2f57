#include "flow/writeFlow.hpp"

#include "case/AtomicFolder.hpp"
#include "core/FileDescriptor.hpp"
#include "dictionary/writeDictionary.hpp"

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

/// The field's dictionary with its values in fields.h5.
std::string fieldText(const Dictionary& field, const std::string& fieldClass, const std::string& name)
{
    Dictionary written = field;
    const Origin origin = field.find("internalField")->origin();
    written.set(Entry("internalField", false, origin,
                      {{Token::Kind::word, "hdf5", 0, origin.line}, {Token::Kind::string, "fields.h5", 0, origin.line}}));
    return foamHeader(fieldClass, name) + dictionaryText(written);
}

} // namespace

void writeFlow(const Case& flowCase, const std::string& timeName, const TimeState& state, const Scene& scene,
               IncompressibleFlow& flow)
{
    const FlowFiles& files = scene.files;
    AtomicFolder folder(flowCase.path(timeName));
    writeText(folder.path() / "U", fieldText(files.U, "latticeVectorField", "U"));
    writeText(folder.path() / "p", fieldText(files.p, "latticeScalarField", "p"));

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
