#pragma once

#include <cstddef>
#include <span>

namespace isph
{

/// What a Krylov solver knows of a linear system: it can be applied to a field.
class LinearOperator
{
public:
    virtual ~LinearOperator() = default;

    virtual std::size_t rows() const = 0;
    virtual std::size_t columns() const = 0;

    /// y = A x. \param x columns() values \param y rows() values, none of x; overwritten
    virtual void apply(std::span<const double> x, std::span<double> y) const = 0;
};

} // namespace isph
