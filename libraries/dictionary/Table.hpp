#pragma once

#include "dictionary/SpaceTimeFunction.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph
{

/// A curve through points by natural cubic splines (Press et al. 2007, Numerical Recipes, 3.3): twice continuously
/// differentiable, second derivative zero at the ends, error of order h^4 away from them. Outside, the ends are held.
class NaturalSpline
{
public:
    /// Requires at least two places, strictly increasing, and as many values.
    NaturalSpline(std::vector<double> places, std::vector<double> values);

    double operator()(double place) const;

private:
    std::vector<double> places_;
    std::vector<double> values_;
    std::vector<double> curvatures_; ///< second derivatives at the places
};

/// The curves of a CSV file over one of the coordinates.
struct SpaceTimeFunction::Table
{
    char coordinate = 'x'; ///< x, y, z or t
    std::vector<NaturalSpline> columns;

    double operator()(int component, double x, double y, double z, double t) const;
};

/// Reads a table: a header row that names a coordinate x, y, z or t (units in brackets may follow) and the columns,
/// then rows of numbers with the coordinate increasing. Empty lines and lines that begin with # are skipped. \param
/// origin of the dictionary entry that names the file \param name of the file as messages show it \throws Error(input)
/// at the line of the table that is wrong.
SpaceTimeFunction::Table readTable(const std::filesystem::path& file, const std::string& name, int components,
                                   const Origin& origin);

} // namespace isph
