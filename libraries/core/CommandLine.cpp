#include "core/CommandLine.hpp"

#include "core/Error.hpp"
#include "core/nearestWord.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fmt/format.h>

namespace isph
{

namespace
{

const std::vector<Option>& commonOptions()
{
    static const std::vector<Option> options{
        {"case", "DIR", "case directory (default: the current one)"},
        {"quiet", "", "no report, only errors and warnings"},
        {"help", "", "print this text"},
        {"version", "", "print the version"},
    };
    return options;
}

/// All options of a program, listings included.
std::vector<Option> allOptions(const Application& application)
{
    std::vector<Option> options = application.options;
    for (const Listing& listing : application.listings)
    {
        options.push_back({listing.option, "", "print the words a dictionary may choose"});
    }
    options.insert(options.end(), commonOptions().begin(), commonOptions().end());
    return options;
}

/// -name or --name, if the text is one.
std::optional<std::string> optionName(const std::string& text)
{
    if (text.size() < 2 || text[0] != '-') { return std::nullopt; }
    std::string name = text.substr(text[1] == '-' ? 2 : 1);
    if (name == "h") { name = "help"; }
    return name;
}

bool isNumber(const std::string& text)
{
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0';
}

/// As one would type it in a shell.
std::string quoted(const std::string& text)
{
    constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:,+=%@^";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) { return text; }
    std::string result = "'";
    for (const char c : text) { c == '\'' ? result += "'\\''" : result += c; }
    return result + "'";
}

const Option& knownOption(const Application& application, const std::vector<Option>& options, const std::string& name,
                          const std::string& written)
{
    const auto option = std::ranges::find(options, name, &Option::name);
    if (option != options.end()) { return *option; }

    std::vector<std::string> names;
    for (const Option& known : options) { names.emplace_back(known.name); }
    const auto nearest = nearestWord(name, names);
    throw Error(Fault::usage, fmt::format("unknown option {}", written),
                nearest ? fmt::format("did you mean -{}?", *nearest)
                        : fmt::format("{} -help lists the options", application.name));
}

} // namespace

CommandLine::CommandLine(const Application& application, const std::vector<std::string>& arguments)
    : application_(&application), text_(application.name)
{
    for (const std::string& argument : arguments) { text_.append(" ").append(quoted(argument)); }

    const std::vector<Option> options = allOptions(application);
    const auto isOption = [&](const std::string& text)
    {
        const auto name = optionName(text);
        return name && std::ranges::find(options, *name, &Option::name) != options.end();
    };

    bool optionsEnded = false;
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
        const std::string& argument = arguments[i];
        const auto name = optionsEnded || isNumber(argument) ? std::nullopt : optionName(argument);
        if (!name)
        {
            positional_.push_back(argument);
            continue;
        }
        if (name->empty()) // a lone "--"
        {
            optionsEnded = true;
            continue;
        }

        const Option& option = knownOption(application, options, *name, argument);
        std::string value;
        if (!option.argument.empty())
        {
            // Whatever follows is the argument, a negative number too, but not another option.
            if (i + 1 == arguments.size() || isOption(arguments[i + 1]))
            {
                throw Error(Fault::usage, fmt::format("option {} needs an argument", argument),
                            fmt::format("write -{} {}", option.name, option.argument));
            }
            value = arguments[++i];
        }
        options_.insert_or_assign(std::string(option.name), value);
    }

    if (application.positional.empty() && !positional_.empty())
    {
        throw Error(Fault::usage,
                    fmt::format("'{}' is not an option and no other arguments are expected", positional_.front()),
                    fmt::format("{} -help shows the usage", application.name));
    }
}

bool CommandLine::has(std::string_view option) const { return options_.contains(option); }

std::optional<std::string> CommandLine::value(std::string_view option) const
{
    const auto found = options_.find(option);
    if (found == options_.end()) { return std::nullopt; }
    return found->second;
}

int CommandLine::wholeNumber(std::string_view option, int least, int otherwise) const
{
    const auto text = value(option);
    if (!text) { return otherwise; }
    int number = 0;
    const auto parsed = std::from_chars(text->data(), text->data() + text->size(), number);
    if (parsed.ec != std::errc() || parsed.ptr != text->data() + text->size() || number < least)
    {
        throw Error(Fault::usage, fmt::format("-{}: '{}' is no whole number from {} on", option, *text, least));
    }
    return number;
}

std::filesystem::path CommandLine::caseDirectory() const { return value("case").value_or("."); }

std::string listingText(const Listing& listing)
{
    const std::vector<ListedWord> words = listing.words();
    std::size_t width = 0;
    for (const ListedWord& word : words) { width = std::max(width, word.name.size()); }
    std::string text;
    for (const ListedWord& word : words)
    {
        text += word.summary.empty() ? word.name + "\n" : fmt::format("{:<{}}  {}\n", word.name, width, word.summary);
    }
    return text;
}

std::string helpText(const Application& application)
{
    std::string text =
        fmt::format("Usage: {} [OPTIONS]{}{}\n\n{}\n\nOptions:\n", application.name,
                    application.positional.empty() ? "" : " ", application.positional, application.summary);

    const std::vector<Option> options = allOptions(application);
    const auto spelled = [](const Option& option)
    { return fmt::format("-{}{}{}", option.name, option.argument.empty() ? "" : " ", option.argument); };

    std::size_t width = 0;
    for (const Option& option : options) { width = std::max(width, spelled(option).size()); }
    for (const Option& option : options) { text += fmt::format("  {:<{}}  {}\n", spelled(option), width, option.help); }

    if (!application.examples.empty())
    {
        text += "\nExamples:\n";
        std::string_view rest = application.examples;
        while (!rest.empty())
        {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            if (end > 0) { text += fmt::format("  {}\n", rest.substr(0, end)); }
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return text;
}

} // namespace isph
