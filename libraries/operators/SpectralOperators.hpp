#pragma once

#include "operators/DerivativeSymbol.hpp"
#include "operators/Operators.hpp"

namespace isph
{

/// Operators of a kernel as convolutions: transform, multiply by the symbol, transform back.
class SpectralOperators : public Operators
{
public:
    /// \param laplacian table of laplacianSymbol; may be empty where no Laplacian is asked for
    SpectralOperators(const Lattice& lattice, DerivativeSymbol derivative, AlignedVector<double> laplacian);

    void gradient(const RealField& f, int component, RealField& gradient) override;
    void divergence(const RealField& u, RealField& divergence) override;
    void laplacian(const RealField& f, RealField& laplacian) override;

    /// Curl of a velocity: one component in two dimensions, three in three.
    void curl(const RealField& u, RealField& vorticity);

private:
    void forward(std::span<const double> values, SpectralField& modes);
    void backward(std::span<double> values);
    /// scratch (+)= sign i d_axis modes.
    void addDerivative(const SpectralField& modes, int axis, double sign, bool add);

    DerivativeSymbol derivative_;
    AlignedVector<double> laplacian_;
    FourierTransform transform_;
    RealField real_;
    SpectralField scratch_;
    std::array<SpectralField, 3> modes_;
    std::array<std::vector<double>, 3> d_;
};

} // namespace isph
