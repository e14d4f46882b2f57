#include "continuation/matrixSpectrum.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace isph
{

TEST(MatrixSpectrum, FindsRealAndComplexEigenvalues)
{
    // A rotation by a quarter with growth 2, and -3 beside it.
    const std::vector<double> matrix{0, -2, 0, 2, 0, 0, 0, 0, -3};
    auto found = eigenvaluesOf(matrix, 3);
    std::ranges::sort(found, {}, [](const auto& value) { return value.imag(); });
    ASSERT_EQ(found.size(), 3U);
    EXPECT_NEAR(std::abs(found[0] - std::complex<double>(0, -2)), 0, 1e-14);
    EXPECT_NEAR(std::abs(found[1] + 3.0), 0, 1e-14);
    EXPECT_NEAR(std::abs(found[2] - std::complex<double>(0, 2)), 0, 1e-14);
}

TEST(MatrixSpectrum, RefusesNumbersThatAreNone)
{
    EXPECT_THROW(eigenvaluesOf(std::vector<double>{std::numeric_limits<double>::quiet_NaN()}, 1), std::runtime_error);
    EXPECT_TRUE(eigenvaluesOf({}, 0).empty());
}

} // namespace isph
