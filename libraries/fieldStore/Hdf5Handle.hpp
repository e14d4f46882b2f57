#pragma once

#include "core/Origin.hpp"

#include <hdf5.h>

#include <string>

#include <utility>
#include <vector>

namespace isph
{

/// Owns an identifier of the HDF5 library and gives it back with the function that its kind needs.
class Hdf5Handle
{
public:
    using Close = herr_t (*)(hid_t);

    Hdf5Handle() = default;
    Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept
    {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    ~Hdf5Handle()
    {
        if (valid()) { close_(id_); }
    }

    bool valid() const { return id_ >= 0; }
    operator hid_t() const { return id_; }

private:
    hid_t id_ = H5I_INVALID_HID;
    Close close_ = nullptr;
};

/// Throws the error of a call that just failed: the problem ("cannot be read") and what the library says of it. To be
/// called before any other handle closes, which would make the library forget.
[[noreturn]] void throwHdf5Error(const Origin& origin, const std::string& problem);

/// The result of a call, which is an identifier or a status. \throws Error(input) at origin if the call failed.
template<class Result>
Result checked(Result result, const Origin& origin, const char* problem)
{
    if (result < 0) { throwHdf5Error(origin, problem); }
    return result;
}

/// Extents of a dataspace.
std::vector<hsize_t> extentsOf(hid_t space);

/// Selects rows first ... first + count - 1 of the slowest dimension; returns the extents of the selection.
std::vector<hsize_t> selectRows(hid_t space, hsize_t first, hsize_t count);

/// From now on the library prints nothing.
inline void silenceHdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

} // namespace isph
