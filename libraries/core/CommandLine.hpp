#pragma once

#include "core/Selection.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// An option of a program, written -name or --name.
struct Option
{
    std::string_view name;     ///< without dashes
    std::string_view argument; ///< what follows it, for the help text ("DIR", "RANGES"); empty for a switch
    std::string_view help;     ///< one line
};

/// A table that -<option> prints: the words a dictionary may choose, e.g. {"listKernels", ...}.
struct Listing
{
    std::string_view option;
    std::vector<ListedWord> (*words)();
};

/// What a program is, for its help text and its command line.
struct Application
{
    std::string_view name;
    std::string_view summary;         ///< one line
    std::string_view examples;        ///< command lines that work, a line each
    std::vector<Option> options = {}; ///< besides the common ones
    std::string_view positional = ""; ///< help text of arguments without a dash, "DICTIONARY"; empty: none allowed
    std::vector<Listing> listings = {};
    bool banner = true; ///< header (version, host, date, case) and "End" around the report
};

/// Options shared by the programs that work on times or on fields (contract, section 6).
inline const std::vector<Option> timeOptions{
    {"time", "RANGES", "times to work on: values and ranges, e.g. 0.1,0.5:1 or :2 or 3:"},
    {"latestTime", "", "the latest time only"},
    {"noZero", "", "leave out time 0"},
};
inline const std::vector<Option> fieldOptions{
    {"fields", "'(U p)'", "fields to work on"},
};

/// A parsed command line. Common options: -case DIR, -help, -version, -quiet, and the listings of the program.
class CommandLine
{
public:
    /// \throws Error(usage) for an unknown option (naming the nearest one), a missing argument or a stray word.
    CommandLine(const Application& application, const std::vector<std::string>& arguments);

    bool has(std::string_view option) const;

    /// The argument of an option that was given.
    std::optional<std::string> value(std::string_view option) const;

    /// The whole number behind an option, `otherwise` where it was not given.
    /// \throws Error(usage) for what is none, and for numbers below the least.
    int wholeNumber(std::string_view option, int least, int otherwise) const;

    const std::vector<std::string>& positional() const { return positional_; }

    /// -case, default "."; not checked for existence.
    std::filesystem::path caseDirectory() const;

    /// The whole line as typed, for reports of bugs and for the log header.
    const std::string& text() const { return text_; }

    const Application& application() const { return *application_; }

private:
    const Application* application_;
    std::map<std::string, std::string, std::less<>> options_;
    std::vector<std::string> positional_;
    std::string text_;
};

/// What -<listing> prints: "word    summary", a line each.
std::string listingText(const Listing& listing);

/// Help text of a program: usage, options, listings, examples.
std::string helpText(const Application& application);

} // namespace isph
