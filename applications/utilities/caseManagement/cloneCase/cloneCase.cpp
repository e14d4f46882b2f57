// cloneCase: a new case from an old one, without its results.
//
//     cloneCase cavity cavityFine               0, constant, system, scripts and tables
//     cloneCase cavity cavityOn -latestTime     to go on from the latest time instead of 0
//     cloneCase cavity cavityFine -overwrite    replaces the case that is there

#include "case/AtomicFolder.hpp"
#include "case/Case.hpp"
#include "case/TimeDirectories.hpp"
#include "core/FileDescriptor.hpp"
#include "core/runApplication.hpp"

#include <algorithm>
#include <fmt/format.h>

using namespace isph;
namespace fs = std::filesystem;

/// Whether a path is a folder or lies in it; both need not exist.
static bool isWithin(const fs::path& path, const fs::path& folder)
{
    const fs::path inner = fs::weakly_canonical(fs::absolute(path));
    const fs::path outer = fs::weakly_canonical(fs::absolute(folder));
    return std::ranges::mismatch(outer, inner).in1 == outer.end();
}

/// What a clone is made of: the case's input, the files beside it (scripts, tables, README), and one time folder.
static std::vector<fs::path> partsOf(const Case& source, bool latestTime)
{
    std::vector<fs::path> parts;
    for (const char* folder : {"0.orig", "constant", "system", "validation"})
    {
        if (source.has(folder)) { parts.emplace_back(folder); }
    }
    const std::vector<TimeDirectory> times = timeDirectories(source.directory());
    if (latestTime && !times.empty()) { parts.emplace_back(times.back().name); }
    else if (const auto zero = findTime(times, 0)) { parts.emplace_back(zero->name); }

    for (const fs::directory_entry& entry : fs::directory_iterator(source.directory()))
    {
        const fs::path name = entry.path().filename();
        const bool result = name.string().starts_with('.') || name.string().starts_with("log.");
        if (entry.is_regular_file() && !result) { parts.push_back(name); }
    }
    std::ranges::sort(parts);
    return parts;
}

static void refuseBadTarget(const Case& source, const fs::path& target, const std::vector<fs::path>& parts,
                            bool overwrite)
{
    const Origin origin{target.string(), 0, ""};
    if (isWithin(source.directory(), target))
    {
        throw Error(Fault::input, origin, "holds the case itself: a case cannot be cloned onto itself",
                    "choose another target");
    }
    for (const fs::path& part : parts)
    {
        if (isWithin(target, source.directory() / part))
        {
            throw Error(Fault::input, origin, fmt::format("lies in {}, which is to be copied", part.string()),
                        "choose a target outside of the case's own folders");
        }
    }
    if (!fs::exists(fs::symlink_status(target))) { return; }
    if (!overwrite) { throw Error(Fault::input, origin, "is there already", "cloneCase -overwrite replaces it"); }
    if (!fs::is_directory(target / "system") && !fs::is_directory(target / "constant"))
    {
        throw Error(Fault::input, origin, "is no case, and -overwrite replaces cases only", "remove it yourself");
    }
}

static void copyPart(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::copy_symlinks, error);
    if (error) { throwRefused(from, "could not be copied", error.value()); }
}

static void run(const CommandLine& line, Log& log)
{
    std::vector<std::string> names = line.positional();
    if (line.has("case")) { names.insert(names.begin(), line.caseDirectory().string()); }
    if (names.size() != 2)
    {
        throw Error(Fault::usage, "needs a case and the name of the new one", "write cloneCase SOURCE TARGET");
    }

    const Case source(names[0]);
    const fs::path target(names[1]);
    const std::vector<fs::path> parts = partsOf(source, line.has("latestTime"));
    refuseBadTarget(source, target, parts, line.has("overwrite"));

    AtomicFolder clone(target);
    for (const fs::path& part : parts) { copyPart(source.directory() / part, clone.path() / part); }
    clone.commit();
    log.line(fmt::format("Cloned {} to {}", source.directory().string(), target.string()));
}

int main(int argc, char** argv)
{
    const Application application{.name = "cloneCase",
                                  .summary =
                                      "copies a case without its results: 0, constant, system, scripts and tables",
                                  .examples = "cloneCase cavity cavityFine\ncloneCase cavity cavityOn -latestTime",
                                  .options = {{"latestTime", "", "take the latest time instead of 0"},
                                              {"overwrite", "", "replace a case that is there"}},
                                  .positional = "SOURCE TARGET",
                                  .banner = false};
    return runApplication(application, argc, argv, run);
}
