#include "transport/ScalarBoundary.hpp"

#include "core/Error.hpp"
#include "support/transportRun.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

ScalarField constant(double value)
{
    return [value](double, double, double, double) { return value; };
}

/// 5 x 4 points over the unit square.
Lattice smallBox() { return boxOf({4, 3, 0}, {true, true, false}); }

} // namespace

TEST(ScalarBoundary, overwritesThePointsOnFacesWithValues)
{
    ScalarFaces faces;
    faces[0] = {valueFace([](double, double y, double, double t) { return 10 * y + t; }), outflowFace()};
    faces[1] = {outflowFace(), insulatedFace()};
    ScalarBoundary boundary(smallBox(), std::move(faces));
    boundary.update(3);
    RealField T(1, 20);
    for (double& value : T[0]) { value = 7; }
    boundary.impose(T[0]);
    EXPECT_DOUBLE_EQ(T[0][0], 3);
    EXPECT_DOUBLE_EQ(T[0][5], 10.0 / 3 + 3);
    EXPECT_DOUBLE_EQ(T[0][15], 13);
    EXPECT_EQ(T[0][4], 7); // xMax, outflow
    EXPECT_EQ(T[0][1], 7);
}

TEST(ScalarBoundary, cornersTakeTheMeanOfTheirFaces)
{
    ScalarFaces faces;
    faces[0] = {valueFace(constant(1)), valueFace(constant(2))};
    faces[1] = {valueFace(constant(5)), insulatedFace()};
    ScalarBoundary boundary(smallBox(), std::move(faces));
    boundary.update(0);
    RealField T(1, 20);
    boundary.impose(T[0]);
    EXPECT_EQ(T[0][0], 3);   // of 1 and 5
    EXPECT_EQ(T[0][4], 3.5); // of 2 and 5
    EXPECT_EQ(T[0][15], 1);  // a derivative yields to a value
    EXPECT_EQ(boundary.largestValue(), 5);
}

TEST(ScalarBoundary, derivativesAreScaledToTheSpacing)
{
    ScalarFaces faces;
    faces[0] = {gradientFace([](double, double y, double, double) { return 1 + y; }), insulatedFace()};
    faces[1] = {outflowFace(), outflowFace()};
    ScalarBoundary boundary(smallBox(), std::move(faces));
    boundary.update(0);
    EXPECT_EQ(boundary.endCondition(0, Side::low), EndCondition::neumann);
    EXPECT_EQ(boundary.endCondition(1, Side::low), EndCondition::dirichlet);
    const EndData data = boundary.endData(0);
    EXPECT_THAT(std::vector(data.lower.begin(), data.lower.end()),
                ElementsAre(0.25, testing::DoubleEq(1.0 / 3), testing::DoubleEq(5.0 / 12), 0.5));
    EXPECT_THAT(std::vector(data.upper.begin(), data.upper.end()), ElementsAre(0, 0, 0, 0));
    EXPECT_TRUE(boundary.prescribesFlux());
}

TEST(ScalarBoundary, insulatedWallsPrescribeNoFlux)
{
    ScalarFaces faces;
    for (std::size_t d = 0; d < 2; ++d) { faces[d] = {insulatedFace(), insulatedFace()}; }
    EXPECT_FALSE(ScalarBoundary(smallBox(), std::move(faces)).prescribesFlux());
}

TEST(ScalarBoundary, staggeredPointsAreLeftAlone)
{
    ScalarFaces faces;
    for (std::size_t d = 0; d < 2; ++d) { faces[d] = {valueFace(constant(4)), outflowFace()}; }
    ScalarBoundary boundary(boxOf({4, 3, 0}, {true, true, false}, true), std::move(faces));
    boundary.update(0);
    RealField T(1, 12);
    boundary.impose(T[0]);
    EXPECT_EQ(largestMagnitude(T[0]), 0);
    EXPECT_THAT(std::vector(boundary.endData(0).lower.begin(), boundary.endData(0).lower.end()), ElementsAre(4, 4, 4));
    EXPECT_EQ(boundary.endCondition(0, Side::low), EndCondition::dirichlet);
    EXPECT_EQ(boundary.endCondition(0, Side::high), EndCondition::neumann); // what leaves is mirrored
}

TEST(ScalarBoundary, namesWhatEntersThroughAnOutlet)
{
    ScalarFaces faces;
    faces[0] = {valueFace(constant(0)), outflowFace()};
    faces[1] = {outflowFace(), insulatedFace()};
    faces[0][1].patch = "east";
    faces[1][0].patch = "south";
    const ScalarBoundary boundary(smallBox(), std::move(faces));
    RealField U(2, 20);
    for (double& u : U[0]) { u = 1; }
    EXPECT_THAT(boundary.inflowThroughOutflow(U), ElementsAre());
    U[1][2] = 0.5;
    EXPECT_THAT(boundary.inflowThroughOutflow(U), ElementsAre("south"));
    U[0][9] = -0.5;
    EXPECT_THAT(boundary.inflowThroughOutflow(U), ElementsAre("east", "south"));
}

TEST(ScalarBoundary, refusesWhatIsNoNumber)
{
    ScalarFaces faces;
    faces[0] = {valueFace([](double, double y, double, double) { return 1 / (y - 1.0 / 3); }), outflowFace()};
    faces[1] = {outflowFace(), outflowFace()};
    faces[0][0].patch = "inlet";
    ScalarBoundary boundary(smallBox(), std::move(faces));
    try
    {
        boundary.update(0);
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("what patch inlet prescribes is inf at (0 0.333333 0), t = 0 s"));
    }
}
