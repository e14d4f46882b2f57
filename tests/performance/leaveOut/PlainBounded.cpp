#include "PlainStep.hpp"

#include "continuation/ContinuedDerivative.hpp"
#include "flow/convectiveRates.hpp"
#include "operators/continuedBounds.hpp"
#include "operators/lineSymbolOf.hpp"
#include "poisson/BoundedPoisson.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace isph::test
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// In two dimensions, y between walls. \tparam Cavity x too
template<bool Cavity>
class PlainBounded : public PlainStep
{
public:
    PlainBounded(const Scene& scene, const RealField& start, PlanEffort effort)
        : lattice_(scene.lattice),
          bounds_(continuedBounds(scene.lattice, scene.settings.continuations, scene.settings.kernel,
                                  scene.settings.laplacian)),
          nx_(at(scene.lattice.axis(0).count)),
          ny_(at(scene.lattice.axis(1).count)),
          nu_(scene.fluid.nu),
          perSpacing_{1 / scene.lattice.axis(0).spacing(), 1 / scene.lattice.axis(1).spacing()},
          poisson_(scene.lattice, endsOf(), effort),
          velocity_(copyOf(start)),
          before_(2, start.size()),
          rate_(2, start.size()),
          past_(2, start.size()),
          scratch_(1, start.size()),
          source_(1, start.size()),
          phi_(1, start.size())
    {
        for (int d = 0; d < 2; ++d)
        {
            const Axis& axis = scene.lattice.axis(d);
            std::optional<LineContinuation> line;
            int length = axis.count;
            if (const auto& continuation = scene.settings.continuations[at(d)])
            {
                line.emplace(*continuation, axis.count);
                length = line->extendedPoints();
            }
            derivatives_.emplace_back(
                ContinuedTransform(linesAlong(scene.lattice, d), std::move(line), 1, effort),
                lineSymbolOf(scene.settings.kernel, scene.settings.laplacian, length, axis.spacing()));
        }
        if constexpr (!Cavity)
        {
            slope_ = RealField(1, start.size());
            const Axis& x = scene.lattice.axis(0);
            symbol_ = lineSymbolOf(scene.settings.kernel, scene.settings.laplacian, x.count, x.spacing()).first;
            RealField force(2, start.size());
            scene.fluid.bodyForce->evaluate(0, force);
            force_ = force[0][0];
        }
        for (std::size_t side = 0; side < 2; ++side)
        {
            yWalls_[side].resize(nx_);
            ySource_[side].resize(nx_);
            if (Cavity) { xWalls_[side].resize(ny_); }
        }
        const auto lid = scene.boundary.velocity(1, Side::high, 0);
        lid_.assign(lid.begin(), lid.end());
        substeps_.assign(scene.settings.time->substeps.begin(), scene.settings.time->substeps.end());
    }

    void step(double dt) override
    {
        for (int c = 0; c < 2; ++c) { std::copy_n(velocity_[c].data(), velocity_.size(), before_[c].data()); }
        impose();
        for (const Substep& substep : substeps_) { march(substep, dt); }
        rates_ = {};
        addConvectiveRates(lattice_, velocity_, bounds_, nu_, rates_);
    }

    RealField velocity() override { return copyOf(velocity_); }

private:
    static std::array<AxisEnds, 3> endsOf()
    {
        const AxisEnds walls{End::neumann, End::neumann};
        return {Cavity ? walls : AxisEnds{}, walls, AxisEnds{}};
    }

