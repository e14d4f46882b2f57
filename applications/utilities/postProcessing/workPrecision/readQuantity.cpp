#include "core/numberText.hpp"
#include "readSweep.hpp"
#include "workPrecisionSchema.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

constexpr std::array<std::pair<const char*, Quantity::Source>, 5> sources{{
    {"report", Quantity::Source::report},
    {"function", Quantity::Source::function},
    {"line", Quantity::Source::line},
    {"command", Quantity::Source::command},
    {"largestOf", Quantity::Source::largestOf},
}};

constexpr std::array<std::pair<const char*, Quantity::Reduction>, 5> reductions{{
    {"last", Quantity::Reduction::last},
    {"first", Quantity::Reduction::first},
    {"max", Quantity::Reduction::max},
    {"min", Quantity::Reduction::min},
    {"peak", Quantity::Reduction::peak},
}};

std::string textOr(const Dictionary& dictionary, const char* key, const std::string& otherwise)
{
    return dictionary.has(key) ? dictionary.text(key) : otherwise;
}

/// "validation/x.csv:y:U.x"
Quantity::Profile readProfile(const Dictionary& dictionary)
{
    const std::string text = dictionary.text("reference");
    const std::size_t second = text.rfind(':');
    const std::size_t first = second == std::string::npos || second == 0 ? second : text.rfind(':', second - 1);
    if (first == std::string::npos || first == 0)
    {
        throw dictionary.error("reference", fmt::format("is '{}' but must be \"FILE:COLUMN:COLUMN\"", text),
                               "the columns are those of abscissa and value");
    }
    return {text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

void readSource(const Dictionary& dictionary, Quantity& quantity)
{
    std::vector<std::string> given;
    for (const auto& [key, source] : sources)
    {
        if (!dictionary.has(key)) { continue; }
        given.emplace_back(key);
        quantity.source = source;
        if (source != Quantity::Source::largestOf)
        {
            quantity.from = dictionary.text(key);
            continue;
        }
        for (const Word& word : dictionary.words(key)) { quantity.others.push_back(word.text); }
    }
    if (given.size() != 1)
    {
        throw Error(Fault::input, dictionary.origin(),
                    given.empty() ? "does not say where the number comes from"
                                  : fmt::format("has both {} and {}", given[0], given[1]),
                    "give it one of report, function, line, command and largestOf");
    }
}

} // namespace

Quantity readQuantity(const std::string& name, const Dictionary& written)
{
    const Dictionary dictionary = quantitySchema().complete(written);
    Quantity quantity;
    quantity.name = name;
    quantity.origin = written.origin();
    readSource(dictionary, quantity);

    const bool ofColumn = quantity.source == Quantity::Source::function || quantity.source == Quantity::Source::line;
    if (ofColumn) { quantity.column = dictionary.text("column"); }
    quantity.abscissa = dictionary.text("abscissa");
    const std::string reduce = dictionary.word("reduce").text;
    quantity.reduction = std::ranges::find(reductions, reduce, [](const auto& pair) { return pair.first; })->second;
    quantity.norm = dictionary.word("norm").text == "rms" ? Quantity::Norm::rms : Quantity::Norm::max;
    if (dictionary.has("at")) { quantity.at = dictionary.number("at"); }
    if (dictionary.has("from")) { quantity.begin = dictionary.number("from"); }
    if (dictionary.has("to")) { quantity.end = dictionary.number("to"); }
    quantity.overFirst = dictionary.flag("overFirst");
    quantity.per = textOr(dictionary, "per", "");
    quantity.optional = dictionary.flag("optional");
    const bool named = dictionary.has("reference") && !scalarValue(*dictionary.find("reference"));
    if (quantity.source == Quantity::Source::line && named) { quantity.profile = readProfile(dictionary); }
    else if (dictionary.has("reference"))
    {
        quantity.reference = dictionary.number("reference");
        if (*quantity.reference == 0)
        {
            throw dictionary.error("reference", "is 0, to which nothing has a relative difference", "leave it out");
        }
    }
    const std::string called = ofColumn ? quantity.column : quantity.others.empty() ? quantity.from : name;
    std::string label = called;
    if (quantity.profile) { label = fmt::format("deviation of {}", called); }
    else if (quantity.reference)
    {
        label = fmt::format("relative error of {}{}",
                            quantity.reduction == Quantity::Reduction::peak ? "the peak of " : "", called);
    }
    if (!quantity.per.empty()) { label += fmt::format(" per {}", quantity.per); }
    quantity.label = textOr(dictionary, "title", label);
    return quantity;
}

} // namespace isph
