#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"
#include "poisson/BoundedAxis.hpp"

#include <array>
#include <memory>
#include <span>

namespace isph
{

/// Values at the points of the two faces of an axis, in storage order; an empty span stands for zeros. Tangential
/// coordinates are those of the lattice, points on edges included; the normal one is that of the wall.
struct FaceValues
{
    std::span<const double> low;
    std::span<const double> high;
};

/// By direction x, y, z: what Neumann ends prescribe, d phi along the axis (not along the outward normal), or Dirichlet
/// ends, phi itself.
using WallData = std::array<FaceValues, 3>;

/// The derivative of phi along a periodic axis, which a solve gives for one transform of the field.
struct PeriodicSlope
{
    int direction;
    std::span<const double> symbol; ///< s of df = i s f, for the modes 0 ... n/2 [rad/m]
    std::span<double> values;       ///< at all points, overwritten
};

/// Solves lap phi = source in a box by real transforms: any mix of periodic, Neumann and Dirichlet ends, points on the
/// walls or staggered, in 2-D and 3-D.
///
/// Wall data enter by harmonic functions whose modes are known in closed form (WallResponse): no transform more than
/// without them, in boxes as in channels. Each axis' data are expanded in the functions of the others; where two faces
/// with given values meet in lattice points, DirichletEdge carries what those functions cannot.
///
/// Accuracy: round-off for modes of the box and for harmonic functions whose wall data are such modes; otherwise order
/// 2, for the series of the source feels the walls. With one bounded axis solveClosed removes the leading error: order
/// 4. Order 1 where two staggered faces with given values that do not vanish meet: no point knows the edge's value.
class BoundedPoisson
{
public:
    /// \param ends by direction; those of axes left out do not matter
    /// \param symbol minus the eigenvalues of the second derivative; exact k^2 unless given
    /// \throws std::logic_error if ends and axes contradict each other; Error(input) if an axis has too few points
    BoundedPoisson(const Lattice& lattice, const std::array<AxisEnds, 3>& ends,
                   PlanEffort effort = PlanEffort::estimated, const AxisSymbol& symbol = exactSymbol);
    ~BoundedPoisson();
    BoundedPoisson(BoundedPoisson&&) noexcept;
    BoundedPoisson& operator=(BoundedPoisson&&) noexcept;

    /// \param slope null, or what to fill beside phi
    ///
    /// Without a Dirichlet end phi is fixed up to a constant: its mean (the transforms', half weight on walls) is 0.
    /// Where faces with values meet, the last direction's are written to the common points.
    /// \return by how much the mean of the source exceeds what flows through the walls, which no phi can balance and
    /// which is taken from the source; 0 with a Dirichlet end
    double solve(const RealField& source, const WallData& walls, RealField& phi, const PeriodicSlope* slope = nullptr);

    /// The same, knowing the source at the walls of the only bounded axis: its derivative along the axis at Neumann
    /// ends, its value at Dirichlet ends.
    double solveClosed(const RealField& source, const WallData& walls, const FaceValues& sourceAtWalls, RealField& phi,
                       const PeriodicSlope* slope = nullptr);

    static double exactSymbol(double k, double /*spacing*/) { return k * k; }

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace isph
