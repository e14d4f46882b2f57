#pragma once

#include "continuation/continuedField.hpp"
#include "continuation/ContinuedTransform.hpp"
#include "kernels/KernelSettings.hpp"
#include "operators/LaplacianForm.hpp"
#include "spectral/FourierTransform.hpp"

#include <vector>

namespace isph
{

/// Derivatives on a lattice with bounded axes as Lin et al. 2026 take them: a field is continued along every bounded
/// axis and transformed as a whole. They are those of ContinuedDerivative along each axis, at more cost and with more
/// round-off, for the corners of the extended box are continued twice (docs/theory/walls.md).
class ExtendedOperators
{
public:
    /// What is known at the low and high end, by direction.
    using Ends = std::array<std::array<EndCondition, 2>, 3>;

    /// \throws Error(input) without origin where an axis has too few points for its continuation or the kernel.
    ExtendedOperators(const Lattice& lattice, const Continuations& continuations, const Ends& ends,
                      const KernelSettings& kernel, LaplacianForm laplacian = LaplacianForm::secondDerivative,
                      PlanEffort effort = PlanEffort::estimated);

    /// Continues one component of a field and transforms it: the derivatives below are its own, until the next one.
    /// \param data by direction; outward derivatives times the spacing
    void take(std::span<const double> values, const std::array<EndData, 3>& data = {});

    /// The derivative along the d-th active axis, overwritten.
    void derivative(int d, std::span<double> slope);

    /// rate += -carrier df + nu d2f along the d-th active axis. An empty carrier, or nu = 0, leaves its term out.
    void addTransport(int d, std::span<const double> carrier, double nu, std::span<double> rate);

private:
    /// One bounded direction, its lines continued in the other directions as far as those before it are.
    struct Pass
    {
        std::size_t direction;
        LineLayout before;
        LineLayout after;
        LineContinuation continuation;
        std::size_t across;                     ///< lines side by side in the faster one of the other directions
        std::array<std::size_t, 2> linesOfData; ///< of the field itself, in the faster and the slower one
        RealField lines;                        ///< a batch of them
        RealField values;                       ///< what it has continued
    };
    /// Symbols along an active axis, at every index of the modes, over the number of points.
    struct Symbol
    {
        std::vector<double> first;
        std::vector<double> second;
    };

    static void extend(Pass& pass, std::span<const double> values, const EndData& data);
    void multiplyFirst(int d);
    void multiplySecond(int d);
    /// Calls visit(m, first mode of a run, modes in it): runs of modes of one index m along an active axis.
    template<class Visit>
    void forEachRun(int d, Visit visit) const;
    /// Transforms back and calls visit(point, value) for the points of the lattice itself.
    template<class Visit>
    void backward(Visit visit);

    std::array<std::size_t, 3> counts_{};
    std::array<std::size_t, 3> extendedCounts_{};
    std::vector<Pass> passes_;
    std::array<std::size_t, 3> modeExtents_{};
    std::array<Symbol, 3> symbols_;
    FourierTransform transform_;
    SpectralField modes_;
    SpectralField product_;
    RealField result_;
};

} // namespace isph
