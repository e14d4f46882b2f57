#include "poisson/MorrisSystem.hpp"

#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/messageOf.hpp"
#include "support/periodicBox.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

struct Conditions
{
    const char* name;
    std::array<AxisEnds, 3> ends;
};

constexpr AxisEnds slopes{End::neumann, End::neumann};
constexpr AxisEnds values{End::dirichlet, End::dirichlet};
constexpr AxisEnds slopeThenValue{End::neumann, End::dirichlet};
constexpr AxisEnds valueThenSlope{End::dirichlet, End::neumann};

constexpr std::array conditions{
    Conditions{"walls", {slopes, slopes, AxisEnds{}}},
    Conditions{"channel", {AxisEnds{}, slopes, AxisEnds{}}},
    Conditions{"outlet", {slopeThenValue, slopes, AxisEnds{}}},
    Conditions{"inletAbove", {slopes, valueThenSlope, AxisEnds{}}},
    Conditions{"values", {values, values, AxisEnds{}}},
    Conditions{"tunnel3D", {slopeThenValue, slopes, AxisEnds{}}},
};

Lattice latticeOf(const Conditions& scene, bool staggered)
{
    std::array<Axis, 3> axes;
    constexpr std::array<char, 3> names{'x', 'y', 'z'};
    constexpr std::array<int, 3> counts{10, 9, 8};
    constexpr std::array<double, 3> extents{1, 0.8, 0.9};
    const bool cubic = std::string(scene.name).ends_with("3D");
    for (std::size_t d = 0; d < (cubic ? 3U : 2U); ++d)
    {
        const bool periodic = scene.ends[d].low == End::periodic;
        axes[d] = {.name = names[d],
                   .extent = extents[d],
                   .count = counts[d],
                   .ends = periodic ? Axis::Ends::periodic : Axis::Ends::bounded,
                   .staggered = staggered};
    }
    axes[2].name = 'z';
    axes[1].name = 'y';
    return Lattice(axes, {});
}

class MorrisSystemIn : public testing::TestWithParam<std::tuple<Conditions, bool>>
{
protected:
    MorrisSystemIn()
        : lattice(latticeOf(std::get<0>(GetParam()), std::get<1>(GetParam()))),
          ends(std::get<0>(GetParam()).ends),
          system(lattice, KernelSamples(lattice, test::sampledGaussian(4, 2, 4), LaplacianForm::morris), ends)
    {
    }

    Lattice lattice;
    std::array<AxisEnds, 3> ends;
    MorrisSystem system;
};

std::string nameOf(const testing::TestParamInfo<std::tuple<Conditions, bool>>& info)
{
    const auto& [scene, staggered] = info.param;
    return std::string(scene.name) + (staggered ? "_staggered" : "_collocated");
}

INSTANTIATE_TEST_SUITE_P(Of, MorrisSystemIn, testing::Combine(testing::ValuesIn(conditions), testing::Bool()), nameOf);

TEST_P(MorrisSystemIn, IsSymmetricInItsWeights)
{
    std::vector<double> dense(lattice.points() * lattice.points());
    const SparseMatrix& matrix = system.matrix();
    for (std::size_t i = 0; i < lattice.points(); ++i)
    {
        const auto begin = static_cast<std::size_t>(matrix.rowStarts()[i]);
        const auto end = static_cast<std::size_t>(matrix.rowStarts()[i + 1]);
        const auto columns = matrix.columnIndices().subspan(begin, end - begin);
        EXPECT_TRUE(std::ranges::is_sorted(columns, std::less_equal{}));
        for (std::size_t n = begin; n < end; ++n)
        {
            const auto j = static_cast<std::size_t>(matrix.columnIndices()[n]);
            const double weight = system.weights().empty() ? 1 : system.weights()[i];
            dense[i * lattice.points() + j] = weight * matrix.values()[n];
        }
    }
    double difference = 0;
    for (std::size_t i = 0; i < lattice.points(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            difference =
                std::max(difference, std::abs(dense[i * lattice.points() + j] - dense[j * lattice.points() + i]));
        }
    }
    EXPECT_LE(difference, 1e-15 * system.diagonal()); // round-off of sums over images
}

