#pragma once

#include "boundary/FlowBoundary.hpp"
#include "continuation/ContinuedTransform.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace isph
{

/// What a face does to a scalar.
enum class ScalarCondition
{
    periodic,
    value,    ///< prescribed
    gradient, ///< its outward derivative is prescribed
    outflow   ///< nothing prescribed: the scalar leaves as it comes
};

/// The condition at one face of the box.
struct ScalarFace
{
    std::string patch;
    ScalarCondition condition = ScalarCondition::periodic;
    std::unique_ptr<const FaceFunction> data; ///< value, or outward derivative [1/m]; null: zero
};

/// What the faces of a box prescribe to a scalar, at one time.
///
/// On collocated axes prescribed values overwrite the points on the face; where faces with values meet, their common
/// points take the mean of them. On staggered axes they enter the continuation, as derivatives do everywhere.
class ScalarBoundary
{
public:
    /// \param faces by direction (x, y, z) and side (low, high); those of periodic axes and axes left out do not matter
    ScalarBoundary(const Lattice& lattice, std::array<std::array<ScalarFace, 2>, 3> faces);

    ScalarCondition condition(int direction, Side side) const { return at(direction, side).face.condition; }

    /// What lines along a direction need to know of that face. What leaves a staggered axis, whose points do not reach
    /// the face, is mirrored there.
    EndCondition endCondition(int direction, Side side) const;

    /// Evaluates the data of time t: those that change, and at the first call all.
    /// \throws Error(input) without origin, naming patch and point, if a value is not finite.
    void update(double t);

    /// Data of the lines along a direction, as continuations take them: outward derivatives times the spacing.
    EndData endData(int direction) const;

    /// Overwrites the points on faces with the values prescribed there.
    void impose(std::span<double> values) const;

    /// Largest magnitude of a value prescribed so far.
    double largestValue() const { return largestValue_; }

    /// Whether a derivative other than zero is prescribed: then nothing bounds the scalar.
    bool prescribesFlux() const;

    /// The faces without a prescribed value or derivative through which this velocity enters, by their patches.
    std::vector<std::string> inflowThroughOutflow(const RealField& velocity) const;

private:
    struct Face
    {
        ScalarFace face;
        std::array<std::vector<double>, 3> coordinates; ///< of its points, or of the feet of the points next to it
        std::vector<double> data;                       ///< of the lines that end here
        std::size_t first = 0;                          ///< from the start of a line to its end here
        bool bounded = false;
        bool onPoints = false;
    };
    /// A point on a face with a prescribed value, and the weight of the value in a mean.
    struct Prescribed
    {
        std::size_t point;
        const double* value;
        double weight;
    };

    Face& at(int direction, Side side)
    {
        return faces_[static_cast<std::size_t>(direction)][side == Side::low ? 0 : 1];
    }
    const Face& at(int direction, Side side) const
    {
        return faces_[static_cast<std::size_t>(direction)][side == Side::low ? 0 : 1];
    }
    void place(Face& face, int direction, Side side);
    void collectPrescribed();
    std::size_t pointOf(const Face& face, int direction, std::size_t line) const;

    Lattice lattice_;
    std::array<std::array<Face, 2>, 3> faces_;
    std::vector<Prescribed> prescribed_;
    bool evaluated_ = false;
    double largestValue_ = 0;
};

} // namespace isph
