// Flow between plates, the upper of which moves from t = 0 on: the velocity jumps there at the start, and the error is
// the memory of that.

#include "support/channelRun.hpp"
#include "support/record.hpp"

#include <array>
#include <numbers>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

double series(double y, double nut)
{
    double u = y;
    for (int n = 1; n < 200; ++n)
    {
        u += 2 / (n * pi) * (n % 2 == 0 ? 1 : -1) * std::sin(n * pi * y) * std::exp(-nut * n * n * pi * pi);
    }
    return u;
}

} // namespace

TEST(Couette, startUpFollowsTheSeries)
{
    EXPECT_NEAR(series(0.25, 0.1), 0.08834390591522203, 1e-14); // as evaluated with 30 digits
    struct Asked
    {
        int intervals;
        std::array<double, 2> most; // at nu t = 0.01, 0.1
    };
    double before = 0;
    for (const auto& [intervals, most] : {Asked{20, {2.3e-4, 2.2e-6}}, {40, {8e-6, 7.2e-8}}, {80, {3e-7, 2.4e-9}}})
    {
        BoundedRun run =
            channelRun({.intervals = intervals, .nu = 0.1, .upper = [](int c, double, double, double, double) {
                            return c == 0 ? 1.0 : 0.0;
                        }});
        run.start([](int, double, double, double) { return 0.0; });
        for (std::size_t i = 0; i < 2; ++i)
        {
            const double nut = i == 0 ? 0.01 : 0.1;
            marchExplicitly(run, nut / run.fluid.nu);
            const double error = errorOf(run, [nut](double y, double) { return series(y, nut); });
            record("nu t " + std::to_string(nut) + ", N " + std::to_string(intervals), error);
            EXPECT_LE(error, most[i]) << intervals;
            if (i == 0) { continue; }
            if (before > 0) { EXPECT_GE(observedOrder(before, error), 4.5) << intervals; }
            before = error;
        }
    }
}
