#include "functions/Probes.hpp"
#include "functions/readFunctions.hpp"
#include "functions/readProbeLocations.hpp"

#include <utility>

namespace isph
{

namespace
{

std::vector<Key> keys() { return probeKeys("(U p)", "any of U p vorticity divergence Q"); }

std::unique_ptr<FunctionObject> make(const std::string& name, const Dictionary& dictionary,
                                     const FunctionSurroundings& surroundings)
{
    return std::make_unique<Probes>(outputFile(name, "probes.csv", surroundings), surroundings.lattice,
                                    readProbeLocations(dictionary, surroundings.lattice),
                                    FlowFields(surroundings.lattice, pressureForm(surroundings)),
                                    readQuantities(dictionary, "fields"));
}

} // namespace

const FunctionType probesType{keys, make};

} // namespace isph
