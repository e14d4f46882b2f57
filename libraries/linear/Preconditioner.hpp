#pragma once

#include "fields/AlignedAllocator.hpp"

#include <span>

namespace isph
{

/// An approximate inverse of an operator.
class Preconditioner
{
public:
    virtual ~Preconditioner() = default;

    /// z = M^-1 r. \param z none of r; overwritten
    virtual void apply(std::span<const double> r, std::span<double> z) const = 0;
};

/// None: z = r.
class IdentityPreconditioner : public Preconditioner
{
public:
    void apply(std::span<const double> r, std::span<double> z) const override;
};

/// The inverse of the diagonal. Entries that are zero or not finite count as one.
class JacobiPreconditioner : public Preconditioner
{
public:
    explicit JacobiPreconditioner(AlignedVector<double> diagonal);

    void apply(std::span<const double> r, std::span<double> z) const override;

private:
    AlignedVector<double> inverse_;
};

} // namespace isph
