#include "exactDerivatives.hpp"

#include "case/CsvWriter.hpp"
#include "caseFields/fluidConstants.hpp"
#include "dictionary/Schema.hpp"
#include "dictionary/SpaceTimeFunction.hpp"
#include "fields/reductions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace isph
{

namespace
{

const Schema& schema()
{
    using Type = Key::Type;
    static const Schema keys("fcExtendDict",
                             {{.name = "exact",
                               .type = Type::dictionary,
                               .meaning = "derivatives to compare with",
                               .keys = {{.name = "field",
                                         .type = Type::word,
                                         .fallback = "auto",
                                         .meaning = "the scalar they belong to; auto: the only field"},
                                        {.name = "gradient", .type = Type::function, .meaning = "of x y z t"},
                                        {.name = "laplacian", .type = Type::function, .meaning = "of x y z t"}}}});
    return keys;
}

struct Norms
{
    double L1 = 0;
    double L2 = 0;
    double Linf = 0;
    double relL2 = 0;
};

/// Norms of errors at points whose exact values have the given mean square.
Norms normsOf(std::span<const double> errors, double exactMeanSquare)
{
    const auto count = static_cast<double>(errors.size());
    Norms norms;
    norms.L1 = sum(errors) / count;
    norms.L2 = std::sqrt(sumOfSquares(errors) / count);
    norms.Linf = largestMagnitude(errors);
    norms.relL2 = exactMeanSquare > 0 ? norms.L2 / std::sqrt(exactMeanSquare) : norms.L2;
    return norms;
}

class ErrorTable
{
public:
    ErrorTable(const Lattice& lattice, double time) : at_(lattice.coordinates()), time_(time)
    {
        add("time", "s", time);
    }

    void add(const std::string& name, const std::string& unit, double value)
    {
        columns_.push_back({name, unit});
        values_.push_back(value);
    }

    /// Adds the norms of a scalar or vector field's error.
    void compare(const std::string& name, const std::string& unit, const SpaceTimeFunction& exact,
                 const Lattice& lattice, const RealField& found, Log& log)
    {
        RealField exactValues(1, found.size());
        RealField magnitudes(1, found.size());
        RealField error(1, found.size());
        double exactMeanSquare = 0;
        std::vector<std::pair<std::string, double>> alone;
        for (int d = 0; d < found.components(); ++d)
        {
            const bool vector = exact.components() == 3;
            exact.evaluate(vector ? lattice.direction(d) : 0, at_[0], at_[1], at_[2], time_, exactValues[0]);
            exactMeanSquare += sumOfSquares(exactValues[0]) / static_cast<double>(found.size());
            std::ranges::transform(found[d], exactValues[0], error[0].begin(),
                                   [](double a, double b) { return a - b; });
            std::ranges::transform(magnitudes[0], error[0], magnitudes[0].begin(),
                                   [](double sum, double e) { return sum + e * e; });
            if (vector)
            {
                alone.emplace_back(fmt::format("{}.{}", name, lattice.activeAxis(d).name), normsOf(error[0], 0).L2);
            }
        }
        for (double& value : magnitudes[0]) { value = std::sqrt(value); }
        const Norms norms = normsOf(magnitudes[0], exactMeanSquare);
        add(fmt::format("L1({})", name), unit, norms.L1);
        add(fmt::format("L2({})", name), unit, norms.L2);
        add(fmt::format("Linf({})", name), unit, norms.Linf);
        add(fmt::format("relL2({})", name), "", norms.relL2);
        log.line(fmt::format("    error of the {:9} L1 {:.3e}  L2 {:.3e}  Linf {:.3e}  relative L2 {:.3e}", name,
                             norms.L1, norms.L2, norms.Linf, norms.relL2));
        for (const auto& [component, L2] : alone) { add(fmt::format("L2({})", component), unit, L2); }
    }

    void write(const std::filesystem::path& file) const { CsvWriter(file, columns_).row(values_); }

private:
    std::array<std::vector<double>, 3> at_;
    double time_;
    std::vector<CsvColumn> columns_;
    std::vector<double> values_;
};

} // namespace

Dictionary readFcExtendDict(const Case& theCase)
{
    const bool written = theCase.has("system/fcExtendDict");
    return schema().complete(written ? theCase.dictionary("system/fcExtendDict") : Dictionary());
}

std::string fieldOfExact(const Dictionary& fcExtendDict, const std::vector<std::string>& fields)
{
    const Dictionary& exact = fcExtendDict.dictionary("exact");
    if (!exact.has("gradient") && !exact.has("laplacian")) { return ""; }
    const std::string field = exact.word("field").text;
    if (field == "auto")
    {
        if (fields.size() == 1) { return fields.front(); }
        throw fcExtendDict.error("exact", fmt::format("does not tell which of {} it is for", fmt::join(fields, ", ")),
                                 "write field NAME; in it, or choose one with -fields");
    }
    if (std::ranges::find(fields, field) == fields.end())
    {
        throw exact.error("field",
                          fmt::format("'{}' is none of the fields continued: {}", field, fmt::join(fields, ", ")));
    }
    return field;
}

void reportErrors(const Case& theCase, const std::string& timeName, double time, const Dictionary& fcExtendDict,
                  const Lattice& lattice, const RealField& gradient, const RealField& laplacian,
                  const std::string& unit, Log& log)
{
    const Dictionary& exact = fcExtendDict.dictionary("exact");
    const auto constants = fluidConstants(theCase);
    ErrorTable table(lattice, time);
    if (exact.has("gradient"))
    {
        table.compare("gradient", unit + "/m", readFunction(exact, "gradient", 3, constants, theCase.directory()),
                      lattice, gradient, log);
    }
    if (exact.has("laplacian"))
    {
        table.compare("laplacian", unit + "/m2", readFunction(exact, "laplacian", 1, constants, theCase.directory()),
                      lattice, laplacian, log);
    }
    table.write(postProcessingFile(theCase.directory(), "fcExtend", timeName, "errors.csv"));
}

} // namespace isph
