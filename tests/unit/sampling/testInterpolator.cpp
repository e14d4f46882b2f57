#include "Lattices.hpp"

#include "core/Error.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace isph::test
{

namespace
{

constexpr double pi = std::numbers::pi;

double largestError(const Lattice& lattice, const Points& points, Interpolation interpolation, auto&& f)
{
    const std::vector<double> values = interpolated(lattice, fieldOf(lattice, f), points, interpolation);
    double largest = 0;
    for (std::size_t n = 0; n < values.size(); ++n)
    {
        largest = std::max(largest, std::abs(values[n] - f(points[0][n], points[1][n], points[2][n])));
    }
    return largest;
}

} // namespace

TEST(Interpolator, latticePointsAreHitInTheSameBits)
{
    std::mt19937_64 random(3);
    for (const Lattice& lattice : {mixedLattice(7, 6, 5), mixedLattice(8, 5, 1, true), periodicLattice(6, 9, 4)})
    {
        RealField field(1, lattice.points());
        for (double& value : field[0])
        {
            value = std::bit_cast<double>(random());
            if (std::isnan(value)) { value = -0.0; } // a NaN may lose its payload in arithmetic
        }
        for (const Interpolation interpolation : {Interpolation::spectral, Interpolation::linear, Interpolation::cubic})
        {
            const std::vector<double> values = interpolated(lattice, field, lattice.coordinates(), interpolation);
            for (std::size_t n = 0; n < values.size(); ++n)
            {
                ASSERT_EQ(std::bit_cast<std::uint64_t>(values[n]), std::bit_cast<std::uint64_t>(field[0][n])) << n;
            }
        }
    }
}

TEST(Interpolator, spectralIsExactForEveryResolvedMode)
{
    for (const int n : {9, 10})
    {
        const Lattice lattice = periodicLattice(n, n + 1, n + 2);
        const Points points = randomPoints(lattice, 40, 5);
        for (int mode = 0; mode <= (n - 1) / 2; ++mode)
        {
            const auto wave = [mode](double x, double y, double z)
            { return std::cos(pi * mode * (x + 1) + 2 * pi * (1 - mode) * y + 4 * pi * 2 * z + 0.3); };
            EXPECT_LT(largestError(lattice, points, Interpolation::spectral, wave), 1e-12) << n << " " << mode;
        }
    }
}

TEST(Interpolator, nyquistModeIsACosine)
{
    const Lattice lattice = periodicLattice(6, 5, 1);
    const Points points = randomPoints(lattice, 40, 6);
    const auto wave = [](double x, double, double) { return std::cos(3 * pi * (x + 1)); };
    EXPECT_LT(largestError(lattice, points, Interpolation::spectral, wave), 1e-12);
}

TEST(Interpolator, polynomialsOfTheirDegreeAreExactUpToBoundedEnds)
{
    for (const bool staggered : {false, true})
    {
        const Lattice lattice = mixedLattice(8, 7, 1, staggered);
        const Points points = randomPoints(lattice, 100, 7);
        const auto straight = [](double, double y, double) { return 2 - 3 * y; };
        const auto cubic = [](double, double y, double) { return 1 - y * (2 - y * (0.5 + y)); };
        EXPECT_LT(largestError(lattice, points, Interpolation::linear, straight), 1e-13);
        EXPECT_LT(largestError(lattice, points, Interpolation::cubic, cubic), 1e-13);
        // Polynomials up to degree 4 go on as such only next to the walls; the rest is the blending's error.
        EXPECT_LT(largestError(lattice, points, Interpolation::spectral, cubic), 1e-8);
    }
}

TEST(Interpolator, ordersAreTwoAndFour)
{
    const auto wave = [](double x, double y, double z)
    { return std::sin(pi * x) * std::exp(y) + std::cos(4 * pi * z); };
    const auto order = [&](Interpolation interpolation)
    {
        const Points points = randomPoints(mixedLattice(8, 8, 8), 300, 8);
        const double coarse = largestError(mixedLattice(16, 17, 16), points, interpolation, wave);
        const double fine = largestError(mixedLattice(32, 33, 32), points, interpolation, wave);
        return std::log2(coarse / fine);
    };
    EXPECT_NEAR(order(Interpolation::linear), 2, 0.2);
    EXPECT_NEAR(order(Interpolation::cubic), 4, 0.4);
}

TEST(Interpolator, spectralIsOfFifthOrderUpToWalls)
{
    const auto f = [](double x, double y, double) { return std::sin(pi * x) * std::exp(y) * std::sin(5 * y); };
    for (const bool staggered : {false, true})
    {
        const auto error = [&](int n)
        {
            const Lattice lattice = mixedLattice(8, staggered ? n : n + 1, 1, staggered);
            Points points = randomPoints(lattice, 300, 12);
            points[1][0] = 0.25; // on the walls
            points[1][1] = 1.25;
            return largestError(lattice, points, Interpolation::spectral, f);
        };
        EXPECT_LT(error(80), staggered ? 1e-6 : 1e-7) << staggered;
        EXPECT_GT(std::log2(error(40) / error(80)), 4.6) << staggered;
    }
}

TEST(Interpolator, sharedCoordinatesChangeNothing)
{
    // Points on a raster, one by one and all together.
    const Lattice lattice = mixedLattice(7, 6, 5);
    std::mt19937 random(9);
    RealField field(1, lattice.points());
    for (double& value : field[0]) { value = std::uniform_real_distribution<double>(-1, 1)(random); }
    Points raster;
    for (int n = 0; n < 4 * 5 * 3; ++n)
    {
        raster[0].push_back(0.13 * (n % 4));
        raster[1].push_back(0.3 + 0.11 * (n / 4 % 5));
        raster[2].push_back(2.2 - 0.07 * (n / 20));
    }
    for (const Interpolation interpolation : {Interpolation::spectral, Interpolation::linear, Interpolation::cubic})
    {
        const std::vector<double> together = interpolated(lattice, field, raster, interpolation);
        for (std::size_t n = 0; n < together.size(); ++n)
        {
            const Points one{{{raster[0][n]}, {raster[1][n]}, {raster[2][n]}}};
            EXPECT_NEAR(interpolated(lattice, field, one, interpolation).front(), together[n], 1e-14);
        }
    }
}

TEST(Interpolator, fewPointsAreEnough)
{
    const Lattice lattice({Axis{'x', 0, 1, 2}, Axis{'y', 0, 1, 2, Axis::Ends::bounded}, Axis{'z', 0, 0, 1}}, {});
    const auto plane = [](double, double y, double) { return 1 + y; };
    const Points points = randomPoints(lattice, 10, 4);
    for (const Interpolation interpolation : {Interpolation::spectral, Interpolation::linear, Interpolation::cubic})
    {
        EXPECT_LT(largestError(lattice, points, interpolation, plane),
                  interpolation == Interpolation::spectral ? 1e-9 : 1e-14);
    }
}

TEST(Interpolator, refusesPointsOutsideOfABoundedBox)
{
    const Lattice lattice = mixedLattice(8, 8, 1);
    const auto at = [&](double y) { return Interpolator(lattice, {{{5.0}, {y}, {0}}}, Interpolation::linear); };
    EXPECT_NO_THROW(at(0.25 - 1e-12));
    EXPECT_NO_THROW(at(1.25 + 1e-12));
    EXPECT_THROW(at(0.2499), Error);
    EXPECT_THROW(at(1.2501), Error);
    EXPECT_THROW(at(std::nan("")), Error);
}

} // namespace isph::test
