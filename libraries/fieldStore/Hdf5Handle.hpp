#pragma once

#include <hdf5.h>

#include <string>

#include <utility>

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

/// What the library says about its last failure (the innermost message), instead of its stack on standard error.
std::string hdf5Reason();

/// From now on the library prints nothing.
inline void silenceHdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

} // namespace isph
