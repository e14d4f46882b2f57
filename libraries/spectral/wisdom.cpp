#include "spectral/wisdom.hpp"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fftw3.h>
#include <string>
#include <sys/file.h>
#include <unistd.h>

namespace isph
{

namespace
{

/// A lock on a file that ends with the scope, or with the process.
class FileLock
{
public:
    explicit FileLock(const std::filesystem::path& file)
        : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644))
    {
        if (descriptor_ >= 0) { ::flock(descriptor_, LOCK_EX); }
    }
    ~FileLock()
    {
        if (descriptor_ >= 0) { ::close(descriptor_); }
    }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    bool held() const { return descriptor_ >= 0; }

private:
    int descriptor_;
};

} // namespace

std::filesystem::path wisdomFile()
{
    std::filesystem::path cache;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg != '\0') { cache = xdg; }
    else if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    {
        cache = std::filesystem::path(home) / ".cache";
    }
    return cache.empty() ? cache : cache / "continua" / ("wisdom-" + std::string(fftw_version));
}

bool withWisdom(const std::function<void()>& planner)
{
    const std::filesystem::path file = wisdomFile();
    std::error_code refused;
    if (!file.empty()) { std::filesystem::create_directories(file.parent_path(), refused); }
    if (file.empty() || refused) { return false; }

    const FileLock lock(file.string() + ".lock");
    if (!lock.held()) { return false; }

    fftw_import_wisdom_from_filename(file.c_str());
    planner();

    const std::string temporary = file.string() + ".new-" + std::to_string(::getpid());
    const bool exported = fftw_export_wisdom_to_filename(temporary.c_str()) != 0;
    // Estimated plans would make use of what is remembered, and then depend on what was measured before.
    fftw_forget_wisdom();
    if (!exported) { return false; }
    std::filesystem::rename(temporary, file, refused);
    return !refused;
}

} // namespace isph
