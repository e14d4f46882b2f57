#include "readSweep.hpp"

#include "core/Selection.hpp"
#include "csvTable.hpp"
#include "dictionary/Lexer.hpp"
#include "dictionary/writeDictionary.hpp"
#include "quantities.hpp"
#include "SweepText.hpp"
#include "workPrecisionSchema.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <utility>

namespace isph
{

namespace
{

const std::string shownAs = "system/workPrecisionDict";

std::vector<std::string> textsOf(const Dictionary& dictionary, const char* key)
{
    std::vector<std::string> texts;
    for (const Word& word : dictionary.words(key)) { texts.push_back(word.text); }
    return texts;
}

/// A name that can stand in a path.
std::string forPath(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter || c == '.' || c == '+' || c == '-' || c == '_') { result += c; }
        else if (!result.empty() && result.back() != '_') { result += '_'; }
    }
    while (result.ends_with('_')) { result.pop_back(); }
    const bool dots = result.find_first_not_of('.') == std::string::npos; // nothing, or a folder above
    return dots ? "_" + result : result;
}

std::size_t resolutionOf(const Dictionary& dictionary, const std::vector<Parameter>& parameters)
{
    if (!dictionary.has("resolution"))
    {
        if (parameters.size() == 1) { return 0; }
        throw dictionary.error("resolution", "is missing, and there are several parameters",
                               fmt::format("name the one along a line, e.g. resolution {};", parameters[0].name));
    }
    const Word word = dictionary.word("resolution");
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters) { names.push_back(parameter.name); }
    const auto found = std::ranges::find(names, word.text);
    if (found == names.end()) { throwUnknownWord("parameter", word, names); }
    return static_cast<std::size_t>(found - names.begin());
}

double resolutionOf(const Parameter& parameter, const std::string& value)
{
    const std::optional<double> number = resolutionValue(value);
    if (!number || *number <= 0)
    {
        throw Error(Fault::input, parameter.origin,
                    fmt::format("has the value {}, but the resolution must be positive numbers", value),
                    "name another parameter as resolution");
    }
    return *number;
}

/// The lists of a variant: its own where it has some.
std::vector<Parameter> listsOf(const Dictionary& variant, std::vector<Parameter> parameters)
{
    if (!variant.hasDictionary("parameters")) { return parameters; }
    for (Parameter& own : readParameters(variant.dictionary("parameters")))
    {
        const auto found = std::ranges::find(parameters, own.name, &Parameter::name);
        if (found == parameters.end())
        {
            throw Error(Fault::input, own.origin, "is not a parameter of the sweep",
                        "list it in parameters at the top as well");
        }
        if (own.entry.empty()) { own.entry = found->entry; }
        *found = std::move(own);
    }
    return parameters;
}

/// Every combination of values, the first parameter slowest.
std::vector<std::vector<std::string>> combinations(const std::vector<Parameter>& parameters)
{
    std::vector<std::vector<std::string>> result{{}};
    for (const Parameter& parameter : parameters)
    {
        std::vector<std::vector<std::string>> longer;
        for (const auto& head : result)
        {
            for (const std::string& value : parameter.values)
            {
                longer.push_back(head);
                longer.back().push_back(value);
            }
        }
        result = std::move(longer);
    }
    return result;
}

/// The range of `fit`: what a variant says, else the sweep.
FitRange fitOf(const Dictionary& dictionary, FitRange range)
{
    if (!dictionary.hasDictionary("fit")) { return range; }
    const Dictionary& fit = dictionary.dictionary("fit");
    if (fit.has("from")) { range.from = fit.number("from"); }
    if (fit.has("to")) { range.to = fit.number("to"); }
    return range;
}

/// Lays a dictionary of dictionaries over another.
void merge(Dictionary& target, const Dictionary& over)
{
    for (const Entry& entry : over.entries()) { target.set(entry); }
}

