// poissonCost: a Poisson solve between walls against a forward and a backward real Fourier transform of the same size,
// and against a direct solve of the continued Laplacian.
//
//     OMP_NUM_THREADS=1 build/tests/poissonCost            channels, boxes and ducts
//     OMP_NUM_THREADS=1 build/tests/poissonCost 160        a channel and a box of one size
//
// Then transforms along single axes in units of the same r2c line by line, contiguous. The smallest of several
// repetitions counts, interleaved, because machines are noisy.

#include "continuation/SmoothGram.hpp"
#include "poisson/ContinuedHelmholtz.hpp"
#include "spectral/LineTransform.hpp"
#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"
#include "support/processorSecondsOf.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// Seconds of processor time of two pieces of work, in turn.
template<class First, class Second>
std::array<double, 2> smallest(First first, Second second)
{
    std::array<double, 2> best{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int round = 0; round < 20; ++round)
    {
        best[0] = std::min(best[0], processorSecondsOf(first));
        best[1] = std::min(best[1], processorSecondsOf(second));
    }
    return best;
}

Lattice withWalls(int n, const std::array<AxisEnds, 3>& ends, int dimensions)
{
    std::array<Axis, 3> axes;
    for (std::size_t d = 0; d < 3; ++d)
    {
        axes[d].name = std::array{'x', 'y', 'z'}[d];
        if (static_cast<int>(d) >= dimensions) { continue; }
        const bool periodic = ends[d].low == End::periodic;
        axes[d].extent = 1;
        axes[d].count = periodic ? n : n + 1;
        axes[d].ends = periodic ? Axis::Ends::periodic : Axis::Ends::bounded;
    }
    return Lattice(axes, {});
}

void measure(const std::string& name, int n, const std::array<AxisEnds, 3>& ends, int dimensions)
{
    const Lattice lattice = withWalls(n, ends, dimensions);
    BoundedPoisson poisson(lattice, ends, PlanEffort::measured);
    const RealField source = noise(lattice, 1, 1);
    RealField phi(1, lattice.points());
    std::vector<double> data;
    WallData walls;
    data.assign(lattice.points(), 0.1); // more than any face has points
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (ends[d].low == End::periodic) { continue; }
        const auto face = lattice.points() / static_cast<std::size_t>(lattice.axis(static_cast<int>(d)).count);
        walls[d] = {std::span(data).first(face), std::span(data).first(face)};
    }

    const Lattice box = dimensions == 2 ? unitSquare(n) : unitCube(n);
    FourierTransform transform(box, 1, PlanEffort::measured);
    RealField real = noise(box, 1, 2);
    SpectralField modes(1, transform.modes());

    const auto [solve, pair] = smallest([&] { poisson.solve(source, walls, phi); },
                                        [&]
                                        {
                                            transform.forward(real, modes);
                                            transform.backward(modes, real);
                                        });
    fmt::print("| {} | {:.3e} | {:.3e} | {:.2f} |\n", name + ", " + std::to_string(n), solve, pair, solve / pair);
    std::fflush(stdout);
}

/// ContinuedHelmholtz against BoundedPoisson.
void measureDirect(const std::string& name, int n, const std::array<AxisEnds, 3>& ends)
{
    const Lattice lattice = withWalls(n, ends, 2);
    Continuations continuations;
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (ends[d].low != End::periodic)
        {
            continuations[d] = std::make_unique<SmoothGram>(automaticNewPoints(n + 1));
        }
    }
    BoundedPoisson poisson(lattice, ends, PlanEffort::measured);
    ContinuedHelmholtz direct(lattice, continuedAxes(lattice, continuations, exactKernel(), ends),
                              PlanEffort::measured);
    const RealField source = noise(lattice, 1, 1);
    RealField phi(1, lattice.points());
    const auto [solve, fast] =
        smallest([&] { direct.solve(0, -1, source[0], {}, phi[0]); }, [&] { poisson.solve(source, {}, phi); });
    fmt::print("| {} | {:.3e} | {:.3e} | {:.2f} |\n", name + ", " + std::to_string(n), solve, fast, solve / fast);
    std::fflush(stdout);
}

void measureTransforms(int n)
{
    LineTransform packaged(n, n, PlanEffort::measured);
    const RealField lines = packaged.realLines();
    SpectralField modes = packaged.modesOfLines();
    const std::array<std::pair<const char*, RealBasis>, 5> bases{{{"fourier", RealBasis::fourier},
                                                                  {"cosine1", RealBasis::cosine1},
                                                                  {"sine1", RealBasis::sine1},
                                                                  {"cosine2", RealBasis::cosine2},
                                                                  {"cosine3", RealBasis::cosine3}}};
    for (const auto& [name, basis] : bases)
    {
        std::array<double, 2> ratios{};
        for (int axis = 0; axis < 2; ++axis)
        {
            const int count = basis == RealBasis::cosine1 ? n + 1 : basis == RealBasis::sine1 ? n - 1 : n;
            std::array<int, 3> extents{n, n, 1};
            extents[static_cast<std::size_t>(axis)] = count;
            const RealTransform transform({.extents = extents, .axis = axis, .count = count}, basis,
                                          PlanEffort::measured);
            // In place, and not normalised: zeros stay as they are.
            AlignedVector<double> values(static_cast<std::size_t>(extents[0]) * static_cast<std::size_t>(extents[1]));
            const auto [own, r2c] =
                smallest([&] { transform.forward(values); }, [&] { packaged.forward(lines, modes); });
            ratios[static_cast<std::size_t>(axis)] = own / r2c;
        }
        fmt::print("| {} | {} | {:.2f} | {:.2f} |\n", name, n, ratios[0], ratios[1]);
    }
}

} // namespace

int main(int argc, char** argv)
{
    const AxisEnds open{};
    const AxisEnds walls{End::neumann, End::neumann};
    const AxisEnds outlet{End::neumann, End::dirichlet};
    std::vector<int> sizes{64, 128, 256, 320, 512};
    if (argc > 1) { sizes = {std::stoi(argv[1])}; }

    fmt::print("Seconds are processor time of one thread, the least of several, taken in turn.\n\n"
               "| solve | solve [s] | r2c + c2r [s] | ratio |\n| --- | --- | --- | --- |\n");
    for (const int n : sizes) { measure("channel", n, {open, walls, open}, 2); }
    for (const int n : sizes) { measure("box", n, {walls, walls, open}, 2); }
    for (const int n : sizes) { measure("inlet to outlet", n, {outlet, walls, open}, 2); }
    if (argc == 1)
    {
        measure("duct", 64, {open, walls, walls}, 3);
        measure("cube", 64, {walls, walls, walls}, 3);
    }

    const AxisEnds rest{End::dirichlet, End::dirichlet};
    fmt::print("\n| continued Laplacian | direct [s] | series [s] | ratio |\n| --- | --- | --- | --- |\n");
    for (const int n : sizes) { measureDirect("channel, slopes", n, {open, walls, open}); }
    for (const int n : sizes) { measureDirect("box, slopes", n, {walls, walls, open}); }
    for (const int n : sizes) { measureDirect("box, values", n, {rest, rest, open}); }

    fmt::print("\nTransforms along an axis over the same r2c of contiguous lines:\n\n"
               "| transform | n | along x | along y |\n| --- | --- | --- | --- |\n");
    for (const int n : sizes) { measureTransforms(n); }
}
