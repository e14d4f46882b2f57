#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// What a program reports to its user. Results and reports go to standard output, or to standard error when the data
/// themselves are piped (-stdout); -quiet silences reports but not warnings.
class Log
{
public:
    enum class Report { standardOutput, standardError, none };

    explicit Log(Report report = Report::standardOutput);

    /// One line of report.
    void line(std::string_view text = "");

    /// A warning, at once to standard error; the same text is printed only the first time, and counted.
    void warning(const std::string& text);

    /// "2 warnings, one of them repeated 14 times" with their first lines; nothing when there were none.
    void closingSummary();

    /// Whether reports are shown at all, and whether they go to a terminal (so that a progress line makes sense).
    bool shown() const { return report_ != Report::none; }
    bool onTerminal() const;

    /// The stream that reports go to (a null stream when there are none).
    std::ostream& stream();

private:
    Report report_;
    struct Warning { std::string text; long count; };
    std::vector<Warning> warnings_;
};

} // namespace isph
