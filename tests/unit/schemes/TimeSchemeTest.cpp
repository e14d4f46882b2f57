#include "schemes/TimeScheme.hpp"

#include <cmath>
#include <complex>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vector>

namespace isph
{
namespace
{

using Complex = std::complex<double>;

const TimeScheme& rungeKutta3() { return *timeSchemes()[Word{"RK3", {}}]; }
const TimeScheme& forwardEuler() { return *timeSchemes()[Word{"firstOrderProjection", {}}]; }

/// An ordinary differential equation, advanced as a flow is: u += dt (g F + z F before).
class Equation : public IncompressibleSystem
{
public:
    Equation(std::function<Complex(double, Complex)> rate, Complex start) : u(start), rate_(std::move(rate)) {}

    void advance(const Substep& substep, double t, double dt) override
    {
        const Complex rate = rate_(t + substep.start * dt, u);
        u += dt * (substep.g * rate + substep.z * before_);
        before_ = rate;
    }

    Complex u;

private:
    std::function<Complex(double, Complex)> rate_;
    Complex before_ = 1e300; // must not be used by a first substep
};

Complex solution(const TimeScheme& scheme, Equation equation, double end, int steps)
{
    for (int n = 0; n < steps; ++n) { advance(scheme, equation, n * end / steps, end / steps); }
    return equation.u;
}

/// Observed order between 40 and 80 steps.
double order(const TimeScheme& scheme, const Equation& equation, double end, Complex exact)
{
    const double coarse = std::abs(solution(scheme, equation, end, 40) - exact);
    const double fine = std::abs(solution(scheme, equation, end, 80) - exact);
    return std::log2(coarse / fine);
}

TEST(TimeSchemes, SubstepsFillTheStep)
{
    for (const TimeScheme* scheme : {&rungeKutta3(), &forwardEuler()})
    {
        double time = 0;
        for (const Substep& substep : scheme->substeps)
        {
            EXPECT_DOUBLE_EQ(substep.start, time);
            EXPECT_NEAR(substep.a, substep.g + substep.z, 2e-16) << "a = g + z";
            EXPECT_DOUBLE_EQ(substep.a, static_cast<double>(substep.numerator) / substep.denominator);
            EXPECT_EQ(substep.first, &substep == &scheme->substeps.front());
            EXPECT_EQ(substep.last, &substep == &scheme->substeps.back());
            time += substep.a;
        }
        EXPECT_DOUBLE_EQ(time, 1);
        EXPECT_EQ(scheme->substeps.front().z, 0) << "the first substep knows no rate before";
    }
    EXPECT_EQ(rungeKutta3().order, 3);
    EXPECT_EQ(forwardEuler().order, 1);
    EXPECT_FALSE(rungeKutta3() == forwardEuler());
    EXPECT_TRUE(rungeKutta3() == rungeKutta3());
}

TEST(TimeSchemes, MeetTheOrderConditions)
{
    // Butcher tableau of the low-storage scheme: rates F1 .. F3 at c, weights b.
    const auto& s = rungeKutta3().substeps;
    const double c2 = s[0].a;
    const double c3 = s[0].a + s[1].a;
    const double b1 = s[0].g + s[1].z;
    const double b2 = s[1].g + s[2].z;
    const double b3 = s[2].g;
    const double a32 = s[1].g;
    EXPECT_NEAR(b1 + b2 + b3, 1, 4e-16);
    EXPECT_NEAR(b2 * c2 + b3 * c3, 1.0 / 2, 4e-16);
    EXPECT_NEAR(b2 * c2 * c2 + b3 * c3 * c3, 1.0 / 3, 4e-16);
    EXPECT_NEAR(b3 * a32 * c2, 1.0 / 6, 4e-16);
}

TEST(TimeSchemes, MarchALinearEquationWithTheirOrder)
{
    for (const Complex lambda : {Complex(-1, 0), Complex(0, 3), Complex(-1, 2)})
    {
        const Equation equation([lambda](double, Complex u) { return lambda * u; }, 1.0);
        // The next term of the error is lambda dt of the leading one: 3/40 of an order, or less.
        EXPECT_NEAR(order(rungeKutta3(), equation, 1, std::exp(lambda)), 3, 0.08) << lambda;
        EXPECT_NEAR(order(forwardEuler(), equation, 1, std::exp(lambda)), 1, 0.08) << lambda;
    }
}

TEST(TimeSchemes, MarchANonlinearEquationWithTheirOrder)
{
    // u' = 2 t u^2 from u(0) = 1/2: u = 1/(2 - t^2).
    const Equation equation([](double t, Complex u) { return 2 * t * u * u; }, 0.5);
    EXPECT_NEAR(order(rungeKutta3(), equation, 1, 1.0), 3, 0.1);
    EXPECT_NEAR(order(forwardEuler(), equation, 1, 1.0), 1, 0.1);
}

TEST(TimeSchemes, AmplifyByTheExponentialsSeries)
{
    for (const Complex z : {Complex(-2, 0), Complex(0, 1.7), Complex(-1, 1)})
    {
        const Equation equation([z](double, Complex u) { return z * u; }, 1.0);
        const Complex three = 1.0 + z + z * z / 2.0 + z * z * z / 6.0;
        EXPECT_NEAR(std::abs(solution(rungeKutta3(), equation, 1, 1) - three), 0, 4e-15); // a dozen terms up to 4
        EXPECT_NEAR(std::abs(solution(forwardEuler(), equation, 1, 1) - (1.0 + z)), 0, 1e-15);
    }
}

TEST(TimeSchemes, AreListed)
{
    EXPECT_THAT(timeSchemes().names(), testing::ElementsAre("RK3", "firstOrderProjection"));
}

} // namespace
} // namespace isph
