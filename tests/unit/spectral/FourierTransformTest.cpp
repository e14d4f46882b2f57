#include "spectral/FourierTransform.hpp"

#include "spectral/ModeRows.hpp"
#include "support/periodicBox.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

namespace isph
{
namespace
{

using test::periodicBox;

TEST(FourierTransform, TellsItsShape)
{
    FourierTransform transform(periodicBox({6, 5, 4}, {1, 1, 1}), 3);
    EXPECT_EQ(transform.components(), 3);
    EXPECT_EQ(transform.points(), 120U);
    EXPECT_EQ(transform.modes(), 4U * 5 * 4);

    const auto extents = modeExtents(periodicBox({1, 7, 9}, {0, 1, 2})); // x is left out
    EXPECT_EQ(extents, (std::array<std::size_t, 3>{4, 9, 1}));
}

TEST(FourierTransform, CountsTheTransformsOfItsComponents)
{
    const Lattice lattice = test::unitSquare(4);
    FourierTransform transform(lattice, 3);
    RealField real(3, lattice.points());
    SpectralField modes(3, transform.modes());
    EXPECT_EQ(transform.count(), 0);
    transform.forward(real, modes);
    EXPECT_EQ(transform.count(), 3);
    transform.backward(modes, real);
    EXPECT_EQ(transform.count(), 6);
}

TEST(FourierTransform, AWaveIsOneModeInItsPlace)
{
    // cos(2 pi (2 x - y)) on 8 x 6: mode (2, -1), which is row 5, with weight points/2.
    const Lattice lattice = periodicBox({8, 6, 1}, {2, 3, 0});
    FourierTransform transform(lattice, 1);
    RealField real(1, lattice.points());
    for (int j = 0; j < 6; ++j)
    {
        for (int i = 0; i < 8; ++i)
        {
            real[0][static_cast<std::size_t>(i + 8 * j)] = std::cos(2 * std::numbers::pi * (2 * i / 8.0 - j / 6.0));
        }
    }
    SpectralField modes(1, transform.modes());
    transform.forward(real, modes);
    const ModeRows rows(lattice);
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            const double expected = row == 5 && i == 2 ? 24 : 0;
            EXPECT_NEAR(std::abs(modes[0][rows.offset(row) + i] - expected), 0, 1e-14 * 48)
                << row << ' ' << i; // 48 terms
        }
    }
    EXPECT_NEAR(rows.wavenumbers().k[0][2], 2 * std::numbers::pi, 1e-15);
    EXPECT_NEAR(rows.k(5, 1), -2 * std::numbers::pi / 3, 1e-15);
}

TEST(FourierTransform, PlansAgreeInTheirFingerprint)
{
    const Lattice lattice = test::unitSquare(24);
    const FourierTransform one(lattice, 2);
    const FourierTransform same(lattice, 2);
    const FourierTransform otherShape(test::unitSquare(30), 2);
    EXPECT_EQ(one.fingerprint(), same.fingerprint());
    EXPECT_NE(one.fingerprint(), otherShape.fingerprint());
    EXPECT_EQ(one.fingerprint().size(), 16U);
}

TEST(FourierTransform, MovesWithItsPlans)
{
    const Lattice lattice = test::unitSquare(4);
    FourierTransform first(lattice, 1);
    const std::string fingerprint = first.fingerprint();
    FourierTransform second(std::move(first));
    EXPECT_EQ(second.fingerprint(), fingerprint);
    FourierTransform third(test::unitSquare(6), 2);
    third = std::move(second);
    EXPECT_EQ(third.fingerprint(), fingerprint);
    RealField real(1, lattice.points());
    SpectralField modes(1, third.modes());
    real[0][0] = 1;
    third.forward(real, modes);
    for (const auto& mode : modes[0]) { EXPECT_EQ(mode, 1.0); }
}

} // namespace
} // namespace isph
