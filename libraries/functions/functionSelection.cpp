#include "functions/functionSelection.hpp"

#include "case/readTimeControl.hpp"
#include "functions/readFunctions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace isph
{

namespace
{

constexpr std::array<Selection<const FunctionType*>::Variant, 9> table{{
    {"errorNorms", "errors.csv: L1, L2, Linf and relative L2 of the difference to an exact solution", &errorNormsType},
    {"flowStatistics", "flow.csv: kinetic energy, enstrophy and its budget, palinstrophy, Courant number, divergence",
     &flowStatisticsType},
    {"sampleLines", "the lines and planes of system/sampleDict at run time", &sampleLinesType},
    {"probes", "probes.csv: values at points over time", &probesType},
    {"fieldAverage", "time means and second moments of fields, restartable", &fieldAverageType},
    {"timing", "timing.csv: seconds by phase, and steps", &timingType},
    {"wallProfile", "<patch>.csv at times: vorticity, shear stress and pressure along walls", &wallProfileType},
    {"forces", "forces.csv: pressure and viscous force and moment on patches", &forcesType},
    {"patchFlux", "flux.csv: the volume that leaves through patches per second", &patchFluxType},
}};
static_assert(distinct(table));

constexpr Selection<const FunctionType*> types("function type", table);

constexpr double noLimit = std::numeric_limits<double>::infinity();

/// The number of a key that may be left out.
double numberOr(const Dictionary& dictionary, std::string_view key, double otherwise)
{
    return dictionary.has(key) ? dictionary.number(key) : otherwise;
}

/// executeControl and executeInterval: when a function that gathers over time takes a sample.
std::optional<OutputControl> readSamplingControl(const Dictionary& function)
{
    if (!function.has("executeControl")) { return std::nullopt; }
    const WriteControl control = functionWriteControls()[function.word("executeControl")];
    const double interval = function.number("executeInterval");
    if (control == WriteControl::timeStep && (interval < 1 || interval != std::trunc(interval)))
    {
        throw function.error("executeInterval", "counts steps and must be a whole number", "write e.g. 1");
    }
    return OutputControl(control, interval);
}

} // namespace

std::vector<Key> functionKeys()
{
    using enum Key::Type;
    std::vector<Key> keys{
        {.name = "type", .type = word, .meaning = "what it does", .required = true},
        {.name = "enabled", .type = flag, .fallback = "yes", .meaning = "no: as if it were not there"},
        {.name = "timeStart", .type = number, .unit = "s", .meaning = "not before this time"},
        {.name = "timeEnd", .type = number, .unit = "s", .meaning = "not after this time"},
        {.name = "libs", .type = any, .meaning = "OpenFOAM's; not used: every function is part of the solver"}};
    std::ranges::move(outputControlKeys(), std::back_inserter(keys));
    return keys;
}

std::vector<ListedWord> functionTypes() { return types.words(); }

void forEachFunction(const Dictionary& functions, const std::vector<std::string>& types,
                     const std::function<void(const std::string&, const Dictionary&)>& visit)
{
    const auto look = [&](const Entry& entry)
    {
        if (!entry.isDictionary())
        {
            if (scalarValue(entry) || entry.usedByMacro) { return; } // a constant of the functions' expressions
            throw Error(Fault::input, entry.origin(), "is no function",
                        fmt::format("write {} {{ type errorNorms; ... }}", entry.keyword()));
        }
        const Dictionary& given = entry.dictionary();
        if (given.has("enabled") && !given.flag("enabled")) { return; }
        if (!given.has("type"))
        {
            throw given.error("type", "is missing", fmt::format("known are: {}", listOfWords("", types)));
        }
        visit(entry.keyword(), given);
    };
    std::vector<Complaint> complaints;
    for (const Entry& entry : functions.entries())
    {
        try
        {
            look(entry);
        }
        catch (const Error& error)
        {
            std::ranges::copy(error.complaints(), std::back_inserter(complaints));
        }
    }
    if (!complaints.empty()) { throw Error(Fault::input, std::move(complaints)); }
}

Dictionary completedFunction(const Dictionary& function, std::vector<Key> keysOfType)
{
    std::vector<Key> keys = std::move(keysOfType);
    std::ranges::copy_if(functionKeys(), std::back_inserter(keys),
                         [own = keys](const Key& key)
                         { return std::ranges::find(own, key.name, &Key::name) == own.end(); });
    return Schema("functions", std::move(keys)).complete(function);
}

FunctionSchedule readFunctionSchedule(const Dictionary& function)
{
    return {.control = readOutputControl(function),
            .sampling = readSamplingControl(function),
            .timeStart = numberOr(function, "timeStart", -noLimit),
            .timeEnd = numberOr(function, "timeEnd", noLimit)};
}

Functions::Functions(const Dictionary& functions, const FunctionSurroundings& surroundings)
{
    forEachFunction(functions, types.names(),
                    [&](const std::string& name, const Dictionary& given)
                    {
                        const FunctionType& type = *types[given.word("type")];
                        const Dictionary function = completedFunction(given, type.keys());
                        add(readFunctionSchedule(function), type.make(name, function, surroundings));
                    });
}

} // namespace isph
