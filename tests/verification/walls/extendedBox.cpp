// continuation extended: transforming the whole extended box, as Lin et al. 2026 do, gives the derivatives that lines
// give, to round-off (docs/theory/walls.md).

#include "continuation/Mirror.hpp"
#include "continuation/Polynomial.hpp"
#include "operators/ExtendedOperators.hpp"
#include "operators/lineSymbolOf.hpp"
#include "support/boundedRun.hpp"
#include "support/channelRun.hpp"
#include "support/flows.hpp"
#include "support/record.hpp"

#include <random>

using namespace isph;
using namespace isph::test;

namespace
{

Axis bounded(char name, int intervals, bool staggered = false)
{
    return {name, 0, 1, staggered ? intervals : intervals + 1, Axis::Ends::bounded, staggered};
}

double smooth(double x, double y, double z) { return std::exp(x) * std::sin(5 * y + 2 * x) + std::cos(3 * z - y); }

/// The largest difference of both ways to take a derivative, over the largest value, along every axis.
double difference(const Lattice& lattice, const Continuations& continuations, const ExtendedOperators::Ends& ends,
                  const KernelSettings& kernel, std::span<const double> values, const std::array<EndData, 3>& data = {})
{
    ExtendedOperators box(lattice, continuations, ends, kernel);
    box.take(values, data);
    double largest = 0;
    std::vector<double> slope(lattice.points());
    std::vector<double> curvature(lattice.points());
    std::vector<double> expected(lattice.points());
    std::vector<double> expectedCurvature(lattice.points());
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const int direction = lattice.direction(d);
        const auto at = static_cast<std::size_t>(direction);
        const Axis& axis = lattice.axis(direction);
        std::optional<LineContinuation> line;
        if (continuations[at]) { line.emplace(*continuations[at], axis.count, ends[at][0], ends[at][1]); }
        ContinuedTransform transform(linesAlong(lattice, direction), std::move(line), 1);
        const LineSymbol symbol =
            lineSymbolOf(kernel, LaplacianForm::secondDerivative, transform.length(), axis.spacing());
        ContinuedDerivative derivative(std::move(transform), symbol);
        derivative(values, expected, expectedCurvature, data[at]);

        box.derivative(d, slope);
        std::ranges::fill(curvature, 0.0);
        box.addTransport(d, {}, 1, curvature);
        double size = 0;
        double sizeOfSecond = 0;
        double first = 0;
        double second = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            size = std::max(size, std::abs(expected[i]));
            sizeOfSecond = std::max(sizeOfSecond, std::abs(expectedCurvature[i]));
            first = std::max(first, std::abs(slope[i] - expected[i]));
            second = std::max(second, std::abs(curvature[i] - expectedCurvature[i]));
        }
        largest = std::max({largest, first / size, second / sizeOfSecond});
    }
    return largest;
}

std::vector<double> valuesOf(const Lattice& lattice)
{
    const auto [x, y, z] = lattice.coordinates();
    std::vector<double> values(lattice.points());
    for (std::size_t i = 0; i < values.size(); ++i) { values[i] = smooth(x[i], y[i], z[i]); }
    return values;
}

/// Default continuations of the bounded axes.
Continuations smoothGrams(const Lattice& lattice) { return std::move(boundedSettings(lattice).continuations); }

} // namespace

TEST(ExtendedBox, hasTheDerivativesOfItsLines)
{
    const KernelSettings kernel = closedGaussian(20, 1.5);
    const Lattice box({bounded('x', 40), bounded('y', 32), Axis{.name = 'z'}}, {});
    const double inBox = difference(box, smoothGrams(box), {}, kernel, valuesOf(box));
    record("smooth, box", inBox);
    EXPECT_LE(inBox, 1e-11);

    const Lattice channel({bounded('x', 40), Axis{.name = 'y', .extent = 1, .count = 30}, Axis{.name = 'z'}}, {});
    EXPECT_LE(difference(channel, smoothGrams(channel), {}, kernel, valuesOf(channel)), 1e-11);

    const Lattice duct({Axis{.name = 'x', .extent = 1, .count = 12}, bounded('y', 20), bounded('z', 24)}, {});
    const double inDuct = difference(duct, smoothGrams(duct), {}, kernel, valuesOf(duct));
    record("smooth, duct", inDuct);
    EXPECT_LE(inDuct, 1e-11);

    const Lattice cuboid({bounded('x', 16), bounded('y', 20), bounded('z', 24)}, {});
    EXPECT_LE(difference(cuboid, smoothGrams(cuboid), {}, kernel, valuesOf(cuboid)), 1e-8);
}

