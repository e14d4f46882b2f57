#include "poisson/IterativePoisson.hpp"

#include "operators/DerivativeSymbol.hpp"
#include "poisson/FourierPoisson.hpp"
#include "poisson/MirroredPoisson.hpp"
#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"

#include <gtest/gtest.h>
#include <tuple>

namespace isph
{
namespace
{

/// The paper's quintic spline, or gaussian 4 cut at 4h.
KernelSettings kernelOf(bool gaussian) { return gaussian ? test::sampledGaussian(4, 2, 4) : test::quinticSpline(2); }

struct Box
{
    const char* name;
    std::array<int, 3> counts;
    std::array<double, 3> extents;
    std::array<bool, 3> bounded;
};

constexpr std::array boxes{
    Box{"periodic", {24, 20, 1}, {1, 1, 0}, {false, false, false}},
    Box{"channel", {24, 21, 1}, {1, 1, 0}, {false, true, false}},
    Box{"square", {22, 25, 1}, {1, 1.2, 0}, {true, true, false}},
    Box{"periodic3D", {12, 11, 13}, {1, 1, 1}, {false, false, false}},
    Box{"channel3D", {10, 12, 11}, {1, 1, 1}, {false, true, false}},
    Box{"cube", {11, 10, 12}, {1, 1, 1}, {true, true, true}},
};

Lattice latticeOf(const Box& box, bool staggered)
{
    std::array<Axis, 3> axes;
    constexpr std::array<char, 3> names{'x', 'y', 'z'};
    for (std::size_t d = 0; d < 3; ++d)
    {
        axes[d] = {.name = names[d],
                   .extent = box.extents[d],
                   .count = box.counts[d],
                   .ends = box.bounded[d] ? Axis::Ends::bounded : Axis::Ends::periodic,
                   .staggered = staggered};
    }
    return Lattice(axes, {});
}

class SameOperator : public testing::TestWithParam<std::tuple<Box, bool, bool>>
{
};

std::string nameOf(const testing::TestParamInfo<std::tuple<Box, bool, bool>>& info)
{
    const auto& [box, staggered, gaussian] = info.param;
    return std::string(box.name) + (staggered ? "_staggered" : "_collocated") +
           (gaussian ? "_gaussian4" : "_quinticSpline");
}

INSTANTIATE_TEST_SUITE_P(In, SameOperator, testing::Combine(testing::ValuesIn(boxes), testing::Bool(), testing::Bool()),
                         nameOf);

/// Slopes or values at all faces of bounded axes, random.
struct FaceNoise
{
    FaceNoise(const Lattice& lattice, const Box& box)
    {
        for (std::size_t d = 0; d < 3; ++d)
        {
            if (!box.bounded[d]) { continue; }
            const std::size_t points = lattice.points() / static_cast<std::size_t>(box.counts[d]);
            for (const unsigned side : {0U, 1U})
            {
                values.push_back(test::noise(lattice, 1, 100 + 2 * static_cast<unsigned>(d) + side));
                (side == 0 ? walls[d].low : walls[d].high) = std::as_const(values.back())[0].first(points);
            }
        }
    }

    std::vector<RealField> values;
    WallData walls;
};

TEST_P(SameOperator, TransformsAndIterationsGiveTheSamePressure)
{
    const auto& [box, staggered, gaussian] = GetParam();
    const Lattice lattice = latticeOf(box, staggered);
    const KernelSamples samples(lattice, kernelOf(gaussian), LaplacianForm::morris);
    const RealField source = test::noise(lattice, 1, 17);
    const FaceNoise data(lattice, box);

    RealField byTransforms(1, lattice.points());
    MirroredPoisson mirrored(lattice, samples, wallEnds(lattice));
    const double unbalanced = mirrored.solve(source, data.walls, byTransforms);
    if (lattice.periodic())
    {
        // The periodic solver of eigenvalues morris is the same operator, too.
        const ModeRows rows(lattice);
        FourierPoisson fourier(lattice, invertedEigenvalues(rows, laplacianSymbol(lattice, kernelOf(gaussian),
                                                                                  LaplacianForm::morris, &samples)));
        RealField phi(1, lattice.points());
        fourier.solve(source, phi);
        EXPECT_LE(test::relativeL2(phi, byTransforms), 1e-12);
    }
    for (const PressureSolver solver : {PressureSolver::biCGStab, PressureSolver::cg})
    {
        IterativePoisson iteration(lattice, samples, wallEnds(lattice), {.solver = solver});
        RealField phi(1, lattice.points());
        EXPECT_NEAR(iteration.solve(source, data.walls, phi), unbalanced, 1e-12 * std::abs(unbalanced) + 1e-13);
        EXPECT_TRUE(iteration.result().converged);
        EXPECT_LE(iteration.result().finalResidual, 1e-10);
        // A residual of 1e-10 is an error of at most that times the condition, here below 100.
        EXPECT_LE(test::relativeL2(phi, byTransforms), 1e-8) << iteration.result().iterations;
    }
}

/// Values at some ends, slopes at others: no null space, and points whose value is given.
TEST(IterativePoisson, TakesAnyMixOfEnds)
{
    constexpr AxisEnds slopes{End::neumann, End::neumann};
    constexpr AxisEnds outlet{End::neumann, End::dirichlet};
    constexpr AxisEnds values{End::dirichlet, End::dirichlet};
    const Box square{"square", {18, 21, 1}, {1, 1.2, 0}, {true, true, false}};
    const Box cube{"cube", {11, 10, 12}, {1, 1, 1}, {true, true, true}};
    struct Mix
    {
        Box box;
        std::array<AxisEnds, 3> ends;
    };
    for (const Mix& mix : {Mix{square, {outlet, slopes, AxisEnds{}}}, Mix{square, {values, values, AxisEnds{}}},
                           Mix{square, {slopes, values, AxisEnds{}}}, Mix{cube, {slopes, outlet, slopes}}})
    {
        for (const bool staggered : {false, true})
        {
            const Lattice lattice = latticeOf(mix.box, staggered);
            const KernelSamples samples(lattice, kernelOf(true), LaplacianForm::morris);
            const RealField source = test::noise(lattice, 1, 18);
            const FaceNoise data(lattice, mix.box);
            RealField byTransforms(1, lattice.points());
            EXPECT_EQ(MirroredPoisson(lattice, samples, mix.ends).solve(source, data.walls, byTransforms), 0);
            for (const PressureSolver solver : {PressureSolver::biCGStab, PressureSolver::cg})
            {
                IterativePoisson iteration(lattice, samples, mix.ends, {.solver = solver});
                RealField phi(1, lattice.points());
                EXPECT_EQ(iteration.solve(source, data.walls, phi), 0);
                EXPECT_TRUE(iteration.result().converged);
                EXPECT_LE(test::relativeL2(phi, byTransforms), 1e-8) << mix.box.name << staggered;
            }
        }
    }
}

} // namespace
} // namespace isph
