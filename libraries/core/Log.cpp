#include "core/Log.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace isph
{

Log::Log(Report report, std::string program) : report_(report), program_(std::move(program)) {}

Log::~Log() { status(""); }

std::ostream& Log::stream()
{
    switch (report_)
    {
    case Report::standardOutput:
        return std::cout;
    case Report::standardError:
        return std::cerr;
    case Report::none:
        break;
    }
    return null_;
}

bool Log::onTerminal() const
{
    return shown() && isatty(report_ == Report::standardOutput ? STDOUT_FILENO : STDERR_FILENO) == 1;
}

void Log::line(std::string_view text)
{
    status("");
    stream() << text << '\n' << std::flush;
}

void Log::status(std::string_view text)
{
    if (text.empty() && !statusShown_) { return; }
    if (!onTerminal()) { return; }
    constexpr std::string_view eraseLine = "\r\033[K";
    stream() << eraseLine << text << std::flush;
    statusShown_ = !text.empty();
}

void Log::warning(const std::string& text)
{
    const auto known = std::ranges::find(warnings_, text, &Warning::text);
    if (known != warnings_.end())
    {
        ++known->count;
        return;
    }
    warnings_.push_back({text, 1});
    status("");
    std::cerr << program_ << (program_.empty() ? "" : ": ") << "warning: " << text << '\n' << std::flush;
}

void Log::closingSummary()
{
    if (warnings_.empty()) { return; }
    line(warnings_.size() == 1 ? "1 warning:" : fmt::format("{} warnings:", warnings_.size()));
    for (const Warning& warning : warnings_)
    {
        const std::string first = warning.text.substr(0, warning.text.find('\n'));
        line(warning.count == 1 ? "    " + first : fmt::format("    {} ({} times)", first, warning.count));
    }
}

} // namespace isph
