#include "core/runApplication.hpp"

#include "core/Error.hpp"
#include "core/signals.hpp"
#include "core/version.hpp"

#include <array>
#include <csignal>
#include <ctime>
#include <fmt/format.h>
#include <iostream>
#include <new>
#include <optional>
#include <string.h> // sigabbrev_np is glibc's
#include <system_error>
#include <unistd.h>

namespace isph
{

namespace
{

std::string hostName()
{
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

std::string localTime(const char* format)
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    std::array<char, 64> text{};
    std::strftime(text.data(), text.size(), format, &parts);
    return text.data();
}

void printHeader(const CommandLine& line, Log& log)
{
    std::error_code ignored; // a case that is not there is reported by whoever reads it
    const std::filesystem::path directory =
        std::filesystem::weakly_canonical(std::filesystem::absolute(line.caseDirectory(), ignored), ignored);

    log.line("/*---------------------------------------------------------------------------*\\");
    log.line(fmt::format("| Continua {:<67}|", version));
    log.line("\\*---------------------------------------------------------------------------*/");
    log.line(fmt::format("Exec   : {}", line.text()));
    log.line(fmt::format("Date   : {}", localTime("%b %d %Y")));
    log.line(fmt::format("Time   : {}", localTime("%H:%M:%S")));
    log.line(fmt::format("Host   : {}", hostName()));
    log.line(fmt::format("PID    : {}", getpid()));
    log.line(fmt::format("Case   : {}", (ignored ? line.caseDirectory() : directory).string()));
    log.line();
    log.line("// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //");
    log.line();
}

/// Answers -help, -version and -list...; false when none of them was asked for.
bool answered(const CommandLine& line)
{
    const Application& application = line.application();
    if (line.has("help"))
    {
        std::cout << helpText(application);
        return true;
    }
    if (line.has("version"))
    {
        std::cout << fmt::format("{} (Continua) {}\n", application.name, version);
        return true;
    }
    bool any = false;
    for (const Listing& listing : application.listings)
    {
        if (!line.has(listing.option)) { continue; }
        std::cout << listingText(listing);
        any = true;
    }
    return any;
}

Log::Report reportOf(const CommandLine& line)
{
    if (line.has("quiet")) { return Log::Report::none; }
    return line.has("stdout") ? Log::Report::standardError : Log::Report::standardOutput;
}

void print(std::string_view program, const std::vector<Complaint>& complaints)
{
    for (const Complaint& complaint : complaints)
    {
        const std::string where = toString(complaint.origin);
        std::cerr << program << ": " << where << (where.empty() ? "" : ": ") << complaint.what << '\n';
        if (!complaint.advice.empty()) { std::cerr << "    " << complaint.advice << '\n'; }
    }
}

void printBug(std::string_view program, const std::string& commandLine, std::string_view what)
{
    std::cerr << program << ": internal error: " << what << '\n'
              << "    This is a bug of ours, not of yours: please report it with these lines and the case.\n"
              << "    version: " << version << '\n'
              << "    command: " << commandLine << '\n';
}

/// Runs what may throw, prints what was thrown, and says which exit code that means.
template<class Work>
int guarded(const Application& application, const std::string& commandLine, const Work& work)
{
    const std::string_view program = application.name;
    try
    {
        work();
        return 0;
    }
    catch (const Error& error)
    {
        print(program, error.complaints());
        return static_cast<int>(error.fault());
    }
    catch (const StoppedBySignal& stop)
    {
        const char* name = sigabbrev_np(stop.signal);
        std::cerr << fmt::format("{}: stopped by SIG{}\n", program, name == nullptr ? "?" : name);
        return 128 + stop.signal;
    }
    catch (const std::bad_alloc&)
    {
        print(program, {{{}, "memory was refused by the machine", "use fewer lattice points, or a larger machine"}});
    }
    catch (const std::filesystem::filesystem_error& error)
    {
        print(program, {{{error.path1().string(), 0, ""}, error.code().message(), ""}});
    }
    catch (const std::exception& error)
    {
        printBug(program, commandLine, error.what());
    }
    catch (...)
    {
        printBug(program, commandLine, "something was thrown that is no exception");
    }
    return 1;
}

/// The exit code, if all that was written to standard output arrived there.
int finished(const Application& application, int code)
{
    std::cout.flush();
    if (code != 0 || std::cout) { return code; }
    print(application.name, {{{}, "standard output could not be written: the report is incomplete", ""}});
    return static_cast<int>(Fault::input);
}

} // namespace

int runApplication(const Application& application, int argc, char** argv, void (*run)(const CommandLine&, Log&))
{
    // A file that grows beyond a limit of the machine is an error like a full disk, not the end of the program.
    std::signal(SIGXFSZ, SIG_IGN);
    std::optional<CommandLine> line;
    bool done = false;
    const std::string typed(application.name);
    int code = guarded(application, typed,
                       [&]
                       {
                           line.emplace(application, std::vector<std::string>(argv + 1, argv + argc));
                           done = answered(*line);
                       });
    if (code != 0 || done) { return finished(application, code); }

    Log log(reportOf(*line), std::string(application.name));
    if (application.banner) { printHeader(*line, log); }
    code = guarded(application, line->text(), [&] { run(*line, log); });
    log.closingSummary();
    if (code == 0 && application.banner) { log.line("End\n"); }
    return finished(application, code);
}

} // namespace isph
