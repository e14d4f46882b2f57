#include "spectral/FourierTransform.hpp"
#include "spectral/ModeRows.hpp"
#include "support/periodicBox.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <omp.h>
#include <random>
#include <vector>

namespace isph
{
namespace
{

using test::periodicBox;

/// Two and three dimensions; odd, even, prime and tiny counts; every axis left out once.
std::vector<Lattice> lattices()
{
    std::vector<Lattice> all;
    for (const auto& [nx, ny] :
         {std::pair{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 3}, {1, 31}, {31, 1}, {4, 6}, {31, 12}, {97, 2}, {64, 27}})
    {
        all.push_back(periodicBox({nx, ny, 1}, {1, 3, 0}));
        all.push_back(periodicBox({nx, 1, ny}, {2, 0, 1}));
        all.push_back(periodicBox({1, nx, ny}, {0, 1, 1}));
    }
    for (const auto& counts :
         {std::array{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 2, 3}, {5, 1, 4}, {7, 6, 13}, {16, 15, 14}})
    {
        all.push_back(periodicBox(counts, {1, 1, 1}));
    }
    return all;
}

RealField noise(int components, std::size_t size, unsigned seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    RealField field(components, size);
    for (int c = 0; c < components; ++c)
    {
        std::ranges::generate(field[c], [&] { return uniform(engine); });
    }
    return field;
}

/// Round-off of a fast transform: a unit in the last place for each of its log2(points) stages; primes cost a few more.
double roundOff(std::size_t points) { return 2e-16 * (4 + std::log2(static_cast<double>(points))); }

TEST(FourierTransforms, BackwardUndoesForwardTimesThePoints)
{
    for (const Lattice& lattice : lattices())
    {
        for (const int components : {1, 3})
        {
            FourierTransform transform(lattice, components);
            const RealField original = noise(components, lattice.points(), 7);
            RealField real = copyOf(original);
            SpectralField modes(components, transform.modes());
            transform.forward(real, modes);
            for (int c = 0; c < components; ++c)
            {
                EXPECT_TRUE(std::ranges::equal(real[c], original[c])) << "input kept";
            }

            RealField back(components, lattice.points());
            transform.backward(modes, back);
            const auto points = static_cast<double>(lattice.points());
            for (int c = 0; c < components; ++c)
            {
                for (std::size_t i = 0; i < lattice.points(); ++i)
                {
                    ASSERT_NEAR(back[c][i] / points, original[c][i], 2 * roundOff(lattice.points()));
                }
            }
        }
    }
}

TEST(FourierTransforms, BatchesAreTheSameAsOneByOne)
{
    for (const Lattice& lattice : lattices())
    {
        FourierTransform batch(lattice, 3);
        FourierTransform single(lattice, 1);
        RealField together = noise(3, lattice.points(), 11);
        SpectralField modes(3, batch.modes());
        batch.forward(together, modes);
        RealField one(1, lattice.points());
        SpectralField oneModes(1, single.modes());
        const double scale = std::sqrt(static_cast<double>(lattice.points()));
        for (int c = 0; c < 3; ++c)
        {
            std::ranges::copy(together[c], one[0].begin());
            single.forward(one, oneModes);
            for (std::size_t i = 0; i < batch.modes(); ++i)
            {
                ASSERT_LE(std::abs(modes[c][i] - oneModes[0][i]), 4 * scale * roundOff(lattice.points()));
            }
        }
        batch.backward(modes, together);
        for (int c = 0; c < 3; ++c)
        {
            const RealField original = noise(3, lattice.points(), 11);
            for (std::size_t i = 0; i < lattice.points(); ++i)
            {
                ASSERT_NEAR(together[c][i] / static_cast<double>(lattice.points()), original[c][i],
                            2 * roundOff(lattice.points()));
            }
        }
    }
}

TEST(FourierTransforms, AreTheDenseMatrixInTheStatedOrder)
{
    for (const Lattice& lattice : lattices())
    {
        if (lattice.points() > 600) { continue; }
        FourierTransform transform(lattice, 1);
        const RealField real = noise(1, lattice.points(), 3);
        SpectralField modes(1, transform.modes());
        transform.forward(real, modes);

        // sum over points of f exp(-i k x), with wavenumbers and coordinates as the rest of the suite sees them.
        const ModeRows rows(lattice);
        const auto coordinates = lattice.coordinates();
        for (std::size_t row = 0; row < rows.count(); ++row)
        {
            for (std::size_t i = 0; i < rows.length(); ++i)
            {
                std::complex<double> dense = 0;
                for (std::size_t point = 0; point < lattice.points(); ++point)
                {
                    double phase = 0;
                    for (int d = 0; d < lattice.dimensions(); ++d)
                    {
                        const double k = d == 0 ? rows.wavenumbers().k[0][i] : rows.k(row, d);
                        phase += k * coordinates[static_cast<std::size_t>(lattice.direction(d))][point];
                    }
                    dense += real[0][point] * std::polar(1.0, -phase);
                }
                // The dense sum rounds its phases, up to pi n each, and its terms.
                const auto points = static_cast<double>(lattice.points());
                ASSERT_LE(std::abs(modes[0][rows.offset(row) + i] - dense), 4e-16 * 300 * std::sqrt(points));
            }
        }
    }
}

TEST(FourierTransforms, OnSeveralThreadsAreTheSameToRoundOff)
{
    const Lattice lattice = periodicBox({48, 30, 1}, {1, 1, 0});
    const RealField real = noise(2, lattice.points(), 13);
    const int before = omp_get_max_threads();
    std::vector<SpectralField> results;
    for (const int threads : {1, 2, 3})
    {
        omp_set_num_threads(threads);
        FourierTransform transform(lattice, 2);
        results.emplace_back(2, transform.modes());
        transform.forward(real, results.back());
        SpectralField again(2, transform.modes());
        transform.forward(real, again);
        EXPECT_TRUE(std::ranges::equal(again[1], results.back()[1])) << "the same plan, the same bits";
    }
    omp_set_num_threads(before);
    for (const SpectralField& result : results)
    {
        for (std::size_t i = 0; i < result.size(); ++i)
        {
            const double scale = std::sqrt(static_cast<double>(lattice.points()));
            ASSERT_LE(std::abs(result[1][i] - results[0][1][i]), 4 * scale * roundOff(lattice.points()));
        }
    }
}

TEST(FourierTransforms, KeepTheEnergyOfParseval)
{
    for (const Lattice& lattice : lattices())
    {
        FourierTransform transform(lattice, 1);
        const RealField real = noise(1, lattice.points(), 5);
        SpectralField modes(1, transform.modes());
        transform.forward(real, modes);
        const ModeRows rows(lattice);
        double spectral = 0;
        for (std::size_t row = 0; row < rows.count(); ++row)
        {
            for (std::size_t i = 0; i < rows.length(); ++i)
            {
                spectral += rows.multiplicity(i) * std::norm(modes[0][rows.offset(row) + i]);
            }
        }
        double physical = 0;
        for (const double value : real[0]) { physical += value * value; }
        const auto points = static_cast<double>(lattice.points());
        EXPECT_NEAR(spectral / (points * physical), 1, 4 * roundOff(lattice.points()));
    }
}

} // namespace
} // namespace isph
