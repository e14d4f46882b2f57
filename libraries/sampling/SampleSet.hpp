#pragma once

#include "core/Origin.hpp"
#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"
#include "sampling/Interpolator.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace isph
{

/// Points at equal distances on a straight line, both ends included.
struct Line
{
    std::string name;
    std::array<double, 3> start{}; ///< [m]
    std::array<double, 3> end{};   ///< [m]
    int nPoints = 2;
};

/// A plane across the box: its lattice points, or a raster of its own.
struct Plane
{
    std::string name;
    int normal = 2;               ///< 0, 1, 2 for x, y, z
    double at = 0;                ///< where on that axis [m]; any value on an axis that is left out
    std::array<int, 2> nPoints{}; ///< points along the two other axes, in the order x y z, from face to face of the
                                  ///< box; 0: the lattice points
};

/// A field to be sampled: one component, or one for each active axis.
struct NamedField
{
    std::string name;
    std::string unit;
    const RealField& values;
};

/// Columns of numbers with a head each, e.g. "U.x [m/s]".
struct SampleTable
{
    std::vector<std::string> heads;
    std::vector<std::vector<double>> columns;
};

/// Lines and planes to sample fields on: what sampleLines, and the function object of that name, do. The weights are
/// found once; sampling again, at another time, costs the sums only.
class SampleSet
{
public:
    /// \throws Error(input) naming the line or plane that leaves the box.
    SampleSet(const Lattice& lattice, const std::vector<Line>& lines, const std::vector<Plane>& planes,
              std::vector<Word> fields, Interpolation interpolation);

    /// The fields that were asked for, e.g. U, p, vorticity: the caller brings their values.
    const std::vector<Word>& fields() const { return fields_; }

    std::size_t size() const { return places_.size(); }
    const std::string& name(std::size_t place) const { return places_[place].name; }

    /// "distance [m]" (lines only), "x [m]", "y [m]", "z [m]", then each field: "p [m2/s2]", or three columns "U.x
    /// [m/s]", "U.y [m/s]", "U.z [m/s]" for a vector, with zeros along an axis that is left out.
    SampleTable sample(std::size_t place, std::span<const NamedField> fields) const;

private:
    struct Place
    {
        std::string name;
        std::vector<double> distance; ///< empty for planes
        Points points;
        Interpolator interpolator;
    };

    void add(const std::string& kind, const std::string& name, std::vector<double> distance, Points points,
             Interpolation interpolation);

    Lattice lattice_;
    std::vector<Word> fields_;
    std::vector<Place> places_;
};

/// The table as CSV; numbers read back as the same bits.
std::string csvText(const SampleTable& table);

/// Writes <folder>/<name>.csv for every line and plane, each at once.
/// \throws Error(input) naming a file that cannot be written.
void writeSamples(const SampleSet& set, std::span<const NamedField> fields, const std::filesystem::path& folder);

} // namespace isph
