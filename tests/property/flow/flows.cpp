// What must hold for any flow: random velocities, boxes, kernels, forms and steps.

#include "support/flowRun.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <random>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// A scene drawn from a seed: everything a box may be and every word of the schemes.
class RandomScene
{
public:
    explicit RandomScene(unsigned seed) : engine_(seed), seed_(seed)
    {
        dimensions_ = pick(3) == 0 ? 3 : 2;
        for (int d = 0; d < dimensions_; ++d)
        {
            counts_[static_cast<std::size_t>(d)] = dimensions_ == 3 ? 4 + pick(8) : 4 + pick(25);
            extents_[static_cast<std::size_t>(d)] = std::pow(10.0, uniform(-1.5, 1.5));
        }
        kernel_ = pick(4);
        smoothingLength_ = uniform(0.8, 2);
        order_ = 2 * (1 + pick(8));
        form_ = static_cast<ConvectionForm>(pick(4));
        laplacian_ = pick(2) == 0 ? LaplacianForm::morris : LaplacianForm::exact;
        integratingFactor_ = pick(2) == 0;
        exactMeanFlow_ = pick(2) == 0;
        dealiased_ = pick(2) == 0;
        filtered_ = pick(3) == 0;
        nu_ = pick(4) == 0 ? 0 : std::pow(10.0, uniform(-4, -1));
    }

    Lattice lattice() const { return periodicBox(counts_, extents_); }
    const std::array<int, 3>& counts() const { return counts_; }
    const std::array<double, 3>& extents() const { return extents_; }
    double nu() const { return nu_; }
    ConvectionForm form() const { return form_; }

    FlowSettings settings() const
    {
        FlowSettings settings = plainSettings(kernel());
        settings.convection = form_;
        settings.laplacian = laplacian_;
        settings.integratingFactor = integratingFactor_;
        settings.exactMeanFlow = exactMeanFlow_;
        settings.dealiasing = dealiased_ ? Dealiasing::twoThirds : Dealiasing::none;
        if (filtered_) { settings.filter = exponentialFilter(); }
        return settings;
    }

    /// Noise of size 1 about a mean flow.
    RealField velocity() const
    {
        const Lattice box = lattice();
        RealField field = noise(box, dimensions_, seed_ + 1000);
        for (int c = 0; c < dimensions_; ++c)
        {
            for (double& u : field[c]) { u += 0.7 - c; }
        }
        return field;
    }

    /// Steps that stay well within the limits of the flow.
    static void march(FlowRun& run, int steps = 5)
    {
        for (int n = 0; n < steps; ++n) { run.step(stepOf(run)); }
    }
    static double stepOf(FlowRun& run)
    {
        return std::min(0.3 * largestStableStep(*run.settings.time, run.flow.rates()), 0.3 / run.flow.rates().courant);
    }

private:
    KernelSettings kernel() const
    {
        if (kernel_ == 0) { return exactKernel(); }
        if (kernel_ == 1) { return quinticSpline(std::max(smoothingLength_, 1.0)); }
        if (kernel_ == 2) { return sampledGaussian(4, std::max(smoothingLength_, 1.0), 3); }
        return closedGaussian(order_, smoothingLength_);
    }

    int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
    double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }

    std::mt19937 engine_;
    unsigned seed_;
    int dimensions_;
    std::array<int, 3> counts_{1, 1, 1};
    std::array<double, 3> extents_{0, 0, 0};
    int kernel_;
    double smoothingLength_;
    int order_;
    ConvectionForm form_;
    LaplacianForm laplacian_;
    bool integratingFactor_;
    bool exactMeanFlow_;
    bool dealiased_;
    bool filtered_;
    double nu_;
};

/// A field at other points: result(point) = field(map(point)), indices wrapped.
RealField moved(const Lattice& lattice, const RealField& field,
                const std::function<std::array<int, 3>(std::array<int, 3>)>& map)
{
    RealField result(field.components(), field.size());
    const std::array<int, 3> n{lattice.axis(0).count, lattice.axis(1).count, lattice.axis(2).count};
    std::size_t point = 0;
    for (int k = 0; k < n[2]; ++k)
    {
        for (int j = 0; j < n[1]; ++j)
        {
            for (int i = 0; i < n[0]; ++i, ++point)
            {
                const auto [a, b, c] = map({i, j, k});
                const auto wrap = [](int index, int count)
                { return static_cast<std::size_t>(((index % count) + count) % count); };
                const std::size_t from =
                    wrap(a, n[0]) +
                    static_cast<std::size_t>(n[0]) * (wrap(b, n[1]) + static_cast<std::size_t>(n[1]) * wrap(c, n[2]));
                for (int component = 0; component < field.components(); ++component)
                {
                    result[component][point] = field[component][from];
                }
            }
        }
    }
    return result;
}

