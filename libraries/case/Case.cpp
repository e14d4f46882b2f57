#include "case/Case.hpp"

#include <fmt/format.h>

namespace isph
{

namespace
{

std::string adviceOnMissing(const std::string& relative)
{
    if (relative == "constant/lattice") { return "makeLattice writes it from system/latticeDict"; }
    if (relative.starts_with("system/") || relative.starts_with("constant/"))
    {
        return fmt::format("write it; etc/annotated/{} shows every entry",
                           std::filesystem::path(relative).filename().string());
    }
    if (relative.starts_with("0/")) { return "write the initial field there"; }
    return "";
}

} // namespace

Case::Case(const std::filesystem::path& directory) : directory_(directory)
{
    std::error_code ignored;
    const Origin origin{directory.string(), 0, ""};
    if (!std::filesystem::is_directory(directory, ignored))
    {
        throw Error(Fault::input, origin, "there is no such case directory", "choose one with -case DIR");
    }
    if (!std::filesystem::is_directory(directory / "system", ignored) &&
        !std::filesystem::is_directory(directory / "constant", ignored))
    {
        throw Error(Fault::input, origin, "is not a case: it has neither system/ nor constant/",
                    "choose a case with -case DIR, or make one with cloneCase");
    }
}

std::string Case::name() const
{
    std::error_code ignored;
    const std::filesystem::path absolute = std::filesystem::canonical(directory_, ignored);
    return (absolute.empty() ? directory_ : absolute).filename().string();
}

Dictionary Case::dictionary(const std::string& relative) const
{
    if (!has(relative)) { throw Error(Fault::input, {relative, 0, ""}, "is missing", adviceOnMissing(relative)); }
    return Dictionary::read(path(relative), relative);
}

bool Case::has(const std::string& relative) const
{
    std::error_code ignored;
    return std::filesystem::exists(path(relative), ignored);
}

} // namespace isph
