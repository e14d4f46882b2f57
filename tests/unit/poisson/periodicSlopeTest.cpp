#include "continuation/ContinuedDerivative.hpp"
#include "poisson/BoundedPoisson.hpp"
#include "support/boundedLine.hpp"
#include "support/fields.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace
{

Axis axisOf(char name, int count, bool periodic)
{
    return {.name = name, .extent = 1.5, .count = count, .ends = periodic ? Axis::Ends::periodic : Axis::Ends::bounded};
}

} // namespace

// The slope that comes with the solution is that of the operators, along any periodic axis, even and odd counts.
TEST(PeriodicSlope, IsTheDerivativeOfTheSolution)
{
    for (const int direction : {0, 1, 2})
    {
        for (const int count : {12, 15})
        {
            std::array<Axis, 3> axes{axisOf('x', 9, false), axisOf('y', 10, true), axisOf('z', 8, true)};
            std::array<AxisEnds, 3> ends{};
            for (int d = 0; d < 3; ++d)
            {
                const bool bounded = d == (direction + 1) % 3;
                const auto at = static_cast<std::size_t>(d);
                axes[at] = axisOf("xyz"[d], d == direction ? count : 9, !bounded);
                if (bounded) { ends[at] = {End::neumann, End::dirichlet}; }
            }
            const Lattice lattice(axes, {});
            BoundedPoisson poisson(lattice, ends);
            const LineSymbol symbol = lineSymbol(gaussianKernel(8), count, lattice.axis(direction).spacing());
            const RealField source = noise(lattice, 1, 7);
            RealField plain(1, lattice.points());
            RealField phi(1, lattice.points());
            RealField slope(1, lattice.points());
            poisson.solve(source, {}, plain);
            const PeriodicSlope asked{direction, symbol.first, slope[0]};
            poisson.solve(source, {}, phi, &asked);

            RealField expected(1, lattice.points());
            ContinuedDerivative derivative(ContinuedTransform(linesAlong(lattice, direction), std::nullopt), symbol);
            derivative(plain[0], expected[0], {});
            double largest = 0;
            for (std::size_t i = 0; i < lattice.points(); ++i)
            {
                EXPECT_NEAR(phi[0][i], plain[0][i], 1e-15);
                EXPECT_NEAR(slope[0][i], expected[0][i], 1e-13);
                largest = std::max(largest, std::abs(expected[0][i]));
            }
            EXPECT_GT(largest, 1e-3);
        }
    }
}
