#include "spectral/LineTransform.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

TEST(LineTransform, TransformsEveryLineByItself)
{
    for (const int length : {12, 15, 126})
    {
        const LineTransform transform(length, 3);
        RealField lines = transform.realLines();
        SpectralField modes = transform.modesOfLines();
        ASSERT_EQ(modes.size(), static_cast<std::size_t>(length / 2 + 1));
        for (int line = 0; line < 3; ++line)
        {
            for (int i = 0; i < length; ++i)
            {
                lines[line][static_cast<std::size_t>(i)] =
                    std::cos(2 * std::numbers::pi * (line + 1) * i / length) + line;
            }
        }
        const RealField before = copyOf(lines);
        transform.forward(lines, modes);
        for (int line = 0; line < 3; ++line)
        {
            for (int m = 0; m <= length / 2; ++m)
            {
                const double expected = m == 0 ? line * length : m == line + 1 ? 0.5 * length : 0;
                const std::complex<double> mode = modes[line][static_cast<std::size_t>(m)];
                EXPECT_NEAR(std::abs(mode - expected), 0, 1e-12) << length << ' ' << line << ' ' << m;
            }
        }
        transform.backward(modes, lines);
        for (int line = 0; line < 3; ++line)
        {
            for (std::size_t i = 0; i < lines.size(); ++i)
            {
                EXPECT_NEAR(lines[line][i], length * before[line][i], 1e-11);
            }
        }
    }
}

} // namespace
} // namespace isph
