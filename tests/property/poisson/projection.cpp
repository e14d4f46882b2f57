#include "operators/SpectralOperators.hpp"
#include "poisson/FourierPoisson.hpp"

#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"
#include "support/record.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace isph
{
namespace
{

using test::periodicBox;

using MakeKernel = KernelSettings (*)();

constexpr std::array<MakeKernel, 6> kernels{+[] { return test::exactKernel(); },
                                            +[] { return test::closedGaussian(4, 2.0); },
                                            +[] { return test::closedGaussian(10, 1.5); },
                                            +[] { return test::sampledGaussian(4, 2.0, 4); },
                                            +[] { return test::sampledGaussian(6, 1.3, 4); },
                                            +[] { return test::quinticSpline(1.3); }};

/// Aspect ratios 1 and 1000, two and three dimensions, odd and even.
std::vector<Lattice> lattices()
{
    return {periodicBox({24, 24, 1}, {1, 1, 0}), periodicBox({32, 32, 1}, {1000, 1, 0}),
            periodicBox({9, 64, 1}, {1, 1000, 0}), periodicBox({8, 9, 10}, {1, 1, 1}),
            periodicBox({8, 6, 7}, {1000, 1, 30})};
}

/// Velocities in Fourier space with a kernel's first derivative.
class Modes
{
public:
    Modes(const Lattice& lattice, const KernelSettings& kernel)
        : lattice_(lattice),
          derivative_(derivativeOf(lattice, kernel)),
          transform_(lattice, lattice.dimensions()),
          inverse_(invertedEigenvalues(derivative_.rows(),
                                       poissonEigenvalues(lattice, Eigenvalues::consistent, derivative_, {})))
    {
    }

    SpectralField velocity(const RealField& u)
    {
        SpectralField modes(u.components(), transform_.modes());
        transform_.forward(u, modes);
        return modes;
    }

    /// Calls visit(mode, multiplicity, d, u).
    template<class Visit>
    void forEach(SpectralField& velocity, Visit visit) const
    {
        const ModeRows& rows = derivative_.rows();
        std::array<std::vector<double>, 3> d;
        for (auto& values : d) { values.assign(rows.length(), 0.0); }
        for (std::size_t row = 0; row < rows.count(); ++row)
        {
            derivative_.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
            for (std::size_t i = 0; i < rows.length(); ++i)
            {
                std::array<std::complex<double>*, 3> u{};
                for (int c = 0; c < velocity.components(); ++c)
                {
                    u[static_cast<std::size_t>(c)] = &velocity[c][rows.offset(row) + i];
                }
                visit(rows.offset(row) + i, rows.multiplicity(i), std::array<double, 3>{d[0][i], d[1][i], d[2][i]}, u);
            }
        }
    }

    /// u - D (D.u)/(D.D), mode by mode; the part that is taken away.
    SpectralField project(SpectralField& velocity) const
    {
        SpectralField removed(velocity.components(), velocity.size());
        forEach(velocity,
                [&](std::size_t mode, double, const auto& d, const auto& u)
                {
                    std::complex<double> along = 0;
                    for (int c = 0; c < velocity.components(); ++c) { along += d[index(c)] * *u[index(c)]; }
                    for (int c = 0; c < velocity.components(); ++c)
                    {
                        removed[c][mode] = d[index(c)] * inverse_[mode] * along;
                        *u[index(c)] -= removed[c][mode];
                    }
                });
        return removed;
    }

    double norm(SpectralField& velocity) const
    {
        double total = 0;
        forEach(velocity,
                [&](std::size_t, double multiplicity, const auto&, const auto& u)
                {
                    for (int c = 0; c < velocity.components(); ++c) { total += multiplicity * std::norm(*u[index(c)]); }
                });
        return std::sqrt(total);
    }

    double divergence(SpectralField& velocity) const
    {
        double total = 0;
        forEach(velocity,
                [&](std::size_t, double multiplicity, const auto& d, const auto& u)
                {
                    std::complex<double> along = 0;
                    for (int c = 0; c < velocity.components(); ++c) { along += d[index(c)] * *u[index(c)]; }
                    total += multiplicity * std::norm(along);
                });
        return std::sqrt(total);
    }

    /// max |d|
    double derivativeNorm() const
    {
        return operatorBounds(derivative_, {}, RetainedModes(lattice_, Dealiasing::none)).derivativeMagnitude;
    }

private:
    static std::size_t index(int c) { return static_cast<std::size_t>(c); }
    static DerivativeSymbol derivativeOf(const Lattice& lattice, const KernelSettings& kernel)
    {
        if (kernel.symbol == KernelSettings::Symbol::closed) { return DerivativeSymbol(lattice, kernel, nullptr); }
        const KernelSamples samples(lattice, kernel, LaplacianForm::exact);
        return DerivativeSymbol(lattice, kernel, &samples);
    }

    Lattice lattice_;
    DerivativeSymbol derivative_;
    FourierTransform transform_;
    AlignedVector<double> inverse_;
};

TEST(Projection, LeavesNoDivergence)
{
    test::Bounds bounds;
    for (const Lattice& lattice : lattices())
    {
        for (const MakeKernel make : kernels)
        {
            Modes modes(lattice, make());
            SpectralField u = modes.velocity(test::noise(lattice, lattice.dimensions(), 1));
            const double before = modes.divergence(u);
            modes.project(u);
            EXPECT_TRUE(
                bounds.atMost(modes.divergence(u), 1e-13 * modes.derivativeNorm() * modes.norm(u))); // round-off
            EXPECT_TRUE(bounds.atLeast(before, 1e-3 * modes.derivativeNorm() * modes.norm(u))) << "there was some";
        }
    }
}

TEST(Projection, TwiceIsOnce)
{
    test::Bounds bounds;
    for (const Lattice& lattice : lattices())
    {
        for (const MakeKernel make : kernels)
        {
            Modes modes(lattice, make());
            SpectralField u = modes.velocity(test::noise(lattice, lattice.dimensions(), 2));
            modes.project(u);
            SpectralField removed = modes.project(u);
            EXPECT_TRUE(bounds.atMost(modes.norm(removed), 1e-14 * modes.norm(u)));
        }
    }
}

TEST(Projection, RemovesGradientsWhole)
{
    test::Bounds bounds;
    for (const Lattice& lattice : lattices())
    {
        for (const MakeKernel make : kernels)
        {
            Modes modes(lattice, make());
            // i d phi with white noise for phi; the null modes have no gradient.
            SpectralField u = modes.velocity(test::noise(lattice, lattice.dimensions(), 3));
            modes.forEach(u,
                          [&](std::size_t mode, double, const auto& d, const auto& components)
                          {
                              const std::complex<double> phi = u[0][mode];
                              for (int c = 0; c < u.components(); ++c)
                              {
                                  const auto i = static_cast<std::size_t>(c);
                                  *components[i] = std::complex<double>(0, d[i]) * phi;
                              }
                          });
            const double before = modes.norm(u);
            modes.project(u);
            EXPECT_TRUE(bounds.atMost(modes.norm(u), 1e-14 * before));
        }
    }
}

TEST(Projection, LeavesSolenoidalFieldsAlone)
{
    test::Bounds bounds;
    for (const Lattice& lattice : lattices())
    {
        for (const MakeKernel make : kernels)
        {
            Modes modes(lattice, make());
            // d x a, with white noise for a; in two dimensions a is across the plane.
            SpectralField u = modes.velocity(test::noise(lattice, lattice.dimensions(), 4));
            modes.forEach(u,
                          [&](std::size_t, double, const auto& d, const auto& components)
                          {
                              const auto a = *components[0];
                              const auto b = *components[1];
                              const auto c = components[2] != nullptr ? *components[2] : a;
                              if (components[2] == nullptr)
                              {
                                  *components[0] = d[1] * c;
                                  *components[1] = -d[0] * c;
                                  return;
                              }
                              *components[0] = d[1] * c - d[2] * b;
                              *components[1] = d[2] * a - d[0] * c;
                              *components[2] = d[0] * b - d[1] * a;
                          });
            SpectralField removed = modes.project(u);
            EXPECT_TRUE(bounds.atMost(modes.norm(removed), 1e-14 * modes.norm(u)));
            EXPECT_GT(modes.norm(u), 0);
        }
    }
}

TEST(Projection, ByPoissonSolverAndGradientIsTheSame)
{
    // The way of a solver in physical space. Its phi is as large as 1/|d| of the mode that a kernel sees least, and its
    // round-off spreads over all modes: kernels that see every mode, for a divergence at round-off.
    for (const Lattice& lattice : {periodicBox({24, 24, 1}, {1, 1, 0}), periodicBox({8, 9, 10}, {1, 1, 1})})
    {
        for (const MakeKernel make :
             {+[] { return test::exactKernel(); }, +[] { return test::closedGaussian(10, 1.3); }})
        {
            const KernelSettings kernel = make();
            DerivativeSymbol derivative(lattice, kernel, nullptr);
            FourierPoisson poisson(
                lattice, invertedEigenvalues(derivative.rows(),
                                             poissonEigenvalues(lattice, Eigenvalues::consistent, derivative, {})));
            const double norm =
                operatorBounds(derivative, {}, RetainedModes(lattice, Dealiasing::none)).derivativeMagnitude;
            SpectralOperators operators(lattice, std::move(derivative), {});
            RealField u = test::noise(lattice, lattice.dimensions(), 5);
            RealField divergence(1, lattice.points());
            RealField phi(1, lattice.points());
            RealField gradient(lattice.dimensions(), lattice.points());
            operators.divergence(u, divergence);
            poisson.solve(divergence, phi);
            operators.gradient(phi, 0, gradient);
            for (int c = 0; c < lattice.dimensions(); ++c)
            {
                for (std::size_t i = 0; i < lattice.points(); ++i) { u[c][i] -= gradient[c][i]; }
            }
            operators.divergence(u, divergence);
            EXPECT_LE(test::norm(divergence), 1e-13 * norm * test::norm(u));
        }
    }
}

} // namespace
} // namespace isph
