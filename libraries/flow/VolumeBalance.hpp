#pragma once

#include "boundary/FlowBoundary.hpp"
#include "continuation/LineLayout.hpp"
#include "fields/Field.hpp"

#include <span>
#include <vector>

namespace isph
{

/// What flows through every cross-section of a box with an outlet: as much as enters before it, less what leaves by the
/// sides.
///
/// A projection conserves volume to its own accuracy, which is poor where an inlet meets a wall at rest. The rest is
/// taken out by a pressure that varies along the axis of the outlet only: each cross-section gains a uniform velocity
/// at the points that no face prescribes. Then the integrals over inlets and outlets (quadratureWeights) agree to
/// round-off, walls keep their velocity, and what is added falls as the error of the projection does.
///
/// Between two outlets on one axis, the flow is the one for which this pressure vanishes at both. On staggered axes the
/// last cross-section lies half a spacing inside the outlet.
class VolumeBalance
{
public:
    /// \param boundary has an outlet, and must outlive it
    VolumeBalance(const Lattice& lattice, const FlowBoundary& boundary);

    /// Whether a boundary has an outlet.
    static bool concerns(const Lattice& lattice, const FlowBoundary& boundary);

    /// Gives a velocity the flow that the data of the boundary ask for.
    void correct(RealField& u);

    /// The same for the pressure that belongs to a rate of change, whose prescribed part is a sum of factors times data
    /// of different times: begin(), prescribe() for each time, addPressure().
    void begin();
    void prescribe(double factor);

    /// \param rate less the gradient of p; its values at points with prescribed velocities do not matter
    /// \param p [m2/s2], fixed at the outlet: gains what drives the flow that rate lacks
    void addPressure(const RealField& rate, RealField& p);

private:
    /// A point of a cross-section that a face beside it prescribes.
    struct Held
    {
        int direction;
        Side side;
        std::size_t index; ///< in the data of the face
        std::size_t plane;
        double weight;
    };
    /// A point of a face through which something leaves by the sides.
    struct Pore
    {
        int direction;
        Side side;
        std::size_t index;
        std::size_t plane;
        double weight;     ///< signed: outwards
        int component;     ///< of the velocity
        std::size_t point; ///< of the field
        bool open;         ///< nothing is prescribed
    };

    void findSides(int d, Side side, std::vector<bool>& held);
    bool prescribes(Side side) const;
    void addFlow(double factor);
    /// What leaves by the sides before each cross-section.
    void subtractSides(const RealField& u);
    /// Makes lack_ the velocity that each cross-section lacks. \param weights of its points
    void compare(const RealField& u, std::span<const double> weights);
    /// The integral from the first cross-section to each.
    void integrate(std::span<const double> values);

    Lattice lattice_;
    const FlowBoundary& boundary_;
    int d_; ///< the active axis of the outlets
    int direction_;
    LineLayout lines_;
    std::vector<double> faceWeights_; ///< of the points of a cross-section
    std::vector<double> freeWeights_; ///< the same, 0 where prescribed
    double freeArea_ = 0;
    std::vector<double> planeWeights_; ///< of the cross-sections
    std::vector<Held> held_;
    std::vector<Pore> pores_;

    // By cross-section:
    std::vector<double> lack_;
    std::vector<double> sides_;
    std::vector<double> integral_;
};

} // namespace isph
