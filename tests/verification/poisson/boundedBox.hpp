#pragma once

#include "exactFunctions.hpp"
#include "poisson/BoundedPoisson.hpp"

#include <algorithm>

namespace isph::test
{

/// A box with its corner at the origin, and its Poisson solver.
class BoundedBox
{
public:
    explicit BoundedBox(const std::vector<BoxAxis>& axes, const AxisSymbol& symbol = BoundedPoisson::exactSymbol)
        : lattice(latticeOf(axes)), poisson(lattice, endsOf(axes), PlanEffort::estimated, symbol), axes_(axes)
    {
    }

    RealField field(const Scalar& function) const
    {
        RealField result(1, lattice.points());
        const auto [x, y, z] = lattice.coordinates();
        for (std::size_t i = 0; i < result.size(); ++i) { result[0][i] = function(x[i], y[i], z[i]); }
        return result;
    }

    /// Values on the low or high face of a direction.
    std::vector<double> face(int direction, bool high, const Scalar& function) const
    {
        std::vector<double> values;
        const auto coordinate = [&](int d, int i)
        {
            if (d == direction) { return high ? lattice.axis(d).extent : 0.0; }
            return lattice.axis(d).active() ? lattice.axis(d).coordinate(i) : 0.0;
        };
        const auto count = [&](int d) { return d == direction ? 1 : lattice.axis(d).count; };
        for (int k = 0; k < count(2); ++k)
        {
            for (int j = 0; j < count(1); ++j)
            {
                for (int i = 0; i < count(0); ++i)
                {
                    values.push_back(function(coordinate(0, i), coordinate(1, j), coordinate(2, k)));
                }
            }
        }
        return values;
    }

    /// What each end prescribes of a function: its slope or its value.
    struct Walls
    {
        std::array<std::array<std::vector<double>, 2>, 3> values;
        WallData data() const
        {
            WallData result;
            for (std::size_t d = 0; d < 3; ++d) { result[d] = {values[d][0], values[d][1]}; }
            return result;
        }
    };

    Walls walls(const Exact& exact) const
    {
        Walls result;
        for (std::size_t d = 0; d < axes_.size(); ++d)
        {
            const AxisEnds ends = axes_[d].ends;
            if (ends.low == End::periodic) { continue; }
            const auto given = [&](End end) { return end == End::neumann ? exact.slope[d] : exact.value; };
            result.values[d][0] = face(static_cast<int>(d), false, given(ends.low));
            result.values[d][1] = face(static_cast<int>(d), true, given(ends.high));
        }
        return result;
    }

    /// Root mean square of a - b, without their means where phi has none; relative to that of b.
    double error(const RealField& a, const RealField& b) const
    {
        double shift = 0;
        if (floating())
        {
            for (std::size_t i = 0; i < a.size(); ++i) { shift += (a[0][i] - b[0][i]) / static_cast<double>(a.size()); }
        }
        double difference = 0;
        double norm = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            difference += std::pow(a[0][i] - b[0][i] - shift, 2);
            norm += b[0][i] * b[0][i];
        }
        return std::sqrt(difference / norm);
    }

    /// Largest |a - b|, the constant taken out where phi is fixed up to it; relative to the larger of 1 and max |b|.
    double largestError(const RealField& a, const RealField& b) const
    {
        const double shift = floating() ? a[0][0] - b[0][0] : 0;
        double difference = 0;
        double norm = 1;
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            difference = std::max(difference, std::abs(a[0][i] - b[0][i] - shift));
            norm = std::max(norm, std::abs(b[0][i]));
        }
        return difference / norm;
    }

    /// Solves for the exact function and returns the largest error.
    double solved(const Exact& exact, const Scalar& laplacian)
    {
        RealField phi(1, lattice.points());
        const Walls data = walls(exact);
        poisson.solve(field(laplacian), data.data(), phi);
        return largestError(phi, field(exact.value));
    }

    bool floating() const
    {
        return std::none_of(axes_.begin(), axes_.end(),
                            [](const BoxAxis& axis)
                            { return axis.ends.low == End::dirichlet || axis.ends.high == End::dirichlet; });
    }

    Lattice lattice;
    BoundedPoisson poisson;

private:
    static Lattice latticeOf(const std::vector<BoxAxis>& boxAxes)
    {
        std::array<Axis, 3> axes;
        constexpr std::array<char, 3> names{'x', 'y', 'z'};
        for (std::size_t d = 0; d < 3; ++d)
        {
            axes[d].name = names[d];
            if (d >= boxAxes.size()) { continue; }
            const BoxAxis& axis = boxAxes[d];
            const bool periodic = axis.ends.low == End::periodic;
            axes[d].extent = axis.extent;
            axes[d].count = axis.intervals + (periodic || axis.staggered ? 0 : 1);
            axes[d].ends = periodic ? Axis::Ends::periodic : Axis::Ends::bounded;
            axes[d].staggered = axis.staggered;
        }
        return Lattice(axes, {});
    }

    static std::array<AxisEnds, 3> endsOf(const std::vector<BoxAxis>& axes)
    {
        std::array<AxisEnds, 3> ends;
        for (std::size_t d = 0; d < axes.size(); ++d) { ends[d] = axes[d].ends; }
        return ends;
    }

    std::vector<BoxAxis> axes_;
};

} // namespace isph::test
