#pragma once

#include "fields/AlignedAllocator.hpp"

#include <cassert>
#include <complex>
#include <cstddef>
#include <span>

namespace isph
{

/// Values at points, structure of arrays: each component is one contiguous array, aligned to 64 bytes, x fastest.
///
/// All components lie in one block, a stride apart, so that a batched transform can take them in one call. Fields
/// move, but copy only by saying so (copyOf): a silent copy is a performance bug.
template<class Value>
class Field
{
public:
    Field() = default;

    /// components arrays of size values, all zero.
    Field(int components, std::size_t size)
        : components_(components),
          size_(size),
          stride_(roundedUp(size)),
          values_(static_cast<std::size_t>(components) * stride_)
    {
    }

    Field(Field&&) noexcept = default;
    Field& operator=(Field&&) noexcept = default;

    int components() const { return components_; }
    std::size_t size() const { return size_; }     ///< values per component
    std::size_t stride() const { return stride_; } ///< from one component's first value to the next one's

    std::span<Value> operator[](int component)
    {
        assert(component >= 0 && component < components_);
        return {values_.data() + static_cast<std::size_t>(component) * stride_, size_};
    }
    std::span<const Value> operator[](int component) const
    {
        assert(component >= 0 && component < components_);
        return {values_.data() + static_cast<std::size_t>(component) * stride_, size_};
    }

    Value* data() { return values_.data(); }
    const Value* data() const { return values_.data(); }

    friend Field copyOf(const Field& field)
    {
        Field copy;
        copy.components_ = field.components_;
        copy.size_ = field.size_;
        copy.stride_ = field.stride_;
        copy.values_ = field.values_;
        return copy;
    }

private:
    static std::size_t roundedUp(std::size_t size)
    {
        constexpr std::size_t perLine = 64 / sizeof(Value);
        return (size + perLine - 1) / perLine * perLine;
    }

    int components_ = 0;
    std::size_t size_ = 0;
    std::size_t stride_ = 0;
    AlignedVector<Value> values_;
};

/// Values in physical space; a scalar has one component, a vector as many as the problem has dimensions.
using RealField = Field<double>;

/// Fourier coefficients; another type, so that one cannot be added to the other by accident.
using SpectralField = Field<std::complex<double>>;

} // namespace isph
