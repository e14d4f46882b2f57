// substepCost: one RK3 substep against the transforms it contains, on the same buffers in the same run.
//
//     OMP_NUM_THREADS=1 build/tests/substepCost            the default scene in 2-D and 3-D
//     OMP_NUM_THREADS=1 build/tests/substepCost 160        one 2-D size
//
// Prints seconds of processor time and their ratio; the smallest of several repetitions counts on both sides, in turn,
// because machines are noisy.

#include "fields/reductions.hpp"
#include "support/flows.hpp"
#include "support/periodicBox.hpp"
#include "support/processorSecondsOf.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <limits>
#include <string>

using namespace isph;
using namespace isph::test;

namespace
{

/// The defaults of a periodic box: gaussian 10 at h/dx 1.5, divergence form, two thirds, integrating factor.
FlowSettings defaultSettings()
{
    FlowSettings settings = plainSettings(closedGaussian(10, 1.5));
    settings.integratingFactor = true;
    settings.exactMeanFlow = true;
    settings.dealiasing = Dealiasing::twoThirds;
    return settings;
}

void measure(const Lattice& lattice, const std::string& name)
{
    const FlowSettings settings = defaultSettings();
    const Fluid fluid{.nu = 0.01};
    Timings timings;
    const int d = lattice.dimensions();
    SpectralFlow flow(lattice, fluid, settings, timings);
    // Without a mean flow, which would cost phase factors.
    RealField start = noise(lattice, d, 1);
    for (int c = 0; c < d; ++c)
    {
        const double mean = sum(start[c]) / static_cast<double>(lattice.points());
        for (double& value : start[c]) { value -= mean; }
    }
    flow.start(start, true);
    const double dt = 0.1 * largestStableStep(*settings.time, flow.rates());

    // The transforms of a substep alone, on buffers of the same size.
    const int products = d == 2 ? 2 : 5;
    FourierTransform inputs(lattice, d, PlanEffort::measured);
    FourierTransform outputs(lattice, products, PlanEffort::measured);
    RealField velocity = noise(lattice, d, 2);
    RealField product = noise(lattice, products, 3);
    SpectralField velocityModes(d, inputs.modes());
    SpectralField productModes(products, outputs.modes());

    const int repetitions = std::max(1, static_cast<int>(2e6 / static_cast<double>(lattice.points())));
    double step = std::numeric_limits<double>::infinity();
    double transforms = step;
    for (int round = 0; round < 15; ++round)
    {
        const auto repeated = [](int times, auto work)
        {
            return processorSecondsOf(
                       [&]
                       {
                           for (int i = 0; i < times; ++i) { work(); }
                       }) /
                   times;
        };
        step = std::min(step, repeated(repetitions,
                                       [&]
                                       {
                                           flow.rates();
                                           advance(*settings.time, flow, 0, dt);
                                       }));
        transforms = std::min(transforms, repeated(3 * repetitions,
                                                   [&]
                                                   {
                                                       inputs.backward(velocityModes, velocity);
                                                       outputs.forward(product, productModes);
                                                   }));
    }
    const double substep = step / 3;
    fmt::print("| {} | {:.3e} | {:.3e} | {:.2f} | {:.2f} |\n", name, substep, transforms, substep / transforms,
               1e9 * substep / static_cast<double>(lattice.points()));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    fmt::print("A substep of RK3 with the defaults of a periodic box, beside the transforms it contains, on buffers of "
               "the same size.\nSeconds are processor time of one thread, the least of several, taken in turn.\n\n"
               "| lattice | substep [s] | transforms [s] | ratio | ns per point |\n| --- | --- | --- | --- | --- |\n");
    if (argc > 1)
    {
        measure(unitSquare(std::stoi(argv[1])), std::string(argv[1]) + "^2");
        return 0;
    }
    for (const int n : {160, 256, 320, 512, 640, 1024}) { measure(unitSquare(n), std::to_string(n) + "^2"); }
    for (const int n : {64, 128}) { measure(unitCube(n), std::to_string(n) + "^3"); }
}
