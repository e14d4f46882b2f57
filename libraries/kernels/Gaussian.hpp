#pragma once

#include "kernels/Kernel.hpp"

namespace isph
{

/// Gaussian of any even order 2n: w = pi^(-d/2) L_{n-1}^{(d/2)}(q^2) exp(-q^2), with the generalised Laguerre
/// polynomial (G4 of Lind & Stansby 2016 is n = 2; the polynomials printed by Lin et al. 2026 are its 2-D members, one
/// misprinted). Its Fourier transform is Q(n, s) = exp(-s) sum_{m<n} s^m/m!, in any dimension.
class Gaussian : public Kernel
{
public:
    static constexpr int largestOrder = 200;

    /// \throws Error(input) without origin unless the order is even and 2 ... largestOrder.
    explicit Gaussian(int order);

    int order() const override { return 2 * n_; }
    double w(double q, int dimensions) const override;
    double f(double q, int dimensions) const override;
    double g(double q, int dimensions) const override;
    double supportRadius() const override;
    bool closed() const override { return true; }
    double symbol(double s) const override;
    double morrisSymbol(double s) const override;

    /// Largest value of 2 sqrt(s) Q(n, s): the first derivative's symbol never exceeds this over h.
    double largestDerivative() const;

private:
    int n_; ///< half the order
};

/// Regularised incomplete gamma functions of integer order: Q(n, s) = exp(-s) sum_{m<n} s^m/m!, P = 1 - Q without the
/// cancellation for small s.
double upperGamma(int n, double s);
double lowerGamma(int n, double s);

} // namespace isph
