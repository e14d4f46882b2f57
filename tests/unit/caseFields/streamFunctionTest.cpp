#include "caseFields/StreamFunction.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

constexpr double pi = std::numbers::pi;

Axis walls(char name, double from, double to, int count, bool staggered = false)
{
    return {name, from, to - from, count, Axis::Ends::bounded, staggered};
}

/// Largest error of the stream function of the velocity (u, v).
template<class U, class V, class Psi>
double error(const Lattice& lattice, U u, V v, Psi psi)
{
    const auto coordinates = lattice.coordinates();
    const auto& a = coordinates[static_cast<std::size_t>(lattice.direction(0))];
    const auto& b = coordinates[static_cast<std::size_t>(lattice.direction(1))];
    RealField velocity(2, lattice.points());
    for (std::size_t n = 0; n < lattice.points(); ++n)
    {
        velocity[0][n] = u(a[n], b[n]);
        velocity[1][n] = v(a[n], b[n]);
    }
    const StreamFunction found = streamFunction(velocity, lattice);
    double largest = 0;
    for (std::size_t n = 0; n < lattice.points(); ++n)
    {
        largest = std::max(largest, std::abs(found.values[0][n] - psi(a[n], b[n])));
    }
    return largest;
}

// Vortices between walls at rest: psi = sin(2 pi x) y^2 (1 - y)^2.
TEST(StreamFunction, VanishesAtTheWallsOfAChannel)
{
    const auto channel = [](int n, bool staggered)
    {
        const Lattice lattice({Axis{'x', 0, 1, 16}, walls('y', 0, 1, staggered ? n : n + 1, staggered), Axis{'z'}}, {});
        return error(
            lattice, [](double x, double y) { return std::sin(2 * pi * x) * 2 * y * (1 - y) * (1 - 2 * y); },
            [](double x, double y) { return -2 * pi * std::cos(2 * pi * x) * y * y * (1 - y) * (1 - y); },
            [](double x, double y) { return std::sin(2 * pi * x) * y * y * (1 - y) * (1 - y); });
    };
    EXPECT_LT(channel(40, false), 1e-6);
    EXPECT_GT(std::log2(channel(20, false) / channel(40, false)), 3.7);
    EXPECT_LT(channel(40, true), 1e-4);
}

// Poiseuille's flow: psi is the flow below a point, and its gain along x none.
TEST(StreamFunction, IsTheFlowBelow)
{
    const Lattice lattice({Axis{'x', 0, 1, 8}, walls('y', 0, 1, 33), Axis{'z'}}, {});
    EXPECT_LT(error(
                  lattice, [](double, double y) { return y * (1 - y); }, [](double, double) { return 0.0; },
                  [](double, double y) { return y * y / 2 - y * y * y / 3; }),
              1e-7);
}

// Suction through both walls, and waves in it: psi gains by a period what flows through the walls.
TEST(StreamFunction, GrowsAlongWallsThatAreFlowedThrough)
{
    const Lattice lattice({walls('x', 0, 1, 65), Axis{'y'}, Axis{'z', 0, 2, 32}}, {});
    // psi = 0.5 z + x + exp(x) sin(pi z)/pi, zero where x = 0, z = 0.
    EXPECT_LT(error(
                  lattice, [](double x, double z) { return 0.5 + std::exp(x) * std::cos(pi * z); },
                  [](double x, double z) { return -1 - std::exp(x) * std::sin(pi * z) / pi; },
                  [](double x, double z) { return 0.5 * z + x + std::exp(x) * std::sin(pi * z) / pi; }),
              1e-5);
}

// A box that is flowed through, psi = exp(x) sin(3 y) + y.
TEST(StreamFunction, IsOfFourthOrderInABox)
{
    const auto box = [](int n)
    {
        const Lattice lattice({walls('x', 0, 1, n + 1), walls('y', 0, 2, 2 * n + 1), Axis{'z'}}, {});
        return error(
            lattice, [](double x, double y) { return 3 * std::exp(x) * std::cos(3 * y) + 1; },
            [](double x, double y) { return -std::exp(x) * std::sin(3 * y); },
            [](double x, double y) { return std::exp(x) * std::sin(3 * y) + y; });
    };
    EXPECT_LT(box(40), 1e-5);
    EXPECT_GT(std::log2(box(20) / box(40)), 3.7);
}

// Corners that move with a lid are no flow through the walls beside it: psi = sin^2(pi x) y^2 (1 - y)^2 all the same.
TEST(StreamFunction, TakesCornersForPartsOfTheLid)
{
    const int n = 40;
    const Lattice lattice({walls('x', 0, 1, n + 1), walls('y', 0, 1, n + 1), Axis{'z'}}, {});
    const auto lidCorner = [](double x, double y) { return y == 1 && (x == 0 || x == 1) ? 1 : 0; };
    EXPECT_LT(error(
                  lattice,
                  [&](double x, double y)
                  { return lidCorner(x, y) + std::pow(std::sin(pi * x), 2) * 2 * y * (1 - y) * (1 - 2 * y); },
                  [](double x, double y) { return -pi * std::sin(2 * pi * x) * y * y * (1 - y) * (1 - y); },
                  [](double x, double y) { return std::pow(std::sin(pi * x) * y * (1 - y), 2); }),
              1e-5);
}

} // namespace
} // namespace isph
