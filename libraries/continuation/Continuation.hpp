#pragma once

#include <cstddef>
#include <vector>

namespace isph
{

/// What is known at an end of a line besides the values at its points.
enum class EndCondition
{
    dirichlet, ///< the value at the wall: the end point itself, or on a staggered line the datum
    neumann,   ///< the outward derivative at the wall: the datum, times the spacing
};

/// What one end of a line gives to its new points: after k = 1 ... newPoints steps outward from this end
///     sum_c weight(k, c) f_c + data[k - 1] datum,   c = 0 at the end, counted inward.
/// The new points of a line are the sum of what both ends give.
struct EndBlock
{
    int newPoints = 0;
    int points = 0;              ///< of the line that are used, c < points
    std::vector<double> weights; ///< row after row, one row a new point
    std::vector<double> data;    ///< empty where there is no datum

    double weight(int k, int c) const { return weights[static_cast<std::size_t>((k - 1) * points + c)]; }
};

/// A way to make the values on a line periodic by new points beyond its last one; both ends are alike.
///
/// A line has n points with spacing dx, its walls on the end points or, staggered, half a spacing outside. The period
/// is (n + newPoints) dx: the new point after the last is point 0 again.
class Continuation
{
public:
    explicit Continuation(int newPoints) : newPoints_(newPoints) {}
    virtual ~Continuation() = default;

    int newPoints() const { return newPoints_; }

    /// Points of the line that an end uses; a line needs at least as many.
    virtual int points() const = 0;

    virtual EndBlock end(EndCondition condition) const = 0;

private:
    int newPoints_;
};

/// New points for a line of n points: at least 25, more until n + d is a product of 2, 3, 5 and 7.
int automaticNewPoints(int n);

} // namespace isph
