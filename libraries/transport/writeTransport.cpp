#include "transport/writeTransport.hpp"

#include "case/AtomicFolder.hpp"
#include "caseFields/storedFieldText.hpp"
#include "core/writeTextFile.hpp"
#include "fieldStore/FieldWriter.hpp"

namespace isph
{

void writeTransport(const Case& theCase, const std::string& timeName, const TimeState& state,
                    const TransportScene& scene, const ScalarTransport& transport)
{
    AtomicFolder folder(theCase.path(timeName));
    writeTextFile(folder.path() / "T", storedFieldText(scene.file.T, "T", 1));

    FieldWriter writer(folder.path() / "fields.h5", scene.lattice);
    writer.write("T", scene.file.unit, transport.values());
    writer.close();

    writeTextFile(folder.path() / "uniform" / "time", timeStateText(state, timeName));
    folder.commit();
}

} // namespace isph