/// The entry that a parameter with `entry system/latticeDict.count;` sets.
void setDirectly(const Parameter& parameter, const std::string& value, Dictionary& settings)
{
    const std::size_t slash = parameter.entry.rfind('/');
    const std::size_t dot = parameter.entry.find('.', slash == std::string::npos ? 0 : slash);
    if (dot == std::string::npos || slash == std::string::npos)
    {
        throw Error(Fault::input, parameter.origin,
                    fmt::format("has the entry '{}', which is no FILE.ENTRY", parameter.entry),
                    "write e.g. entry system/latticeDict.count;");
    }
    std::string text = fmt::format("\"{}\"", parameter.entry.substr(0, dot));
    std::string closing;
    for (std::size_t begin = dot + 1; begin <= parameter.entry.size();)
    {
        const std::size_t end = std::min(parameter.entry.find('.', begin), parameter.entry.size());
        text += fmt::format(" {{ {}", parameter.entry.substr(begin, end - begin));
        closing += " }";
        begin = end + 1;
    }
    // On its line, for messages.
    const std::string above(static_cast<std::size_t>(std::max(parameter.origin.line - 1, 0)), '\n');
    merge(settings, Dictionary::parse(fmt::format("{}{} {};{}", above, text, value, closing), shownAs, ""));
}

/// The quantities of `error`, then those of `collect`.
std::vector<Quantity> quantitiesOf(const Dictionary& dictionary, Sweep& sweep)
{
    std::vector<Quantity> quantities;
    if (dictionary.has("error"))
    {
        if (!dictionary.hasDictionary("error"))
        {
            throw dictionary.error("error",
                                   fmt::format("is {} but must be a dictionary", shownValue(*dictionary.find("error"))),
                                   "write error { report errors.U.relL2; }, say");
        }
        const Dictionary& error = dictionary.dictionary("error");
        const bool named = !error.entries().empty() &&
                           std::ranges::all_of(error.entries(), [](const Entry& e) { return e.isDictionary(); });
        if (!named) { quantities.push_back(readQuantity("error", error)); }
        for (const Entry& entry : error.entries())
        {
            if (named) { quantities.push_back(readQuantity(entry.keyword(), entry.dictionary())); }
        }
    }
    else if (!dictionary.has("plot"))
    {
        throw dictionary.error("error", "is missing", "say what is compared, or give pictures of costs in plot");
    }
    sweep.measures.clear();
    for (const Quantity& quantity : quantities) { sweep.measures.push_back(quantity.name); }

    sweep.collected.clear();
    if (!dictionary.hasDictionary("collect")) { return quantities; }
    for (const Entry& entry : dictionary.dictionary("collect").entries())
    {
        quantities.push_back(readQuantity(entry.keyword(), entry.dictionary()));
        sweep.collected.push_back(entry.keyword());
    }
    return quantities;
}

void checkNames(const std::vector<Quantity>& quantities, const Sweep& sweep)
{
    std::vector<std::string> taken = runColumns();
    for (const Parameter& parameter : sweep.parameters)
    {
        if (std::ranges::find(taken, parameter.name) != taken.end())
        {
            throw Error(Fault::input, parameter.origin,
                        fmt::format("the table has a column {} already", parameter.name), "choose another name");
        }
        taken.push_back(parameter.name);
    }
    for (const Quantity& quantity : quantities)
    {
        if (std::ranges::find(taken, quantity.name) != taken.end())
        {
            throw Error(Fault::input, quantity.origin, fmt::format("the table has a column {} already", quantity.name),
                        "choose another name");
        }
        taken.push_back(quantity.name);
    }
    std::vector<std::string> single;
    for (const Quantity& quantity : quantities)
    {
        if (quantity.source != Quantity::Source::largestOf) { single.push_back(quantity.name); }
    }
    for (const Quantity& quantity : quantities)
    {
        for (const std::string& other : quantity.others)
        {
            const Word word{other, quantity.origin};
            if (std::ranges::find(single, other) == single.end()) { throwUnknownWord("quantity", word, single); }
        }
    }
}

/// The runs and lines of one variant.
class SweepReader
{
public:
    SweepReader(const Case& theCase, const SweepText& text, Sweep& sweep)
        : theCase_(theCase), text_(text), sweep_(sweep)
    {
    }

