#include "case/readTimeControl.hpp"
#include "functions/FieldAverage.hpp"
#include "functions/readFunctions.hpp"

namespace isph
{

namespace
{

std::vector<Key> keys()
{
    using enum Key::Type;
    return {{.name = "fields", .type = list, .fallback = "(U p)", .meaning = "any of U p vorticity divergence Q"},
            {.name = "prime2Mean", .type = flag, .fallback = "yes", .meaning = "second moments besides the means"},
            {.name = "executeControl",
             .type = word,
             .fallback = "timeStep",
             .meaning = "when samples are taken: what executeInterval counts",
             .words = functionWriteControls().names()},
            {.name = "executeInterval",
             .type = number,
             .unit = "steps or s",
             .fallback = "1",
             .meaning = "between two samples",
             .positive = true},
            // A restart goes on from averages written with the time it starts from.
            {.name = "writeControl",
             .type = word,
             .fallback = "writeTime",
             .meaning = "when averages are written: what writeInterval counts",
             .words = functionWriteControls().names()}};
}

std::unique_ptr<FunctionObject> make(const std::string& name, const Dictionary& dictionary,
                                     const FunctionSurroundings& surroundings)
{
    return std::make_unique<FieldAverage>(outputFolder(name, surroundings), surroundings.startTime,
                                          surroundings.lattice,
                                          FlowFields(surroundings.lattice, pressureForm(surroundings)),
                                          readQuantities(dictionary, "fields"), dictionary.flag("prime2Mean"));
}

} // namespace

const FunctionType fieldAverageType{keys, make};

} // namespace isph
