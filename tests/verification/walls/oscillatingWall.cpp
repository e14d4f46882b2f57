// Stokes' layer in a channel whose lower wall oscillates: two periods from the exact solution.

#include "support/channelRun.hpp"
#include "support/record.hpp"

#include <complex>
#include <numbers>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

constexpr double nu = 0.01;
constexpr double omega = 2 * pi;

double exact(double y, double t)
{
    using namespace std::complex_literals;
    const std::complex<double> m = std::sqrt(1i * omega / nu);
    return std::real(std::sinh(m * (1 - y)) / std::sinh(m) * std::exp(1i * omega * t));
}

double errorAt(int intervals, int degree)
{
    FlowSettings settings = boundedSettings(channelLattice(intervals), degree);
    settings.kernel.kernel = std::make_unique<Gaussian>(20);
    BoundedRun run = channelRun(
        {.intervals = intervals,
         .nu = nu,
         .lower = [](int c, double, double, double, double t) { return c == 0 ? std::cos(omega * t) : 0.0; }},
        std::move(settings));
    run.start([](int c, double, double y, double) { return c == 0 ? exact(y, 0) : 0.0; });
    marchExplicitly(run, 2);
    return errorOf(run, [](double y, double) { return exact(y, 2); });
}

} // namespace

TEST(OscillatingWall, errorFallsInFourthOrder)
{
    // Amplitude and phase as evaluated with 30 digits.
    EXPECT_NEAR(exact(0.1, 1), 0.1699155294675241 * std::cos(-1.772453850905509), 1e-14);
    for (const int degree : {4, 5})
    {
        double before = 0;
        for (const int intervals : {40, 80, 160})
        {
            const double error = errorAt(intervals, degree);
            record("degree " + std::to_string(degree) + ", N " + std::to_string(intervals), error);
            if (before > 0) { EXPECT_GE(observedOrder(before, error), degree) << intervals; }
            before = error;
        }
        EXPECT_LE(before, degree == 4 ? 1.1e-6 : 1.1e-7);
    }
}
