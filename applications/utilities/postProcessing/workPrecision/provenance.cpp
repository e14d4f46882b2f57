#include "provenance.hpp"

#include "ChildProcess.hpp"
#include "core/Json.hpp"
#include "core/version.hpp"
#include "core/writeTextFile.hpp"

#include <array>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

namespace isph
{

namespace
{

std::string processor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
    {
        if (line.starts_with("model name")) { return line.substr(std::min(line.find(": ") + 2, line.size())); }
    }
    return "unknown";
}

/// The commit of the sources that the programs were built from, if they are still there and git knows them; "-dirty"
/// where they have changed since. Pages of results are written from several runs, so docs do not count.
std::string commit()
{
    const std::filesystem::path sources = std::filesystem::path(sourceEtc).parent_path();
    if (findProgram("git").empty() || !std::filesystem::exists(sources / ".git")) { return "unknown"; }
    std::error_code ignored;
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path(ignored) / fmt::format("workPrecision-{}", getpid());
    std::string said;
    try
    {
        std::filesystem::create_directories(folder);
        const std::string git = fmt::format("git -C '{}'", sources.string());
        said = outputOf(git + " describe --always", folder);
        said = said.substr(0, said.find_last_not_of(" \n") + 1);
        if (!outputOf(git + " status --porcelain --untracked-files=no -- . ':(exclude)docs'", folder).empty())
        {
            said += "-dirty";
        }
    }
    catch (const std::exception&)
    {
        said.clear();
    }
    std::filesystem::remove_all(folder, ignored);
    return said.empty() ? "unknown" : said;
}

std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
    return text.data();
}

std::string compiler()
{
#if defined(__clang__)
    return fmt::format("clang {}", __clang_version__);
#else
    return fmt::format("gcc {}", __VERSION__);
#endif
}

} // namespace

void writeProvenance(const Sweep& sweep, const std::string& command, const std::filesystem::path& file)
{
    writeTextFile(file, Json::object({{"title", sweep.title},
                                      {"version", version},
                                      {"commit", commit()},
                                      {"compiler", compiler()},
                                      {"processor", processor()},
                                      {"cores", sysconf(_SC_NPROCESSORS_ONLN)},
                                      {"threads", sweep.threads},
                                      {"jobs", sweep.jobs},
                                      {"repetitions", sweep.repetitions},
                                      {"reduced", sweep.reduced},
                                      {"date", today()},
                                      {"command", command}})
                            .text());
}

} // namespace isph
