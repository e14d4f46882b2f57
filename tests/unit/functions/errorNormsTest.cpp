#include "functions/ErrorNorms.hpp"
#include "Flows.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using namespace test;

/// An exact field from a formula of component, x, y, z, t.
class Formula : public ExactField
{
public:
    using Function = std::function<double(int, double, double, double, double)>;

    Formula(const Lattice& lattice, Function f) : points_(lattice.coordinates()), f_(std::move(f)) {}

    void evaluate(int component, double t, std::span<double> values) const override
    {
        for (std::size_t n = 0; n < values.size(); ++n)
        {
            values[n] = f_(component, points_[0][n], points_[1][n], points_[2][n], t);
        }
    }

private:
    std::array<std::vector<double>, 3> points_;
    Function f_;
};

std::unique_ptr<const ExactField> formula(const Lattice& lattice, Formula::Function f)
{
    return std::make_unique<Formula>(lattice, std::move(f));
}

class ErrorNormsTest : public testing::Test
{
protected:
    std::map<std::string, double> normsOf(const ErrorNorms& norms)
    {
        std::map<std::string, double> result;
        for (const ErrorNorm& norm : norms.errors()) { result[norm.norm + "(" + norm.field + ")"] = norm.value; }
        return result;
    }

    TemporaryFolder folder;
    std::filesystem::path file = folder.path / "errors.csv";
    Timings timings;
};

TEST_F(ErrorNormsTest, HaveTheColumnsOfTheContract)
{
    const Lattice lattice = square(4);
    GivenFlow flow(lattice);
    const auto zero = [](int, double, double, double, double) { return 0.0; };
    ErrorNorms norms(file, lattice, {formula(lattice, zero), formula(lattice, zero)}, {});
    EXPECT_TRUE(norms.errors().empty());
    EXPECT_FALSE(std::filesystem::exists(file)) << "nothing is written before the first execution";
    norms.execute(at(flow, timings, 0.25));
    EXPECT_EQ(linesOf(file),
              (std::vector<std::string>{"time [s],step,cpuTime [s],wallTime [s],L1(U) [m/s],L2(U) [m/s],Linf(U) [m/s],"
                                        "relL2(U),L1(p) [m2/s2],L2(p) [m2/s2],Linf(p) [m2/s2],relL2(p)",
                                        "0.25,3,1,2,0,0,0,0,0,0,0,0"}));
}

TEST_F(ErrorNormsTest, LeaveOutFieldsWithoutAnExactOne)
{
    const Lattice lattice = square(4);
    GivenFlow flow(lattice);
    ErrorNorms norms(file, lattice,
                     {nullptr, formula(lattice, [](int, double x, double, double, double) { return x; })},
                     {.scale = 1000, .unit = "Pa", .fixed = false});
    norms.execute(at(flow, timings, 0));
    EXPECT_EQ(linesOf(file)[0], "time [s],step,cpuTime [s],wallTime [s],L1(p) [Pa],L2(p) [Pa],Linf(p) [Pa],relL2(p)");
    EXPECT_EQ(norms.errors().size(), 4u);
}

// The exact velocity (t, 2) at t = 3 differs by (3, 4) at one of 16 points.
TEST_F(ErrorNormsTest, OfAVelocityGoByMagnitudes)
{
    const Lattice lattice = square(4);
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double, double, double) { return 3; });
    fill(flow.U, 1, lattice, [](double, double, double) { return 2; });
    flow.U[0][5] = 6;
    flow.U[1][5] = -2;
    ErrorNorms norms(
        file, lattice,
        {formula(lattice, [](int c, double, double, double, double t) { return c == 0   ? t
                                                                               : c == 1 ? 2
                                                                                        : 0; }),
         nullptr},
        {});
    norms.execute(at(flow, timings, 3));
    auto found = normsOf(norms);
    EXPECT_DOUBLE_EQ(found["L1(U)"], 5.0 / 16);
    EXPECT_DOUBLE_EQ(found["L2(U)"], 5.0 / 4);
    EXPECT_DOUBLE_EQ(found["Linf(U)"], 5);
    EXPECT_DOUBLE_EQ(found["relL2(U)"], 1.25 / std::sqrt(13.0));
    EXPECT_DOUBLE_EQ(readCsv(file)["relL2(U)"].at(0), found["relL2(U)"]);
}

