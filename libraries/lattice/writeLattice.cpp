#include "lattice/writeLattice.hpp"

#include "core/Error.hpp"
#include "lattice/readLattice.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace isph
{

void writeLattice(const Lattice& lattice, const std::filesystem::path& file)
{
    const std::filesystem::path temporary = file.string() + ".writing" + std::to_string(getpid());
    std::error_code failure;
    std::filesystem::create_directories(file.parent_path(), failure);
    if (!failure)
    {
        errno = 0;
        std::ofstream stream(temporary, std::ios::binary);
        stream << latticeText(lattice);
        stream.close();
        if (stream) { std::filesystem::rename(temporary, file, failure); }
        else { failure = std::error_code(errno != 0 ? errno : EIO, std::generic_category()); }
    }
    if (failure)
    {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw Error(Fault::input, {file.string(), 0, ""}, "cannot be written: " + failure.message());
    }
}

} // namespace isph
