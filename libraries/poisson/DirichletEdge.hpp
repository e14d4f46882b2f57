#pragma once

#include "poisson/BoundedAxis.hpp"

#include <array>
#include <optional>
#include <span>

namespace isph
{

/// An edge where two faces with given values meet.
///
/// Each face's values are expanded in sines along the other axis, which vanish at the edge. What does not vanish there
/// is first carried by a function linear (at the far end Dirichlet) or constant (Neumann) along both axes: its value at
/// the edge times its modes, which are those of WallResponse for kappa = 0. At a corner of three such faces the edges
/// in turn end in values: what is straight between these is harmonic, and shared by the three edges of the corner.
class DirichletEdge
{
public:
    /// One of the two faces.
    struct Face
    {
        std::size_t d; ///< direction of its axis
        bool high;
        bool onPoints; ///< whether the end is a lattice point, so that the other face's values reach it

        bool operator==(const Face&) const = default;
    };

    /// \param axes the BoundedAxis of each direction, null where there is none
    DirichletEdge(const std::array<int, 3>& counts, const std::array<const BoundedAxis*, 3>& axes, const Face& a,
                  const Face& b, PlanEffort effort);

    /// Takes the values at the edge from those on the faces of a and b, their mean if both reach it. Empty: zeros.
    void read(std::span<const double> ofA, std::span<const double> ofB);

    const std::array<Face, 2>& faces() const { return faces_; }

    /// Subtracts this function, and a half of what it shares, from the modes of one of its two faces.
    void subtractFrom(std::size_t face, std::span<double> faceModes) const;

    /// Adds this function, less what the operator makes of it, to the modes of the box from first to end.
    void addTo(std::span<double> modes, const std::array<std::size_t, 3>& first,
               const std::array<std::size_t, 3>& end) const;

private:
    void addValues(std::size_t face, std::span<const double> values, double weight);

    std::array<std::size_t, 3> extents_;
    std::array<Face, 2> faces_;
    std::size_t along_;                                ///< direction of the edge
    std::array<AlignedVector<double>, 3> tables_;      ///< modes of a unit value across the edge
    std::array<AlignedVector<double>, 2> ofEnds_;      ///< along it, of a unit value at its low and high end, or empty
    std::array<AlignedVector<double>, 3> eigenvalues_; ///< minus those of the operator
    std::optional<RealTransform> transform_;           ///< along the edge, in 3-D
    AlignedVector<double> values_;                     ///< then modes, along the edge
    AlignedVector<double> straight_;                   ///< modes of what is straight between its ends
};

} // namespace isph