std::vector<double> means(const RealField& field)
{
    std::vector<double> result;
    for (int c = 0; c < field.components(); ++c)
    {
        double sum = 0;
        for (const double u : field[c]) { sum += u; }
        result.push_back(sum / static_cast<double>(field.size()));
    }
    return result;
}

constexpr unsigned scenes = 40;

} // namespace

TEST(AnyFlow, staysFreeOfDivergence)
{
    for (unsigned seed = 0; seed < scenes; ++seed)
    {
        const RandomScene scene(seed);
        FlowRun run(scene.lattice(), Fluid{.nu = scene.nu()}, scene.settings());
        run.flow.start(scene.velocity(), true);
        RandomScene::march(run);
        const double scale = run.flow.bounds().derivativeMagnitude * norm(run.flow.velocity());
        EXPECT_LE(norm(run.flow.divergence()), 1e-13 * scale) << "seed " << seed;
    }
}

TEST(AnyFlow, keepsItsMomentum)
{
    // In every form: sums over the lattice of f D f vanish for any antisymmetric D, and D.u does.
    for (unsigned seed = 0; seed < scenes; ++seed)
    {
        const RandomScene scene(seed);
        FlowRun run(scene.lattice(), Fluid{.nu = scene.nu()}, scene.settings());
        run.flow.start(scene.velocity(), true);
        const std::vector<double> before = means(run.flow.velocity());
        RandomScene::march(run);
        const std::vector<double> after = means(run.flow.velocity());
        for (std::size_t c = 0; c < before.size(); ++c) { EXPECT_NEAR(after[c], before[c], 1e-14) << "seed " << seed; }
    }
}

TEST(AnyFlow, isTheSameWhereverTheBoxBegins)
{
    for (unsigned seed = 0; seed < scenes; ++seed)
    {
        const RandomScene scene(seed);
        const Lattice lattice = scene.lattice();
        const auto shift = [](std::array<int, 3> p) { return std::array{p[0] + 3, p[1] - 5, p[2] + 2}; };
        FlowRun here(lattice, Fluid{.nu = scene.nu()}, scene.settings());
        FlowRun there(lattice, Fluid{.nu = scene.nu()}, scene.settings());
        here.flow.start(scene.velocity(), true);
        there.flow.start(moved(lattice, scene.velocity(), shift), true);
        const double dt = RandomScene::stepOf(here);
        here.march(5 * dt, 5);
        there.march(5 * dt, 5);
        EXPECT_LE(relativeL2(there.flow.velocity(), moved(lattice, here.flow.velocity(), shift)), 1e-13)
            << "seed " << seed;
    }
}

TEST(AnyFlow, isTheSameInAMirror)
{
    for (unsigned seed = 0; seed < scenes; ++seed)
    {
        const RandomScene scene(seed);
        const Lattice lattice = scene.lattice();
        const auto mirrored = [&](const RealField& field)
        {
            RealField result = moved(lattice, field,
                                     [](std::array<int, 3> p) {
                                         return std::array{-p[0], p[1], p[2]};
                                     });
            for (double& u : result[0]) { u = -u; }
            return result;
        };
        FlowRun here(lattice, Fluid{.nu = scene.nu()}, scene.settings());
        FlowRun there(lattice, Fluid{.nu = scene.nu()}, scene.settings());
        here.flow.start(scene.velocity(), true);
        there.flow.start(mirrored(scene.velocity()), true);
        const double dt = RandomScene::stepOf(here);
        here.march(5 * dt, 5);
        there.march(5 * dt, 5);
        EXPECT_LE(relativeL2(there.flow.velocity(), mirrored(here.flow.velocity())), 1e-13) << "seed " << seed;
    }
}