    void march(const Substep& substep, double dt)
    {
        for (int c = 0; c < 2; ++c)
        {
            std::ranges::fill(rate_[c], c == 0 ? force_ : 0.0);
            for (int d = 0; d < 2; ++d) { derivatives_[at(d)].addTransport(velocity_[c], velocity_[d], nu_, rate_[c]); }
        }
        const double g = dt * substep.g;
        const double z = dt * substep.z;
        for (int c = 0; c < 2; ++c)
        {
            double* u = velocity_[c].data();
            const double* now = rate_[c].data();
            const double* past = past_[c].data();
            const std::size_t size = velocity_.size();
            if (substep.first)
            {
                for (std::size_t i = 0; i < size; ++i) { u[i] += g * now[i]; }
            }
            else
            {
                for (std::size_t i = 0; i < size; ++i) { u[i] += g * now[i] + z * past[i]; }
            }
        }
        std::swap(rate_, past_);

        const double period = substep.a * dt;
        const double perPeriod = 1 / period;
        const std::size_t last = (ny_ - 1) * nx_;
        for (std::size_t i = 0; i < nx_; ++i)
        {
            yWalls_[0][i] = velocity_[1][i] * perPeriod;
            yWalls_[1][i] = velocity_[1][last + i] * perPeriod;
        }
        for (std::size_t j = 0; Cavity && j < ny_; ++j)
        {
            xWalls_[0][j] = velocity_[0][j * nx_] * perPeriod;
            xWalls_[1][j] = velocity_[0][j * nx_ + nx_ - 1] * perPeriod;
        }

        derivatives_[0](velocity_[0], source_[0], {});
        derivatives_[1](velocity_[1], scratch_[0], {});
        double* source = source_[0].data();
        const double* other = scratch_[0].data();
        for (std::size_t i = 0; i < source_.size(); ++i) { source[i] = (source[i] + other[i]) * perPeriod; }

        WallData walls;
        walls[1] = {yWalls_[0], yWalls_[1]};
        if constexpr (Cavity)
        {
            walls[0] = {xWalls_[0], xWalls_[1]};
            poisson_.solve(source_, walls, phi_);
            derivatives_[0](phi_[0], scratch_[0], {});
            subtract(period, scratch_, 0);
        }
        else
        {
            slopesOfSource();
            const PeriodicSlope slope{0, symbol_, slope_[0]};
            poisson_.solveClosed(source_, walls, {ySource_[0], ySource_[1]}, phi_, &slope);
            subtract(period, slope_, 0);
        }
        derivatives_[1](phi_[0], scratch_[0], {});
        subtract(period, scratch_, 1);
        impose();
    }

    void subtract(double period, const RealField& slope, int c)
    {
        double* u = velocity_[c].data();
        const double* s = slope[0].data();
        for (std::size_t i = 0; i < slope.size(); ++i) { u[i] -= period * s[i]; }
    }

    /// One-sided differences of fifth order.
    void slopesOfSource()
    {
        constexpr std::array<double, 6> weights{-137.0 / 60, 5, -5, 10.0 / 3, -5.0 / 4, 1.0 / 5};
        const double* source = source_[0].data();
        for (std::size_t i = 0; i < nx_; ++i)
        {
            double low = 0;
            double high = 0;
            for (std::size_t j = 0; j < weights.size(); ++j)
            {
                low += weights[j] * source[i + j * nx_];
                high -= weights[j] * source[i + (ny_ - 1 - j) * nx_];
            }
            ySource_[0][i] = low * perSpacing_[1];
            ySource_[1][i] = high * perSpacing_[1];
        }
    }

    void impose()
    {
        double* u = velocity_[0].data();
        double* v = velocity_[1].data();
        for (std::size_t j = 0; Cavity && j < ny_; ++j)
        {
            u[j * nx_] = u[j * nx_ + nx_ - 1] = 0;
            v[j * nx_] = v[j * nx_ + nx_ - 1] = 0;
        }
        const std::size_t last = (ny_ - 1) * nx_;
        for (std::size_t i = 0; i < nx_; ++i)
        {
            u[i] = v[i] = v[last + i] = 0;
            u[last + i] = lid_[i];
        }
    }

    Lattice lattice_;
    OperatorBounds bounds_;
    std::size_t nx_;
    std::size_t ny_;
    double nu_;
    std::array<double, 2> perSpacing_;
    BoundedPoisson poisson_;
    std::vector<ContinuedDerivative> derivatives_;
    RealField velocity_;
    RealField before_; // what a diverged run is taken back to
    RealField rate_;
    RealField past_;
    RealField scratch_;
    RealField source_;
    RealField phi_;
    RealField slope_;
    std::vector<double> symbol_;
    std::array<std::vector<double>, 2> xWalls_;
    std::array<std::vector<double>, 2> yWalls_;
    std::array<std::vector<double>, 2> ySource_;
    std::vector<double> lid_;
    std::vector<Substep> substeps_;
    double force_ = 0;
    StepRates rates_;
};

} // namespace

std::unique_ptr<PlainStep> plainBounded(const Scene& scene, const RealField& start, PlanEffort effort)
{
    if (scene.lattice.axis(0).periodic()) { return std::make_unique<PlainBounded<false>>(scene, start, effort); }
    return std::make_unique<PlainBounded<true>>(scene, start, effort);
}

} // namespace isph::test
