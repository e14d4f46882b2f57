#include "boundary/FlowBoundary.hpp"

#include "boxes.hpp"
#include "support/messageOf.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace isph
{
namespace
{

using std::numbers::pi;
using test::AxisKind;
using test::box;
using test::changing;
using test::Faces;
using test::steady;
using test::uniform;
using test::walls;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::array<AxisKind, 3> closedSquare{AxisKind::collocated, AxisKind::collocated, AxisKind::leftOut};
constexpr std::array<AxisKind, 3> channel{AxisKind::periodic, AxisKind::collocated, AxisKind::leftOut};
constexpr std::array<AxisKind, 3> closedCube{AxisKind::collocated, AxisKind::collocated, AxisKind::collocated};

/// A velocity field that is 9 everywhere, with the boundary's values imposed.
RealField imposed(const FlowBoundary& boundary, const Lattice& lattice)
{
    RealField U(lattice.dimensions(), lattice.points());
    for (int d = 0; d < U.components(); ++d) { std::ranges::fill(U[d], 9.0); }
    boundary.impose(U);
    return U;
}

TEST(FlowBoundary, AMovingLidOwnsItsCorners)
{
    const Lattice lattice = box(closedSquare, {4, 3, 1});
    Faces faces = walls();
    faces[1][1].U = uniform({1, 0, 0});
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);

    const RealField U = imposed(boundary, lattice);
    EXPECT_THAT(U[0], ElementsAre(0, 0, 0, 0, 0, 9, 9, 0, 1, 1, 1, 1));
    EXPECT_THAT(U[1], ElementsAre(0, 0, 0, 0, 0, 9, 9, 0, 0, 0, 0, 0));
    EXPECT_THAT(boundary.velocity(0, Side::low, 0), ElementsAre(0, 0, 1));
    EXPECT_THAT(boundary.velocity(0, Side::high, 0), ElementsAre(0, 0, 1));
    EXPECT_THAT(boundary.velocity(1, Side::high, 0), Each(1));
    EXPECT_FALSE(boundary.dependsOnTime());
    EXPECT_FALSE(boundary.fixesPressure());
    EXPECT_TRUE(boundary.flowsThroughCorners());
}

TEST(FlowBoundary, NothingFlowsThroughTheCornersOfWallsAtRest)
{
    const Lattice lattice = box(closedSquare, {4, 3, 1});
    FlowBoundary boundary(lattice, walls());
    boundary.update(0);
    EXPECT_FALSE(boundary.flowsThroughCorners());
}

TEST(FlowBoundary, NormalComponentsAloneLetTheRestSlip)
{
    const Lattice lattice = box(closedSquare, {4, 3, 1});
    Faces faces = walls();
    faces[0][0].U = uniform({2, 0.5, 0});
    faces[1][1].U = uniform({1, 0, 0});
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);

    RealField U(lattice.dimensions(), lattice.points());
    for (int d = 0; d < U.components(); ++d) { std::ranges::fill(U[d], 9.0); }
    boundary.imposeNormal(U);
    EXPECT_THAT(U[0], ElementsAre(2, 9, 9, 0, 2, 9, 9, 0, 2, 9, 9, 0));
    EXPECT_THAT(U[1], ElementsAre(0, 0, 0, 0, 9, 9, 9, 9, 0, 0, 0, 0));
}

TEST(FlowBoundary, PrescribedComesBeforeSlipAndSlipBeforeOutflow)
{
    const Lattice lattice = box(closedSquare, {3, 3, 1});
    Faces faces = walls();
    faces[0][0].U = uniform({2, 0.5, 0}); // an inlet that also climbs
    faces[0][1].velocity = VelocityCondition::outflow;
    faces[0][1].pressure = PressureCondition::value;
    faces[1][0].velocity = VelocityCondition::slip;
    faces[1][1].velocity = VelocityCondition::value;
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);

    const RealField U = imposed(boundary, lattice);
    EXPECT_THAT(U[0], ElementsAre(2, 9, 9, 2, 9, 9, 2, 0, 0));
    EXPECT_THAT(U[1], ElementsAre(0.5, 0, 0, 0.5, 9, 9, 0.5, 0, 0));
    EXPECT_THAT(boundary.velocity(1, Side::low, 0), IsEmpty());
    EXPECT_THAT(boundary.velocity(1, Side::low, 1), ElementsAre(0.5, 0, 0));
    EXPECT_THAT(boundary.velocity(0, Side::high, 0), IsEmpty());
    EXPECT_TRUE(boundary.fixesPressure());
}

