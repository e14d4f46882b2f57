#pragma once

#include "continuation/continuedField.hpp"
#include "continuation/LineEigenbasis.hpp"
#include "kernels/KernelSettings.hpp"
#include "poisson/BoundedPoisson.hpp"

#include <optional>
#include <vector>

namespace isph
{

/// The second derivative along an active axis that ContinuedHelmholtz inverts.
struct ContinuedAxis
{
    std::optional<LineContinuation> continuation = std::nullopt; ///< none: periodic
    LineSymbol symbol{};                                         ///< on the extended lines
    LineEnd low = LineEnd::value;
    LineEnd high = LineEnd::value;
    double dataScale = 1; ///< of the data at free ends, which are those of the continuation
};

/// The axes of a lattice as ContinuedOperators differentiates along them: neumann ends are slopes, dirichlet ends
/// values. \param ends by direction \throws std::logic_error if ends and axes contradict each other; Error(input)
/// without origin for staggered axes and for those with too few points
std::vector<ContinuedAxis> continuedAxes(const Lattice& lattice, const Continuations& continuations,
                                         const KernelSettings& kernel, const std::array<AxisEnds, 3>& ends);

/// Solves alpha u - beta lap u = f where lap is the Laplacian of ContinuedOperators itself: to round-off at every point
/// that is unknown, the data of the walls to round-off on them. For implicit viscous terms (any alpha >= 0, beta >= 0
/// from call to call) and as an exact pressure solver (alpha = 0, beta = -1).
///
/// Each bounded axis is diagonalised once (LineEigenbasis); a solve takes two dense products an axis, real Fourier
/// transforms along periodic ones, and no memory. Where values and slopes meet at an edge, the values are written
/// there; of values or slopes alone, those of the last direction.
///
/// Fourth order with degree 4 for smooth data, Neumann ends included; where the lattice does not resolve f, the slopes
/// at the walls amplify what it misses: BoundedPoisson is the robust pressure solver.
class ContinuedHelmholtz
{
public:
    /// \param axes of the active directions, in order
    /// \throws Error(input) without origin where a second derivative has no basis of real eigenvectors
    ContinuedHelmholtz(const Lattice& lattice, const std::vector<ContinuedAxis>& axes,
                       PlanEffort effort = PlanEffort::estimated);

    /// \param alpha, beta not both zero, and not of opposite signs
    /// \param f used at the unknown points only; may be u itself
    /// \return with alpha = 0 and no value given anywhere, by how much f exceeds what flows through the walls, which no
    /// u can balance and which is taken from f; the mean of u (half weight on walls) is then 0. Otherwise 0.
    double solve(double alpha, double beta, std::span<const double> f, const WallData& walls, std::span<double> u);

    /// The largest condition of the eigenvectors of an axis, the power of which by dimensions bounds round-off.
    double condition() const;

private:
    struct Direction
    {
        std::size_t d;
        LineLayout layout;
        std::optional<LineEigenbasis> basis; ///< bounded axes
        std::optional<RealTransform> fourier;
        LineEnd low;
        LineEnd high;
    };

    void divide(double alpha, double beta, std::span<double> modes) const;
    void fillWalls(const WallData& walls, std::span<double> u) const;
    void subtractMean(std::span<double> u) const;
    std::size_t offset(std::size_t j, std::size_t k) const { return extents_[0] * (j + extents_[1] * k); }

    // By direction; of an axis left out one point, with eigenvalue 0.
    std::array<std::size_t, 3> extents_;
    std::array<std::size_t, 3> first_{0, 0, 0};
    std::array<std::size_t, 3> end_{1, 1, 1};          ///< unknown points
    std::array<AlignedVector<double>, 3> eigenvalues_; ///< by point
    std::array<std::vector<double>, 3> weights_;       ///< of the mean, by point

    std::vector<Direction> directions_;
    double scale_ = 1;
    bool constantMode_ = true;
};

} // namespace isph