    void addVariant(const std::string& name, const Dictionary& variant)
    {
        const std::vector<Parameter> lists = listsOf(variant, sweep_.parameters);
        const std::size_t first = sweep_.runs.size();
        for (const std::vector<std::string>& values : combinations(lists)) { addRun(name, variant, lists, values); }
        for (std::size_t i = 0; i < lists.size(); ++i)
        {
            if (lists[i].values.size() == 1) { continue; }
            varied_.insert(lists[i].name);
            if (acts(i, first)) { acting_.insert(lists[i].name); }
        }
    }

    /// A list whose values change nothing is a slip: the same run, many times.
    void refuseIdleParameters() const
    {
        for (const Parameter& parameter : sweep_.parameters)
        {
            const bool idle = varied_.contains(parameter.name) && !acting_.contains(parameter.name);
            if (!idle || text_.uses(parameter.name)) { continue; }
            throw Error(
                Fault::input, parameter.origin, "changes nothing in any run",
                fmt::format("say which entry it sets, {0} {{ values (...); entry FILE.ENTRY; }}, or write ${0} in set",
                            parameter.name));
        }
    }

private:
    /// Whether two runs from the given one on that differ in one parameter only have other entries.
    bool acts(std::size_t parameter, std::size_t first) const
    {
        const Run& run = sweep_.runs[first];
        for (std::size_t i = first + 1; i < sweep_.runs.size(); ++i)
        {
            const Run& other = sweep_.runs[i];
            bool alone = other.values[parameter] != run.values[parameter];
            for (std::size_t k = 0; k < run.values.size(); ++k)
            {
                alone = alone && (k == parameter || other.values[k] == run.values[k]);
            }
            if (alone && (dictionaryText(other.settings) != dictionaryText(run.settings) ||
                          dictionaryText(other.replacements) != dictionaryText(run.replacements)))
            {
                return true;
            }
        }
        return false;
    }

    void addRun(const std::string& name, const Dictionary& variant, const std::vector<Parameter>& lists,
                const std::vector<std::string>& values)
    {
        Run run;
        run.values = values;
        run.resolution = resolutionOf(lists[sweep_.resolution], values[sweep_.resolution]);
        const Dictionary dictionary = workPrecisionSchema().complete(text_.with(values));
        const Dictionary& own = name.empty() ? variant : dictionary.dictionary("variants").dictionary(name);
        if (dictionary.hasDictionary("set")) { run.settings = dictionary.dictionary("set"); }
        if (dictionary.hasDictionary("replace")) { run.replacements = dictionary.dictionary("replace"); }
        for (std::size_t i = 0; i < lists.size(); ++i)
        {
            if (!lists[i].entry.empty()) { setDirectly(lists[i], values[i], run.settings); }
        }
        if (own.hasDictionary("set")) { merge(run.settings, own.dictionary("set")); }
        if (own.hasDictionary("replace")) { merge(run.replacements, own.dictionary("replace")); }
        run.quantities = quantitiesOf(dictionary, sweep_);
        if (sweep_.runs.empty()) { checkNames(run.quantities, sweep_); }

        run.line = lineOf(name, own, lists, values);
        sweep_.lines[run.line].fit = fitOf(own, fitOf(dictionary, {}));
        run.folder = std::filesystem::path("workPrecision") / forPath(sweep_.lines[run.line].name) /
                     forPath(sweep_.resolutionName() + values[sweep_.resolution]);
        sweep_.runs.push_back(std::move(run));
    }

    std::size_t lineOf(const std::string& name, const Dictionary& variant, const std::vector<Parameter>& lists,
                       const std::vector<std::string>& values)
    {
        Line line{name, variant.has("title") ? variant.text("title") : name, {}};
        for (std::size_t i = 0; i < lists.size(); ++i)
        {
            if (i == sweep_.resolution) { continue; }
            line.name += fmt::format("{}{}{}", line.name.empty() ? "" : "-", lists[i].name, values[i]);
            line.title += fmt::format("{}{} {}", line.title.empty() ? "" : ", ", lists[i].name, values[i]);
        }
        if (line.name.empty()) { line = {theCase_.name(), theCase_.name(), {}}; }
        const auto found = std::ranges::find(sweep_.lines, line.name, &Line::name);
        if (found != sweep_.lines.end()) { return static_cast<std::size_t>(found - sweep_.lines.begin()); }
        for (const Line& other : sweep_.lines)
        {
            if (forPath(other.name) == forPath(line.name))
            {
                throw Error(Fault::input, variant.origin(),
                            fmt::format("'{}' and '{}' would have the same folder", other.name, line.name),
                            "choose names of letters and digits");
            }
        }
        sweep_.lines.push_back(std::move(line));
        return sweep_.lines.size() - 1;
    }