TEST(FlowBoundary, WhereTwoFacesSlipBothNormalComponentsVanish)
{
    const Lattice lattice = box(closedSquare, {3, 3, 1});
    Faces faces = walls();
    for (std::size_t a = 0; a < 2; ++a)
    {
        for (FaceCondition& face : faces[a]) { face.velocity = VelocityCondition::slip; }
    }
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);
    const RealField U = imposed(boundary, lattice);
    EXPECT_THAT(U[0], ElementsAre(0, 9, 0, 0, 9, 0, 0, 9, 0));
    EXPECT_THAT(U[1], ElementsAre(0, 0, 0, 9, 9, 9, 0, 0, 0));
}

TEST(FlowBoundary, InThreeDimensionsEdgesAndCornersBelongToTheFastest)
{
    const std::array<int, 3> n{4, 5, 3};
    const Lattice lattice = box(closedCube, n);
    Faces faces = walls();
    faces[1][1].U = uniform({1, 0, 0.5});
    faces[2][0].U = uniform({0, 0.2, 0});
    faces[0][1].velocity = VelocityCondition::slip;
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);
    const RealField U = imposed(boundary, lattice);
    std::size_t i = 0;
    for (int iz = 0; iz < n[2]; ++iz)
    {
        for (int iy = 0; iy < n[1]; ++iy)
        {
            for (int ix = 0; ix < n[0]; ++ix, ++i)
            {
                const bool lid = iy == n[1] - 1;
                const bool floor = iz == 0;
                const bool wall = ix == 0 || iy == 0 || iz == n[2] - 1;
                const bool slip = ix == n[0] - 1;
                std::array<double, 3> expected{9, 9, 9};
                if (lid) { expected = {1, 0, 0.5}; }
                else if (floor) { expected = {0, 0.2, 0}; }
                else if (wall) { expected = {0, 0, 0}; }
                else if (slip) { expected[0] = 0; }
                EXPECT_THAT((std::array{U[0][i], U[1][i], U[2][i]}), testing::ElementsAreArray(expected))
                    << ix << " " << iy << " " << iz;
            }
        }
    }
}

TEST(FlowBoundary, DataOfFacesAgreeWithWhatIsImposed)
{
    const Lattice lattice = box(closedCube, {4, 3, 5});
    Faces faces = walls();
    const auto swirl = [](int c, double x, double y, double z, double t)
    { return std::sin(t + 1.3 * c + 2 * x - y + 3 * z); };
    for (auto& ends : faces)
    {
        for (FaceCondition& face : ends) { face.U = changing(swirl); }
    }
    faces[2][1].velocity = VelocityCondition::slip;
    FlowBoundary boundary(lattice, std::move(faces));
    EXPECT_TRUE(boundary.dependsOnTime());
    for (const double t : {0.0, 0.7})
    {
        boundary.update(t);
        const RealField U = imposed(boundary, lattice);
        const auto xyz = lattice.coordinates();
        for (int direction = 0; direction < 3; ++direction)
        {
            for (const Side side : {Side::low, Side::high})
            {
                const auto at = boundary.coordinates(direction, side);
                for (int d = 0; d < 3; ++d)
                {
                    const auto data = boundary.velocity(direction, side, d);
                    for (std::size_t i = 0; i < data.size(); ++i)
                    {
                        std::size_t point = 0;
                        while (xyz[0][point] != at[0][i] || xyz[1][point] != at[1][i] || xyz[2][point] != at[2][i])
                        {
                            ++point;
                        }
                        ASSERT_EQ(U[d][point], data[i]);
                    }
                }
            }
        }
    }
}

