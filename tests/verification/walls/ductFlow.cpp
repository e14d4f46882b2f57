// Flow along a square duct, three-dimensional: from rest against the double series, and a mode that decays. Where two
// walls meet, a uniform force asks for a bent velocity that neither wall allows: the second derivatives jump in the
// corners, and the error of the series' flow falls in third order for any scheme. The mode is smooth.

#include "support/channelRun.hpp"
#include "support/record.hpp"

#include <numbers>
#include <vector>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

constexpr double nu = 0.1;

BoundedRun ductRun(int intervals, double force)
{
    Axis x{.name = 'x', .extent = 1, .count = 4};
    Axis y{.name = 'y', .extent = 1, .count = intervals + 1, .ends = Axis::Ends::bounded};
    Axis z = y;
    z.name = 'z';
    Lattice lattice({x, y, z}, {{"ends", Patch::Type::periodic, {"xMin", "xMax"}},
                                {"sides", Patch::Type::wall, {"yMin", "yMax", "zMin", "zMax"}}});
    std::array<std::array<FaceCondition, 2>, 3> faces;
    for (const std::size_t d : {1, 2}) { faces[d] = {wallAtRest("sides"), wallAtRest("sides")}; }
    Fluid fluid = channelFluid(lattice, {.intervals = intervals, .nu = nu, .force = force});
    FlowSettings settings = gaussianSettings(lattice);
    return BoundedRun(std::move(lattice), std::move(fluid), std::move(settings), std::move(faces));
}

/// Steps of at most 0.1 h^2/nu: two axes share the viscous limit.
void march(BoundedRun& run, int intervals, double end)
{
    run.march(end, static_cast<int>(std::ceil(end * nu * 10 * intervals * intervals)));
}

double fromRest(double y, double z, double t)
{
    double u = y * (1 - y) / 2;
    for (int m = 1; m < 200; m += 2)
    {
        u -= 4 / std::pow(m * pi, 3) * std::sin(m * pi * y) * std::cosh(m * pi * (z - 0.5)) / std::cosh(m * pi / 2);
    }
    for (int m = 1; m < 24; m += 2)
    {
        for (int n = 1; n < 24; n += 2)
        {
            const int k = m * m + n * n;
            u -= 16 / (std::pow(pi, 4) * m * n * k) * std::sin(m * pi * y) * std::sin(n * pi * z) *
                 std::exp(-nu * pi * pi * k * t);
        }
    }
    return u / nu;
}

} // namespace

TEST(DuctFlow, fromRestFollowsTheSeries)
{
    std::vector<double> errors;
    for (const int intervals : {12, 16, 24})
    {
        BoundedRun run = ductRun(intervals, 1);
        run.start([](int, double, double, double) { return 0.0; });
        march(run, intervals, 0.5);
        errors.push_back(errorOf(run, [](double y, double z) { return fromRest(y, z, 0.5); }));
        record("N " + std::to_string(intervals), errors.back());
    }
    EXPECT_LE(errors[0], 1.7e-4);
    EXPECT_LE(errors[2], 2.1e-5);
    EXPECT_GE(observedOrder(errors[0], errors[2]), 2.9);
}

TEST(DuctFlow, aModeDecaysInFourthOrder)
{
    std::vector<double> errors;
    for (const int intervals : {12, 24})
    {
        BoundedRun run = ductRun(intervals, 0);
        run.start([](int c, double, double y, double z)
                  { return c == 0 ? std::sin(pi * y) * std::sin(2 * pi * z) : 0.0; });
        march(run, intervals, 0.1);
        const double decay = std::exp(-5 * pi * pi * nu * 0.1);
        errors.push_back(
            errorOf(run, [decay](double y, double z) { return decay * std::sin(pi * y) * std::sin(2 * pi * z); }));
        record("N " + std::to_string(intervals), errors.back());
    }
    EXPECT_GE(observedOrder(errors[0], errors[1]), 4.0);
}