TEST(ExtendedBox, takesWallDataOfMirrorsOnStaggeredPoints)
{
    const Lattice cuboid({bounded('x', 16, true), bounded('y', 20, true), bounded('z', 24, true)}, {});
    Continuations mirrors;
    std::array<std::vector<double>, 3> low;
    std::array<std::vector<double>, 3> high;
    std::array<EndData, 3> data;
    std::minstd_rand random(1);
    for (std::size_t d = 0; d < 3; ++d)
    {
        const Axis& axis = cuboid.axis(static_cast<int>(d));
        mirrors[d] = std::make_unique<Mirror>(axis.count, true, 2);
        for (auto* side : {&low[d], &high[d]})
        {
            side->resize(linesAlong(cuboid, static_cast<int>(d)).lines());
            for (double& value : *side) { value = static_cast<double>(random()) / std::minstd_rand::max(); }
        }
        data[d] = {low[d], high[d]};
    }
    ExtendedOperators::Ends ends{};
    ends[1] = {EndCondition::neumann, EndCondition::dirichlet};
    const double found = difference(cuboid, mirrors, ends, closedGaussian(4, 1.3), valuesOf(cuboid), data);
    record("mirrors", found);
    EXPECT_LE(found, 1e-12);
}

// The weights of a continuation grow as its extrapolation is long, those of a corner as their product.
TEST(ExtendedBox, bearsTheRoundOffOfItsCornersOnDataThatAreNotSmooth)
{
    const Lattice box({bounded('x', 40), bounded('y', 32), Axis{.name = 'z'}}, {});
    std::vector<double> values(box.points());
    std::minstd_rand random(1);
    for (double& value : values) { value = static_cast<double>(random()) / std::minstd_rand::max() - 0.5; }
    const double found = difference(box, smoothGrams(box), {}, closedGaussian(20, 1.5), values);
    record("noise", found);
    EXPECT_LE(found, 1e-7);
}

TEST(ExtendedBox, marchesAsItsLinesDo)
{
    const auto marched = [](bool extended, bool paper)
    {
        const Lattice lattice = unitBox(24, 32, true);
        FlowSettings settings = gaussianSettings(lattice);
        if (paper)
        {
            settings.kernel = closedGaussian(4, 1.3);
            settings.continuations[0] = std::make_unique<Polynomial>(6, 5, 12, 2);
            settings.continuations[1] = std::make_unique<Polynomial>(8, 5, 16, 2);
            settings.walls = WallTreatment::paper;
        }
        settings.extended = extended;
        std::array<std::array<FaceCondition, 2>, 3> faces;
        faces[0] = {wallAtRest("sides"), wallAtRest("sides")};
        faces[1] = {wallAtRest("walls"), movingWall(
                                             "walls",
                                             [](int c, double x, double, double, double t)
                                             { return c == 0 ? t * std::pow(4 * x * (1 - x), 2) : 0.0; },
                                             true)};
        BoundedRun run(lattice, {.nu = 0.01}, std::move(settings), std::move(faces));
        run.start([](int, double, double, double) { return 0.0; });
        run.march(0.2, 40);
        return copyOf(run.flow.velocity());
    };
    for (const bool paper : {false, true})
    {
        const RealField lines = marched(false, paper);
        const RealField box = marched(true, paper);
        double largest = 0;
        for (int c = 0; c < 2; ++c)
        {
            for (std::size_t i = 0; i < lines.size(); ++i)
            {
                largest = std::max(largest, std::abs(lines[c][i] - box[c][i]));
            }
        }
        record(paper ? "polynomial" : "smoothGram", largest);
        EXPECT_LE(largest, 1e-12);
    }
}