TEST(FlowBoundary, OnlyWhatChangesIsEvaluatedAgain)
{
    const Lattice lattice = box(closedSquare, {4, 4, 1});
    Faces faces = walls();
    int steadyCalls = 0;
    int changingCalls = 0;
    int pressureCalls = 0;
    faces[1][1].U =
        changing([](int c, double, double, double, double t) { return c == 0 ? std::cos(t) : 0.0; }, &changingCalls);
    faces[0][0].U = steady([](int c, double, double, double, double) { return c == 1 ? 0.5 : 0.0; }, &steadyCalls);
    faces[0][1].pressure = PressureCondition::gradient;
    faces[0][1].p = steady([](int, double, double y, double, double) { return y; }, &pressureCalls);
    FlowBoundary boundary(lattice, std::move(faces));
    ASSERT_TRUE(boundary.dependsOnTime());

    boundary.update(0);
    EXPECT_DOUBLE_EQ(boundary.velocity(0, Side::low, 0)[3], 1); // the lid is the faster one
    EXPECT_DOUBLE_EQ(boundary.velocity(0, Side::low, 1)[3], 0);
    boundary.update(pi / 2);
    EXPECT_DOUBLE_EQ(boundary.velocity(0, Side::low, 1)[3], 0.5); // the wall gets its corner back
    EXPECT_DOUBLE_EQ(boundary.velocity(1, Side::high, 1)[0], 0.5);
    EXPECT_DOUBLE_EQ(boundary.velocity(1, Side::high, 1)[1], 0);
    boundary.update(pi);
    EXPECT_DOUBLE_EQ(boundary.velocity(0, Side::low, 0)[3], -1);
    EXPECT_EQ(steadyCalls, 2); // its components, once
    EXPECT_EQ(changingCalls, 6);
    EXPECT_EQ(pressureCalls, 1);
    EXPECT_THAT(boundary.pressure(0, Side::high),
                ElementsAre(0, testing::DoubleEq(1.0 / 3), testing::DoubleEq(2.0 / 3), 1));
    EXPECT_THAT(boundary.pressure(0, Side::low), IsEmpty());
}

TEST(FlowBoundary, DataOfStaggeredAxesBelongToTheFeetOfThePoints)
{
    const Lattice lattice = box({AxisKind::staggered, AxisKind::staggered, AxisKind::leftOut}, {4, 2, 1});
    Faces faces = walls();
    faces[1][1].U = steady([](int c, double x, double y, double, double) { return c == 0 ? x + 10 * y : 0; });
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);
    EXPECT_THAT(boundary.velocity(1, Side::high, 0), ElementsAre(10.125, 10.375, 10.625, 10.875));
    EXPECT_THAT(boundary.velocity(0, Side::low, 0), ElementsAre(0, 0));
    EXPECT_THAT(boundary.coordinates(0, Side::high)[0], ElementsAre(1, 1));
    EXPECT_THAT(boundary.coordinates(0, Side::high)[1], ElementsAre(0.25, 0.75));
    const RealField U = imposed(boundary, lattice);
    EXPECT_THAT(U[0], Each(9));
    EXPECT_THAT(U[1], Each(9));
}

TEST(FlowBoundary, PeriodicLatticesHaveNoData)
{
    const Lattice lattice = box({AxisKind::periodic, AxisKind::periodic, AxisKind::leftOut}, {4, 4, 1});
    FlowBoundary boundary(lattice, Faces());
    boundary.update(0);
    EXPECT_FALSE(boundary.dependsOnTime());
    EXPECT_FALSE(boundary.fixesPressure());
    EXPECT_THAT(boundary.velocity(0, Side::low, 0), IsEmpty());
    EXPECT_THAT(imposed(boundary, lattice)[0], Each(9));
    EXPECT_EQ(boundary.flux().in, 0);
}

TEST(FlowBoundary, FluxOfInletsAndOutlets)
{
    const Lattice lattice = box(closedSquare, {5, 9, 1});
    Faces faces = walls();
    faces[0][0].U = steady([](int c, double, double y, double, double) { return c == 0 ? 6 * y * (1 - y) : 0; });
    faces[0][1].U = uniform({1, 0, 0});
    faces[1][1].U = uniform({7, 0, 0}); // along the face: nothing flows, not even at its corners
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);
    const FlowBoundary::Flux plain = boundary.flux();
    EXPECT_NEAR(plain.in, 1 - 1.0 / 64, 1e-14); // of the trapezoidal rule: 1 - 1/n^2
    EXPECT_NEAR(plain.out, 1, 1e-14);
    const FlowBoundary::Flux corrected = boundary.flux(FlowBoundary::Quadrature::endCorrected);
    EXPECT_NEAR(corrected.in, 1, 1e-14);
    EXPECT_NEAR(corrected.out, 1, 1e-14);
}

