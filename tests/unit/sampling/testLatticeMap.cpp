#include "Lattices.hpp"

#include "core/Error.hpp"
#include "sampling/LatticeMap.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace isph::test
{

using testing::HasSubstr;

namespace
{

constexpr double pi = std::numbers::pi;

RealField noise(int components, const Lattice& lattice)
{
    std::mt19937 random(11);
    RealField field(components, lattice.points());
    for (int c = 0; c < components; ++c)
    {
        for (double& value : field[c]) { value = std::uniform_real_distribution<double>(-1, 1)(random); }
    }
    return field;
}

double largestDifference(std::span<const double> a, std::span<const double> b)
{
    EXPECT_EQ(a.size(), b.size());
    double largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n) { largest = std::max(largest, std::abs(a[n] - b[n])); }
    return largest;
}

Axis moved(Axis axis, double by)
{
    axis.origin += by;
    return axis;
}

std::string refusal(const Lattice& source, const Lattice& target)
{
    try
    {
        LatticeMap(source, target);
    }
    catch (const Error& error)
    {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST(LatticeMap, samePointsKeepTheirBits)
{
    const Lattice lattice = mixedLattice(6, 5, 4);
    LatticeMap map(lattice, lattice);
    const RealField field = noise(3, lattice);
    const RealField mapped = map(field);
    for (int c = 0; c < 3; ++c) { EXPECT_TRUE(std::ranges::equal(mapped[c], field[c])); }
    EXPECT_EQ(map.method(), "the points are the same");
}

TEST(LatticeMap, finerLatticesGetTheFourierSeries)
{
    // Even and odd counts, the same count along one axis, and boxes that begin elsewhere.
    for (const auto& [counts, by] : {std::pair{std::array{9, 11, 8}, 0.0},
                                     {std::array{8, 16, 5}, 0.3},
                                     {std::array{12, 7, 13}, -0.01},
                                     {std::array{6, 5, 4}, 0.123}})
    {
        const Lattice source = periodicLattice(6, 5, 4);
        const Lattice same = periodicLattice(counts[0], counts[1], counts[2]);
        const Lattice target({moved(same.axis(0), by), moved(same.axis(1), 2 * by), moved(same.axis(2), -by)}, {});
        LatticeMap map(source, target);
        EXPECT_EQ(map.method(), "Fourier modes");
        const RealField field = noise(1, source);
        const RealField mapped = map(field);
        EXPECT_LT(
            largestDifference(mapped[0], interpolated(source, field, target.coordinates(), Interpolation::spectral)),
            1e-13);
    }
}

TEST(LatticeMap, coarserLatticesKeepTheModesTheyHold)
{
    const Lattice source = periodicLattice(16, 15, 1);
    const Lattice target = periodicLattice(8, 7, 1);
    const auto held = [](double x, double y, double) { return std::cos(3 * pi * x + 6 * pi * y) + 0.5; };
    const auto both = [&](double x, double y, double z)
    { return held(x, y, z) + std::sin(5 * pi * x) + std::cos(4 * pi * x + 2 * pi * y) + std::sin(8 * pi * y); };
    LatticeMap map(source, target);
    EXPECT_LT(largestDifference(map(fieldOf(source, both))[0], fieldOf(target, held)[0]), 1e-13);
}

TEST(LatticeMap, thereAndBackIsTheSame)
{
    const Lattice coarse = periodicLattice(7, 9, 5);
    const Lattice fine = periodicLattice(12, 9, 8);
    const RealField field = noise(3, coarse);
    const RealField back = LatticeMap(fine, coarse)(LatticeMap(coarse, fine)(field));
    for (int c = 0; c < 3; ++c) { EXPECT_LT(largestDifference(back[c], field[c]), 1e-14); }
}

TEST(LatticeMap, partsAndRepetitionsOfPeriods)
{
    const Lattice source = periodicLattice(12, 10, 1);
    const auto wave = [](double x, double y, double) { return std::sin(2 * pi * x) * std::cos(4 * pi * y); };
    // Two periods in x; in y a bounded part of one.
    const Lattice target({Axis{'x', -5, 4, 18}, Axis{'y', 0.5, 0.5, 7, Axis::Ends::bounded}, Axis{'z', 0, 0, 1}}, {});
    LatticeMap map(source, target);
    EXPECT_EQ(map.method(), "spectral along x, spectral along y");
    EXPECT_LT(largestDifference(map(fieldOf(source, wave))[0], fieldOf(target, wave)[0]), 1e-13);
}

TEST(LatticeMap, boundedAxesAreContinued)
{
    const Lattice source = mixedLattice(8, 65, 1);
    const Lattice target = mixedLattice(12, 21, 1, true);
    const auto profile = [](double x, double y, double) { return std::cos(pi * x) * std::sin(4 * y); };
    LatticeMap map(source, target);
    EXPECT_EQ(map.method(), "spectral along x, spectral by continuation along y");
    EXPECT_LT(largestDifference(map(fieldOf(source, profile))[0], fieldOf(target, profile)[0]), 2e-8);
}

TEST(LatticeMap, betweenTwoAndThreeDimensions)
{
    const Lattice flat = periodicLattice(8, 9, 1);
    const Lattice box = periodicLattice(8, 9, 4);
    const RealField U = noise(2, flat);
    const RealField spread = LatticeMap(flat, box)(U);
    ASSERT_EQ(spread.components(), 3);
    EXPECT_TRUE(std::ranges::equal(spread[1].last(72), U[1]));
    EXPECT_TRUE(std::ranges::all_of(spread[2], [](double value) { return value == 0; }));

    const Lattice cut({box.axis(0), box.axis(1), Axis{'z', box.axis(2).coordinate(2), 0, 1}}, {});
    const RealField slice = LatticeMap(box, cut)(spread);
    ASSERT_EQ(slice.components(), 2);
    EXPECT_TRUE(std::ranges::equal(slice[0], U[0]));
}

TEST(LatticeMap, refusesWhatDoesNotFit)
{
    const auto xAxis = [](double origin, double extent, Axis::Ends ends) {
        return Lattice({Axis{'x', origin, extent, 8, ends}, Axis{'y', 0, 1, 8}, Axis{'z', 0, 0, 1}}, {});
    };
    constexpr auto bounded = Axis::Ends::bounded;
    constexpr auto periodic = Axis::Ends::periodic;
    EXPECT_THAT(refusal(xAxis(0, 1, bounded), xAxis(0, 1.1, bounded)),
                HasSubstr("the box reaches from x = 0 to x = 1.1, but the source only from 0 to 1"));
    EXPECT_THAT(refusal(xAxis(0, 1, bounded), xAxis(-0.1, 1, periodic)), HasSubstr("but the source only from"));
    EXPECT_THAT(refusal(xAxis(0, 1, periodic), xAxis(0, 1.5, periodic)),
                HasSubstr("along x the source has a period of 1 m, and 1.5 m is no whole number of them"));
    EXPECT_THAT(refusal(xAxis(0, 1, periodic), xAxis(0, 0.5, periodic)), HasSubstr("no whole number"));
    EXPECT_THAT(refusal(xAxis(0, 1, periodic), xAxis(0.7, 0.5, bounded)), HasSubstr("no whole number"));
    EXPECT_EQ(refusal(xAxis(0, 1, periodic), xAxis(0.3, 0.5, bounded)), "accepted");
    EXPECT_EQ(refusal(xAxis(0, 1, periodic), xAxis(7.3, 3, periodic)), "accepted");
    EXPECT_EQ(refusal(xAxis(0, 1, bounded), xAxis(0.2, 0.5, bounded)), "accepted");
}

} // namespace isph::test