// Axes x and z: the second component of the flow is U.z; an exact U.y counts as error.
TEST_F(ErrorNormsTest, MeetTheComponentsOfActiveAxes)
{
    const Lattice lattice = upright(4);
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double x, double, double) { return x; });
    fill(flow.U, 1, lattice, [](double, double, double z) { return 5 * z; });
    for (const double y : {0.0, 0.5})
    {
        ErrorNorms norms(file, lattice,
                         {formula(lattice, [y](int c, double x, double, double z, double)
                                  { return c == 0   ? x
                                           : c == 1 ? y
                                                    : 5 * z; }),
                          nullptr},
                         {});
        norms.execute(at(flow, timings, 0));
        EXPECT_DOUBLE_EQ(normsOf(norms)["Linf(U)"], y);
    }
}

TEST_F(ErrorNormsTest, OfAPressureIgnoreItsLevelUnlessThatIsFixed)
{
    const Lattice lattice = square(8);
    GivenFlow flow(lattice);
    fill(flow.p, 0, lattice, [](double x, double, double) { return std::sin(2 * pi * x); });
    const auto exact = [](int, double x, double, double, double) { return 7 + 2 * std::sin(2 * pi * x); };
    for (const bool fixed : {false, true})
    {
        ErrorNorms norms(file, lattice, {nullptr, formula(lattice, exact)}, {.fixed = fixed});
        norms.execute(at(flow, timings, 0));
        auto found = normsOf(norms);
        // Means over a period: of sin^2 a half, of sin nothing.
        EXPECT_NEAR(found["L2(p)"], fixed ? std::sqrt(49.5) : std::sqrt(0.5), 1e-14);
        EXPECT_NEAR(found["Linf(p)"], fixed ? 8 : 1, 1e-14);
        EXPECT_NEAR(found["relL2(p)"], fixed ? std::sqrt(49.5 / 51) : 0.5, 1e-14);
    }
}

TEST_F(ErrorNormsTest, ComparePressuresInTheUnitOfTheFiles)
{
    const Lattice lattice = square(8);
    GivenFlow flow(lattice);
    fill(flow.p, 0, lattice, [](double x, double, double) { return std::sin(2 * pi * x); });
    ErrorNorms norms(
        file, lattice,
        {nullptr, formula(lattice, [](int, double x, double, double, double) { return 800 * std::sin(2 * pi * x); })},
        {.scale = 1000, .unit = "Pa"});
    norms.execute(at(flow, timings, 0));
    EXPECT_NEAR(normsOf(norms)["Linf(p)"], 200, 1e-10);
    EXPECT_NEAR(normsOf(norms)["relL2(p)"], 0.25, 1e-14);
}

TEST_F(ErrorNormsTest, AreAbsoluteWhereTheExactFieldVanishes)
{
    const Lattice lattice = square(8);
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double, double, double) { return 1e-3; });
    fill(flow.p, 0, lattice, [](double x, double, double) { return 1e-3 * std::sin(2 * pi * x); });
    ErrorNorms norms(file, lattice,
                     {formula(lattice, [](int, double, double, double, double) { return 0; }),
                      formula(lattice, [](int, double, double, double, double) { return 0.1; })},
                     {});
    norms.execute(at(flow, timings, 0));
    EXPECT_DOUBLE_EQ(normsOf(norms)["relL2(U)"], 1e-3);
    EXPECT_NEAR(normsOf(norms)["relL2(p)"], 1e-3 * std::sqrt(0.5), 1e-15) << "0.1 less its mean is round-off";
}

// Viscous decay is integrated exactly, convection balances pressure: the error is round-off.
TEST_F(ErrorNormsTest, OfDecayingVorticesAreRoundOff)
{
    const double nu = 0.01;
    TaylorGreen vortices(16, nu);
    const auto U = [nu](int c, double x, double y, double, double t)
    {
        const double decay = std::exp(-8 * pi * pi * nu * t);
        if (c == 0) { return -std::cos(2 * pi * x) * std::sin(2 * pi * y) * decay; }
        return c == 1 ? std::sin(2 * pi * x) * std::cos(2 * pi * y) * decay : 0;
    };
    const auto p = [nu](int, double x, double y, double, double t)
    { return -0.25 * (std::cos(4 * pi * x) + std::cos(4 * pi * y)) * std::exp(-16 * pi * pi * nu * t); };
    ErrorNorms norms(file, vortices.lattice, {formula(vortices.lattice, U), formula(vortices.lattice, p)}, {});
    norms.execute(vortices.now());
    for (int step = 0; step < 20; ++step) { vortices.step(0.01); }
    norms.execute(vortices.now());
    auto columns = readCsv(file);
    EXPECT_EQ(columns["step"], (std::vector<double>{0, 20}));
    for (const char* norm : {"relL2(U)", "relL2(p)"})
    {
        for (const double value : columns[norm]) { EXPECT_LT(value, 1e-13); }
    }
}

} // namespace
} // namespace isph
