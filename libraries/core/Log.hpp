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
    enum class Report
    {
        standardOutput,
        standardError,
        none
    };

    /// \param program prefix of warnings ("makeLattice: warning: ..."); may be empty
    explicit Log(Report report = Report::standardOutput, std::string program = "");
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;
    ~Log();

    /// One line of report, flushed: what a killed program said before is on the screen or in the file.
    void line(std::string_view text = "");

    /// A line that the next one (of any kind) replaces, e.g. of progress; only on a terminal, else nothing.
    /// An empty text takes it away.
    void status(std::string_view text);

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
    struct Warning
    {
        std::string text;
        long count;
    };

    Report report_;
    std::string program_;
    std::ostream null_{nullptr};
    bool statusShown_ = false;
    std::vector<Warning> warnings_;
};

} // namespace isph