    const Case& theCase_;
    const SweepText& text_;
    Sweep& sweep_;
    std::set<std::string> varied_;
    std::set<std::string> acting_;
};

void readGeneral(const Case& theCase, const Dictionary& dictionary, Sweep& sweep)
{
    sweep.title = dictionary.has("title") ? dictionary.text("title") : theCase.name();
    sweep.baseCase = (theCase.directory() / dictionary.text("baseCase")).lexically_normal();
    try
    {
        static_cast<void>(Case(sweep.baseCase));
    }
    catch (const Error& error)
    {
        throw dictionary.error("baseCase",
                               fmt::format("is {}: {}", dictionary.text("baseCase"), error.complaints().front().what),
                               "write the way to it from this case");
    }
    sweep.commands = textsOf(dictionary, "commands");
    sweep.after = textsOf(dictionary, "after");
    if (sweep.commands.empty())
    {
        throw dictionary.error("commands", "is empty", "the last one is the solver, whose time counts");
    }
    sweep.threads = dictionary.integer("threads");
    sweep.jobs = dictionary.integer("jobs");
    sweep.repetitions = dictionary.integer("repetitions");
    if (scalarValue(*dictionary.find("timeLimit"))) { sweep.timeLimit = dictionary.number("timeLimit"); }
}

} // namespace

std::optional<double> resolutionValue(const std::string& value)
{
    if (!value.starts_with('(')) { return numberFrom(value); }
    std::optional<double> largest;
    for (std::size_t begin = 1; begin < value.size();)
    {
        const std::size_t end = std::min(value.find_first_of(" \t()", begin), value.size());
        const std::optional<double> number = numberFrom(value.substr(begin, end - begin));
        if (number) { largest = std::max(*number, largest.value_or(*number)); }
        else if (end > begin) { return std::nullopt; }
        begin = end + 1;
    }
    return largest;
}

Sweep readSweep(const Case& theCase, bool reduced)
{
    if (!theCase.has(shownAs)) { static_cast<void>(theCase.dictionary(shownAs)); } // says what is missing
    const SweepText text(theCase.path(shownAs), shownAs, reduced);

    Sweep sweep;
    sweep.reduced = reduced;
    sweep.parameters = text.parameters();
    for (const Parameter& parameter : sweep.parameters)
    {
        const bool entry = std::ranges::any_of(workPrecisionSchema().keys(),
                                               [&](const Key& key) { return key.name == parameter.name; });
        if (!entry) { continue; }
        throw Error(Fault::input, parameter.origin, "is the name of an entry of this dictionary",
                    "choose another name");
    }
    std::vector<std::string> first;
    for (const Parameter& parameter : sweep.parameters) { first.push_back(parameter.values.front()); }
    const Dictionary dictionary = workPrecisionSchema().complete(text.with(first));
    sweep.resolution = resolutionOf(dictionary, sweep.parameters);
    readGeneral(theCase, dictionary, sweep);

    SweepReader reader(theCase, text, sweep);
    const Dictionary none(Origin{shownAs, 0, ""});
    const bool anyVariant =
        dictionary.hasDictionary("variants") && !dictionary.dictionary("variants").entries().empty();
    if (!anyVariant) { reader.addVariant("", none); }
    else
    {
        for (const Entry& entry : dictionary.dictionary("variants").entries())
        {
            reader.addVariant(entry.keyword(), entry.dictionary());
        }
    }
    reader.refuseIdleParameters();
    std::ranges::stable_sort(sweep.runs, {},
                             [&sweep](const Run& run)
                             {
                                 return std::ranges::find(sweep.parameters[sweep.resolution].values,
                                                          run.values[sweep.resolution]) -
                                        sweep.parameters[sweep.resolution].values.begin();
                             });
    readPictures(dictionary, sweep);
    readExternals(theCase, dictionary, sweep);
    return sweep;
}

} // namespace isph
