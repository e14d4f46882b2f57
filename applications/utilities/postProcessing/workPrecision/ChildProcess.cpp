#include "ChildProcess.hpp"

#include "core/Error.hpp"
#include "core/FileDescriptor.hpp"
#include "core/signals.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isph
{

namespace fs = std::filesystem;

extern "C" char** environ;

namespace
{

std::vector<std::string> environmentWith(const std::vector<std::pair<std::string, std::string>>& added)
{
    std::vector<std::string> result;
    for (char** entry = environ; *entry != nullptr; ++entry)
    {
        const std::string text(*entry);
        const std::string name = text.substr(0, text.find('='));
        const auto named = [&name](const auto& pair) { return pair.first == name; };
        if (std::ranges::none_of(added, named)) { result.push_back(text); }
    }
    for (const auto& [name, value] : added) { result.push_back(fmt::format("{}={}", name, value)); }
    return result;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts)
{
    std::vector<char*> pointers;
    for (std::string& text : texts) { pointers.push_back(text.data()); }
    pointers.push_back(nullptr);
    return pointers;
}

/// What the child does between fork and exec: nothing but system calls.
[[noreturn]] void become(char* const* words, char* const* environment, const char* folder, int log, int inherited,
                         pid_t parent)
{
    setpgid(0, 0); // so that a signal reaches what the program itself starts
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) { _exit(127); } // it died before the line above
    const int nothing = open("/dev/null", O_RDONLY);
    const bool ready = chdir(folder) == 0 && dup2(nothing, 0) == 0 && dup2(log, 1) == 1 && dup2(log, 2) == 2 &&
                       (inherited < 0 || fcntl(inherited, F_SETFD, 0) == 0);
    if (ready) { execve(words[0], words, environment); }
    _exit(127);
}

} // namespace

ChildProcess::ChildProcess(const Command& command)
{
    const FileDescriptor log(command.log, O_WRONLY | O_CREAT | O_APPEND);
    std::vector<std::string> words = command.words;
    std::vector<std::string> environment = environmentWith(command.environment);
    const std::vector<char*> wordPointers = pointersTo(words);
    const std::vector<char*> environmentPointers = pointersTo(environment);
    const pid_t parent = getpid();
    std::fflush(nullptr);
    // Whoever started this process may ignore it; then children would leave no exit code behind.
    std::signal(SIGCHLD, SIG_DFL);
    pid_ = fork();
    if (pid_ < 0) { throwRefused(command.words[0], "could not be started", errno); }
    if (pid_ == 0)
    {
        become(wordPointers.data(), environmentPointers.data(), command.folder.c_str(), log.number(), command.inherited,
               parent);
    }
    setpgid(pid_, pid_); // whoever comes first
}

ChildProcess::~ChildProcess()
{
    if (ended_) { return; }
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
}

bool ChildProcess::ended()
{
    if (ended_) { return true; }
    int status = 0;
    rusage usage = {};
    const pid_t waited = wait4(pid_, &status, WNOHANG, &usage);
    if (waited == 0 || (waited < 0 && errno == EINTR)) { return false; }
    const auto seconds = [](const timeval& time)
    { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
    wallTime_ = wallTime();
    ended_ = true;
    exitCode_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    cpuTime_ = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    peakMemory_ = usage.ru_maxrss * 1024; // Linux counts in kilobytes
    return true;
}

void ChildProcess::wait()
{
    while (!ended())
    {
        if (caughtSignal() != 0) { throw StoppedBySignal{caughtSignal()}; }
        usleep(1000);
    }
}

void ChildProcess::signal(int number) const
{
    if (!ended_) { kill(-pid_, number); }
}

double ChildProcess::wallTime() const
{
    return ended_ ? wallTime_ : std::chrono::duration<double>(Clock::now() - start_).count();
}

fs::path programFolder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

std::string searchPath()
{
    const char* path = std::getenv("PATH");
    return fmt::format("{}:{}", programFolder().string(), path == nullptr ? "/usr/bin:/bin" : path);
}

fs::path findProgram(const std::string& name)
{
    const std::string path = searchPath();
    for (std::size_t begin = 0; begin <= path.size();)
    {
        const std::size_t end = std::min(path.find(':', begin), path.size());
        const fs::path candidate = fs::path(path.substr(begin, end - begin)) / name;
        std::error_code ignored;
        if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0) { return candidate; }
        begin = end + 1;
    }
    return {};
}

std::string outputOf(const std::string& command, const fs::path& folder)
{
    const fs::path log = folder / "log.quantity";
    fs::remove(log);
    // What the command says on standard error is for people, not a number.
    const std::string said = (folder / "log.quantity.error").string();
    ChildProcess child({.words = {"/bin/sh", "-c", fmt::format("{{ {}\n}} 2> log.quantity.error", command)},
                        .folder = folder,
                        .log = log,
                        .environment = {{"PATH", searchPath()}},
                        .inherited = -1});
    child.wait();
    const auto contentOf = [](const fs::path& file)
    {
        std::string text;
        std::array<char, 4096> buffer{};
        const FileDescriptor stream(file, O_RDONLY);
        for (ssize_t got = 0; (got = read(stream.number(), buffer.data(), buffer.size())) > 0;)
        {
            text.append(buffer.data(), static_cast<std::size_t>(got));
        }
        return text;
    };
    if (child.exitCode() != 0)
    {
        throw Error(Fault::input, {folder.string(), 0, ""},
                    fmt::format("'{}' failed with exit code {}", command, child.exitCode()),
                    fs::exists(said) ? contentOf(said) : "");
    }
    return contentOf(log);
}

} // namespace isph
