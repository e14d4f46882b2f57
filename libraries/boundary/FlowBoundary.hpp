#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isph
{

/// What a face does to the velocity.
enum class VelocityCondition
{
    periodic,
    value,  ///< prescribed: noSlip (zero), fixedValue
    slip,   ///< no flow through the face, no shear along it: slip, symmetry
    outflow ///< nothing prescribed: the flow leaves as it comes
};

/// What a face does to the pressure.
enum class PressureCondition
{
    periodic,
    zeroGradient, ///< whatever gradient keeps the prescribed normal velocity
    value,
    gradient ///< outward derivative
};

/// A quantity prescribed along a face, of place and time.
class FaceFunction
{
public:
    virtual ~FaceFunction() = default;

    /// Component (x, y, z; 0 for scalars) at points of one time.
    virtual void evaluate(int component, std::span<const double> x, std::span<const double> y,
                          std::span<const double> z, double t, std::span<double> values) const = 0;
    virtual bool dependsOnTime() const = 0;
};

/// The conditions at one face of the box.
struct FaceCondition
{
    std::string patch;
    VelocityCondition velocity = VelocityCondition::periodic;
    PressureCondition pressure = PressureCondition::periodic;
    std::unique_ptr<const FaceFunction> U; ///< [m/s]; null: at rest
    std::unique_ptr<const FaceFunction> p; ///< kinematic [m2/s2], or its outward derivative; null: zero
};

/// An end of an axis.
enum class Side
{
    low,
    high
};

/// The conditions at the faces of a box and the data they prescribe at one time: at the points on the faces or, on
/// staggered axes, at the feet of the points next to them. Data are in the storage order of the face: of the two
/// directions along it the lower one is fastest.
///
/// Where faces with prescribed velocities meet, the faster one owns the common points (a moving lid owns its corners,
/// an inlet those it shares with walls at rest); prescribed velocities come before slip and slip before outflow. Where
/// two faces with slip meet, both normal components vanish. On staggered axes no two faces have a point in common.
class FlowBoundary
{
public:
    /// \param faces by direction (x, y, z) and side; those of periodic axes and axes left out do not matter
    FlowBoundary(const Lattice& lattice, std::array<std::array<FaceCondition, 2>, 3> faces);

    const FaceCondition& face(int direction, Side side) const { return faces_[at(direction)][at(side)].condition; }

    /// Whether any face prescribes something that changes.
    bool dependsOnTime() const { return dependsOnTime_; }

    /// Whether pressure is prescribed at any face; else it is known up to a constant.
    bool fixesPressure() const;

    /// Evaluates the data of time t: those that change, and at the first call all.
    /// \throws Error(input) without origin, naming patch and point, if a value is not finite.
    void update(double t);

    /// Prescribed velocity along an active axis (component d of a velocity), corners by the rule above; empty unless
    /// the face prescribes it (faces with slip prescribe their normal component: zeros).
    std::span<const double> velocity(int direction, Side side, int d) const;

    /// The same as the face itself has it, whoever owns its corners: what an integral over the face takes.
    std::span<const double> ownVelocity(int direction, Side side, int d) const;

    /// What a face itself lets through along its axis, not heeding the corner rule: no flow enters through a wall at
    /// rest because a lid beside it moves. Empty unless the face prescribes it.
    std::span<const double> normalVelocity(int direction, Side side) const;

    /// Prescribed pressure or outward derivative; empty: zero, or not prescribed.
    std::span<const double> pressure(int direction, Side side) const;

    /// Coordinates x, y, z of the points of a face, or of their feet [m].
    std::array<std::span<const double>, 3> coordinates(int direction, Side side) const;

    /// Overwrites the velocity at the points that lie on faces with what they prescribe. Nothing on staggered axes.
    void impose(RealField& U) const;

    /// The same for what faces prescribe along their own axes alone, whoever owns corners: nothing flows through walls,
    /// along them it slips.
    void imposeNormal(RealField& U) const;

    /// Volume (in 2-D: area) that flows in through the faces that prescribe it, and out, per second.
    struct Flux
    {
        double in = 0;
        double out = 0;
    };

    /// How values along a face are summed up.
    enum class Quadrature
    {
        plain,       ///< as the lattice has it: trapezoidal, or midpoints on staggered axes
        endCorrected ///< of fifth order for smooth values, on axes with 8 points or more
    };

    /// Each face counts with its own data: the corner of a moving lid is no flow through the wall beside it.
    Flux flux(Quadrature quadrature = Quadrature::plain) const;

    /// Whether the current data of a point that faces share go through one of them that does not let it through: a lid
    /// that moves towards the wall beside it. The flow is singular there, and its divergence cannot vanish.
    bool flowsThroughCorners() const;

    /// Two faces that prescribe different velocities at a point they share, neither of them zero.
    struct Contradiction
    {
        std::array<std::string, 2> patches;
        std::array<std::array<double, 3>, 2> velocities; ///< components x, y, z
        std::array<double, 3> point;
    };

    /// The first contradiction of the current data beyond a relative difference, if there is any.
    std::optional<Contradiction> contradiction(double tolerance = 1e-6) const;

private:
    struct Face
    {
        FaceCondition condition;
        std::array<std::vector<double>, 3> coordinates; ///< of its points, or their feet
        std::vector<std::size_t> points;                ///< their indices in a field; of staggered axes the next ones
        std::array<std::vector<double>, 3> own;         ///< what the face itself prescribes, by component
        std::array<std::vector<double>, 3> velocity;    ///< with the corner rule applied
        std::vector<double> pressure;
        bool onPoints = true;
    };

    /// A point of a face that other faces have, too.
    struct Share
    {
        int direction;
        Side side;
        std::size_t index; ///< in the data of the face
    };
    using Corner = std::vector<Share>;

    static std::size_t at(int direction) { return static_cast<std::size_t>(direction); }
    static std::size_t at(Side side) { return side == Side::low ? 0 : 1; }

    Face& faceAt(const Share& share) { return faces_[at(share.direction)][at(share.side)]; }
    const Face& faceAt(const Share& share) const { return faces_[at(share.direction)][at(share.side)]; }

    void placePoints(Face& face, int direction, Side side) const;
    void findCorners();
    void evaluateVelocity(Face& face, double t);
    void evaluatePressure(Face& face, double t);
    double ownSpeed(const Share& share) const;
    void applyCornerRule();

    Lattice lattice_;
    std::array<std::array<Face, 2>, 3> faces_;
    std::vector<Corner> corners_;
    bool dependsOnTime_ = false;
    bool evaluated_ = false;
};

} // namespace isph