TEST(AnyFlow, isTheSameWithItsAxesExchanged)
{
    for (unsigned seed = 0; seed < scenes; ++seed)
    {
        const RandomScene scene(seed);
        const auto& [nx, ny, nz] = scene.counts();
        const auto& [lx, ly, lz] = scene.extents();
        const Lattice lattice = scene.lattice();
        const Lattice turned = periodicBox({ny, nx, nz}, {ly, lx, lz});
        // Axes x and y change places, and so do the components; what a form leaves out of its trace or of its gradients
        // does not, and must not show.
        const auto exchanged = [&](const Lattice& from, const RealField& field)
        {
            RealField result(field.components(), field.size());
            const auto width = static_cast<std::size_t>(from.axis(0).count);
            const auto height = static_cast<std::size_t>(from.axis(1).count);
            for (int c = 0; c < field.components(); ++c)
            {
                const int source = field.components() == 1 || c == 2 ? c : 1 - c;
                for (std::size_t point = 0; point < field.size(); ++point)
                {
                    const std::size_t i = point % width;
                    const std::size_t j = point / width % height;
                    const std::size_t k = point / (width * height);
                    result[c][j + height * (i + width * k)] = field[source][point];
                }
            }
            return result;
        };
        FlowRun here(lattice, Fluid{.nu = scene.nu()}, scene.settings());
        FlowRun there(turned, Fluid{.nu = scene.nu()}, scene.settings());
        here.flow.start(scene.velocity(), true);
        there.flow.start(exchanged(lattice, scene.velocity()), true);
        const double dt = RandomScene::stepOf(here);
        here.march(5 * dt, 5);
        there.march(5 * dt, 5);
        EXPECT_LE(relativeL2(there.flow.velocity(), exchanged(lattice, here.flow.velocity())), 1e-12)
            << "seed " << seed;
        const RealField pressure = exchanged(lattice, here.flow.pressure(0));
        EXPECT_LE(largestDifference(there.flow.pressure(0), pressure), 1e-12 * std::pow(norm(here.flow.velocity()), 2))
            << "seed " << seed;
    }
}

TEST(AnyFlow, losesEnergyToViscosityAlone)
{
    // Rotational and skew-symmetric forms hold energy whatever the kernel does; RK3 takes some of it, at third order.
    for (unsigned seed = 0; seed < 3 * scenes; ++seed)
    {
        const RandomScene scene(seed);
        if (scene.form() != ConvectionForm::rotational && scene.form() != ConvectionForm::skewSymmetric) { continue; }
        const bool conserves = scene.nu() == 0 && scene.settings().filter.type == FilterSettings::Type::none;
        const auto lost = [&](int refinement)
        {
            FlowRun run(scene.lattice(), Fluid{.nu = scene.nu()}, scene.settings());
            run.flow.start(scene.velocity(), true);
            const double before = kineticEnergy(run.flow.velocity());
            const double dt = 0.1 * RandomScene::stepOf(run);
            run.march(10 * dt, 10 * refinement);
            return 1 - kineticEnergy(run.flow.velocity()) / before;
        };
        const double coarse = lost(1);
        if (!conserves) { EXPECT_GE(coarse, -1e-6) << "seed " << seed; }
        else { EXPECT_LE(std::abs(lost(2)), std::abs(coarse) / 7 + 1e-13) << "seed " << seed; }
    }
}

TEST(AnyFlow, doesNotFeelAFrameThatMovesByWholePoints)
{
    for (unsigned seed = 0; seed < scenes; ++seed)
    {
        const RandomScene scene(seed);
        const Lattice lattice = scene.lattice();
        const auto marched = [&](const std::array<int, 3>& points, double dt)
        {
            FlowSettings settings = scene.settings();
            settings.exactMeanFlow = true;
            settings.dealiasing = Dealiasing::twoThirds; // aliases, and waves at Nyquist, are not carried along
            FlowRun run(lattice, Fluid{.nu = scene.nu()}, std::move(settings));
            RealField velocity = scene.velocity();
            std::array<double, 3> frame{0, 0, 0};
            for (int c = 0; c < velocity.components(); ++c)
            {
                const auto axis = static_cast<std::size_t>(c);
                frame[axis] = points[axis] * lattice.axis(c).spacing() / (5 * dt);
                for (double& u : velocity[c]) { u += frame[axis]; }
            }
            run.flow.start(velocity, true);
            run.march(5 * dt, 5);
            RealField end = copyOf(run.flow.velocity());
            for (int c = 0; c < end.components(); ++c)
            {
                for (double& u : end[c]) { u -= frame[static_cast<std::size_t>(c)]; }
            }
            return end;
        };
        FlowRun probe(lattice, Fluid{.nu = scene.nu()}, scene.settings());
        probe.flow.start(scene.velocity(), true);
        const double dt = RandomScene::stepOf(probe);
        const RealField atRest = marched({0, 0, 0}, dt);
        const RealField moving = marched({7, -3, 4}, dt);
        const auto back = [](std::array<int, 3> p) { return std::array{p[0] + 7, p[1] - 3, p[2] + 4}; };
        EXPECT_LE(relativeL2(moved(lattice, moving, back), atRest), 1e-12) << "seed " << seed;
    }
}