TEST_P(MorrisSystemIn, ConstantsAreNullWhereNoValueIsGiven)
{
    const AlignedVector<double> one(lattice.points(), 1.0);
    AlignedVector<double> result(lattice.points());
    system.matrix().apply(one, result);
    const double largest = std::abs(*std::ranges::max_element(result, {}, [](double v) { return std::abs(v); }));
    if (system.constantMode()) { EXPECT_LE(largest, 1e-13 * system.diagonal()); }
    else { EXPECT_GT(largest, 0.1 * system.diagonal()); }
}

/// A function that is straight along every bounded axis keeps no Laplacian, with its slopes and values as data:
/// mirrored about a wall and raised by the slope, a straight line goes on straight.
TEST_P(MorrisSystemIn, StraightLinesGoOnBeyondTheEnds)
{
    std::array<double, 3> slope{ends[0].low == End::periodic ? 0 : 0.7, 1.3, 0};
    const auto hasValue = [&](std::size_t d)
    { return ends[d].low == End::dirichlet || ends[d].high == End::dirichlet; };
    if (std::get<1>(GetParam()))
    {
        // Off the points nobody knows how values go on beyond the edges of their face: no line across, then.
        if (hasValue(0)) { slope[1] = 0; }
        if (hasValue(1)) { slope[0] = 0; }
    }
    const RealField line =
        test::fieldOf(lattice, 1, [&](int, double x, double y, double) { return 2 + slope[0] * x + slope[1] * y; });
    std::array<std::array<std::vector<double>, 2>, 3> data;
    WallData walls;
    const std::array<std::size_t, 3> counts{static_cast<std::size_t>(lattice.axis(0).count),
                                            static_cast<std::size_t>(lattice.axis(1).count),
                                            static_cast<std::size_t>(lattice.axis(2).count)};
    for (std::size_t d = 0; d < 2; ++d)
    {
        if (ends[d].low == End::periodic) { continue; }
        const std::size_t other = 1 - d;
        for (std::size_t side = 0; side < 2; ++side)
        {
            const bool value = (side == 0 ? ends[d].low : ends[d].high) == End::dirichlet;
            for (std::size_t k = 0; k < counts[2]; ++k)
            {
                for (std::size_t i = 0; i < counts[other]; ++i)
                {
                    const double along = lattice.axis(static_cast<int>(other)).coordinate(static_cast<int>(i));
                    const double place = side == 0 ? 0 : lattice.axis(static_cast<int>(d)).extent;
                    data[d][side].push_back(value ? 2 + slope[d] * place + slope[other] * along : slope[d]);
                }
            }
        }
        walls[d] = {data[d][0], data[d][1]};
    }
    AlignedVector<double> rhs(lattice.points());
    const AlignedVector<double> none(lattice.points());
    const double unbalanced = system.rightHandSide(none, walls, rhs);
    EXPECT_NEAR(unbalanced, 0, 1e-12 * system.diagonal());
    AlignedVector<double> applied(lattice.points());
    system.matrix().apply(line[0], applied);

    double largest = 0;
    for (std::size_t i = 0; i < rhs.size(); ++i) { largest = std::max(largest, std::abs(rhs[i] - applied[i])); }
    EXPECT_LE(largest, 1e-13 * system.diagonal());
}

TEST(MorrisSystem, LeavesOutNeighboursWithoutWeight)
{
    // At h/dx = 2 the quintic spline's rim lies at 6 points: 113 in the disc, of which 4 on the rim.
    const Lattice lattice = test::unitSquare(20);
    const KernelSamples samples(lattice, test::quinticSpline(2), LaplacianForm::morris);
    const MorrisSystem system(lattice, samples, wallEnds(lattice));
    EXPECT_EQ(samples.offsets.size(), 113U);
    EXPECT_EQ(system.matrix().entries(), 109U * lattice.points());
    EXPECT_TRUE(system.weights().empty());
}

TEST(MorrisSystem, CountsBeyondTwoThousandMillionEntriesAreRefused)
{
    const Lattice lattice = test::unitCube(256);
    const KernelSamples samples(lattice, test::sampledGaussian(4, 2, 4), LaplacianForm::morris);
    EXPECT_THAT(messageOf([&] { MorrisSystem(lattice, samples, wallEnds(lattice)); }),
                testing::HasSubstr("more than 2147 million entries"));
}

} // namespace
} // namespace isph