TEST(FlowBoundary, FluxThroughFacesWithPeriodicAndStaggeredAxes)
{
    const auto blowing = [](const Lattice& lattice)
    {
        Faces faces = walls();
        faces[1][0].U =
            steady([](int c, double x, double, double, double) { return c == 1 ? 2 + std::sin(2 * pi * x) : 0.0; });
        faces[1][1].U = steady([](int c, double x, double, double z, double)
                               { return c == 1 ? 2 + std::cos(2 * pi * x) + (z - 0.5) : 0.0; });
        FlowBoundary boundary(lattice, std::move(faces));
        boundary.update(0);
        return boundary.flux();
    };
    const FlowBoundary::Flux flat =
        blowing(box({AxisKind::periodic, AxisKind::collocated, AxisKind::periodic}, {8, 5, 4}));
    EXPECT_NEAR(flat.in, 2, 1e-14);
    EXPECT_NEAR(flat.out, 2 - 0.125, 1e-14); // points z = 0, 1/4, 1/2, 3/4
    const FlowBoundary::Flux duct =
        blowing(box({AxisKind::periodic, AxisKind::staggered, AxisKind::staggered}, {8, 5, 4}));
    EXPECT_NEAR(duct.in, 2, 1e-14);
    EXPECT_NEAR(duct.out, 2, 1e-14);
}

TEST(FlowBoundary, CorrectedFluxIsExactForCubicsAndHighOrderBeyond)
{
    const auto error = [](AxisKind kind, int n, const std::function<double(double)>& f, double exact)
    {
        const Lattice lattice = box({AxisKind::collocated, kind, AxisKind::leftOut}, {3, n, 1});
        Faces faces = walls();
        faces[0][0].U = steady([f](int c, double, double y, double, double) { return c == 0 ? f(y) : 0; });
        FlowBoundary boundary(lattice, std::move(faces));
        boundary.update(0);
        return std::abs(boundary.flux(FlowBoundary::Quadrature::endCorrected).in - exact);
    };
    for (const AxisKind kind : {AxisKind::collocated, AxisKind::staggered})
    {
        EXPECT_LT(error(
                      kind, 8, [](double y) { return 1 + y + y * y + 4 * y * y * y; }, 1 + 0.5 + 1.0 / 3 + 1),
                  1e-14);
        const auto wave = [](double y) { return std::exp(y); };
        const double coarse = error(kind, 16, wave, std::exp(1.0) - 1);
        const double fine = error(kind, 32, wave, std::exp(1.0) - 1);
        EXPECT_GT(std::log2(coarse / fine), 4.5);
    }
}

TEST(FlowBoundary, FacesContradictEachOtherOnlyWhereBothMove)
{
    const auto contradiction = [](std::array<double, 3> lid, std::array<double, 3> side)
    {
        const Lattice lattice = box(closedSquare, {4, 4, 1});
        Faces faces = walls();
        faces[1][1].U = uniform(lid);
        faces[0][1].U = uniform(side);
        FlowBoundary boundary(lattice, std::move(faces));
        boundary.update(0);
        return boundary.contradiction();
    };
    EXPECT_FALSE(contradiction({1, 0, 0}, {0, 0, 0}));
    EXPECT_FALSE(contradiction({1, 0, 0}, {1, 0, 0}));
    EXPECT_FALSE(contradiction({1, 0, 0}, {1 + 1e-8, 0, 0}));
    EXPECT_FALSE(contradiction({1, 0, 0}, {0, 1e-16, 0}));
    const auto found = contradiction({1, 0, 0}, {0, 2, 0});
    ASSERT_TRUE(found);
    EXPECT_THAT(found->patches, ElementsAre("xMax", "yMax"));
    EXPECT_THAT(found->velocities[0], ElementsAre(0, 2, 0));
    EXPECT_THAT(found->velocities[1], ElementsAre(1, 0, 0));
    EXPECT_THAT(found->point, ElementsAre(1, 1, 0));
}

TEST(FlowBoundary, ValuesThatAreNotFiniteNamePatchPointAndTime)
{
    const Lattice lattice = box(channel, {4, 5, 1});
    Faces faces = walls();
    faces[1][1].U =
        changing([](int c, double x, double, double, double t) { return c == 0 && x == 0.5 ? 1 / (2 - t) : 0.0; });
    faces[1][0].pressure = PressureCondition::gradient;
    faces[1][0].p = changing([](int, double x, double, double, double t)
                             { return x == 0.25 && t == 3 ? std::numeric_limits<double>::quiet_NaN() : 0.0; });
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(1);
    EXPECT_EQ(boundary.velocity(1, Side::high, 0)[2], 1);
    EXPECT_EQ(messageOf([&] { boundary.update(2); }),
              "the velocity that patch yMax prescribes is inf at (0.5 1 0), t = 2 s\n"
              "    look for a division by zero, or a root or logarithm of a negative number");
    EXPECT_EQ(messageOf([&] { boundary.update(3); }),
              "the pressure gradient that patch yMin prescribes is nan at (0.25 0 0), t = 3 s\n"
              "    look for a division by zero, or a root or logarithm of a negative number");
}

} // namespace
} // namespace isph
