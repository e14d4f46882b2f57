#include "transport/readScalarFunctions.hpp"

#include "caseFields/fluidConstants.hpp"
#include "functions/functionSelection.hpp"
#include "functions/readExactField.hpp"
#include "functions/readProbeLocations.hpp"
#include "sampling/readSampleSet.hpp"

#include <array>

namespace isph
{

namespace
{

struct Surroundings
{
    const Case& theCase;
    const Lattice& lattice;
    std::string startTime;
    std::string unit;
};

/// A type of function: its keys, and how it is made from them.
struct ScalarFunctionType
{
    std::vector<Key> (*keys)();
    std::unique_ptr<ScalarFunction> (*make)(const std::string& name, const Dictionary& dictionary,
                                            const Surroundings& surroundings);
};

/// What can be sampled.
const Selection<std::string_view>& fieldWords()
{
    static constexpr std::array<Selection<std::string_view>::Variant, 2> table{
        {{"T", "the scalar", "T"}, {"U", "the velocity that carries it", "U"}}};
    static constexpr Selection<std::string_view> selection("field", table);
    return selection;
}

std::filesystem::path outputFile(const std::string& name, const std::string& file, const Surroundings& surroundings)
{
    return postProcessingFile(surroundings.theCase.directory(), name, surroundings.startTime, file);
}

std::vector<Key> errorKeys()
{
    using enum Key::Type;
    return {{.name = "exact",
             .type = dictionary,
             .meaning = "the solution to compare with",
             .required = true,
             .keys = {{.name = "T", .type = function, .unit = "as 0/T", .meaning = "of x y z t", .required = true}}}};
}

std::unique_ptr<ScalarFunction> makeErrorNorms(const std::string& name, const Dictionary& dictionary,
                                               const Surroundings& surroundings)
{
    return std::make_unique<ScalarErrorNorms>(outputFile(name, "errors.csv", surroundings),
                                              readExactField(dictionary.dictionary("exact"), "T", 1,
                                                             fluidConstants(surroundings.theCase),
                                                             surroundings.theCase.directory(), surroundings.lattice),
                                              surroundings.unit);
}

std::vector<Key> probesKeys() { return probeKeys("(T)", "any of T U"); }

std::unique_ptr<ScalarFunction> makeProbes(const std::string& name, const Dictionary& dictionary,
                                           const Surroundings& surroundings)
{
    std::vector<std::string> fields;
    for (const Word& word : dictionary.words("fields")) { fields.emplace_back(fieldWords()[word]); }
    if (fields.empty()) { throw dictionary.error("fields", "names no field", "write e.g. fields (T);"); }
    return std::make_unique<ScalarProbes>(outputFile(name, "probes.csv", surroundings), surroundings.lattice,
                                          readProbeLocations(dictionary, surroundings.lattice), std::move(fields),
                                          surroundings.unit);
}

std::vector<Key> noKeys() { return {}; }

std::unique_ptr<ScalarFunction> makeSampleLines(const std::string& name, const Dictionary&,
                                                const Surroundings& surroundings)
{
    SampleSet samples = readSampleSet(surroundings.theCase.dictionary("system/sampleDict"), surroundings.lattice);
    for (const Word& word : samples.fields()) { fieldWords()[word]; }
    return std::make_unique<ScalarSampleLines>(surroundings.theCase.path("postProcessing") / name, std::move(samples),
                                               surroundings.unit);
}

constexpr ScalarFunctionType errorNormsType{errorKeys, makeErrorNorms};
constexpr ScalarFunctionType probesType{probesKeys, makeProbes};
constexpr ScalarFunctionType sampleLinesType{noKeys, makeSampleLines};

const Selection<const ScalarFunctionType*>& types()
{
    static constexpr std::array<Selection<const ScalarFunctionType*>::Variant, 3> table{{
        {"errorNorms", "errors.csv: L1, L2, Linf and relative L2 of the difference to an exact solution",
         &errorNormsType},
        {"sampleLines", "the lines and planes of system/sampleDict at run time", &sampleLinesType},
        {"probes", "probes.csv: values at points over time", &probesType},
    }};
    static_assert(distinct(table));
    static constexpr Selection<const ScalarFunctionType*> selection("function type of a scalar", table);
    return selection;
}

} // namespace

std::vector<ListedWord> scalarFunctionTypes() { return types().words(); }

ScalarFunctions readScalarFunctions(const Case& theCase, const Lattice& lattice, const std::string& startTime,
                                    const std::string& unit)
{
    ScalarFunctions functions;
    const Dictionary controlDict = theCase.dictionary("system/controlDict");
    if (!controlDict.hasDictionary("functions")) { return functions; }
    const Surroundings surroundings{theCase, lattice, startTime, unit};
    forEachFunction(controlDict.dictionary("functions"), types().names(),
                    [&](const std::string& name, const Dictionary& given)
                    {
                        const ScalarFunctionType& type = *types()[given.word("type")];
                        const Dictionary function = completedFunction(given, type.keys());
                        functions.add(readFunctionSchedule(function), type.make(name, function, surroundings));
                    });
    return functions;
}

} // namespace isph
