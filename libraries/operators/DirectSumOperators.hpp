#pragma once

#include "lattice/Lattice.hpp"
#include "operators/KernelSamples.hpp"
#include "operators/Operators.hpp"

namespace isph
{

/// The classical reference: sums over the neighbours of every point of a periodic lattice. Costs points x neighbours;
/// agrees with the convolution of the same samples in Fourier space to round-off.
class DirectSumOperators : public Operators
{
public:
    DirectSumOperators(const Lattice& lattice, KernelSamples samples);

    void gradient(const RealField& f, int component, RealField& gradient) override;
    void divergence(const RealField& u, RealField& divergence) override;
    void laplacian(const RealField& f, RealField& laplacian) override;

    std::size_t neighbours() const { return samples_.offsets.size(); }

private:
    /// result(a) (+)= sum over b of weights[b] f(a + offset b).
    void sum(std::span<const double> f, const std::vector<double>& weights, std::span<double> result) const;

    std::array<int, 3> counts_{1, 1, 1}; ///< of the active axes, fastest first
    KernelSamples samples_;
};

} // namespace isph
