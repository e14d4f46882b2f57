#pragma once

#include "fields/Field.hpp"

namespace isph
{

/// SPH operators on whole fields in physical space. Outputs come last and are overwritten.
class Operators
{
public:
    virtual ~Operators() = default;

    /// Derivatives of one component of f, one component of gradient for each active axis.
    virtual void gradient(const RealField& f, int component, RealField& gradient) = 0;

    /// Divergence of the field whose components follow the active axes.
    virtual void divergence(const RealField& u, RealField& divergence) = 0;

    /// Laplacian of every component.
    virtual void laplacian(const RealField& f, RealField& laplacian) = 0;
};

} // namespace isph
