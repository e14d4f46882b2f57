#include "operators/SpectralOperators.hpp"

#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"
#include "support/record.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

using std::numbers::pi;
using test::fieldOf;
using test::relativeL2;

SpectralOperators operatorsOf(const Lattice& lattice, const KernelSettings& kernel, LaplacianForm form)
{
    return {lattice, DerivativeSymbol(lattice, kernel, nullptr), laplacianSymbol(lattice, kernel, form, nullptr)};
}

/// Relative errors of the closed operators for sin(2 pi x) on n points a wave.
struct Errors
{
    double gradient;
    double laplacian;
};

Errors errorsOf(int n, int order, double smoothingLength, LaplacianForm form)
{
    const Lattice lattice = test::periodicBox({n, 4, 1}, {1, 4.0 / n, 0});
    SpectralOperators operators = operatorsOf(lattice, test::closedGaussian(order, smoothingLength), form);
    const RealField f = fieldOf(lattice, 1, [](int, double x, double, double) { return std::sin(2 * pi * x); });
    RealField gradient(2, lattice.points());
    RealField laplacian(1, lattice.points());
    operators.gradient(f, 0, gradient);
    operators.laplacian(f, laplacian);
    const RealField exactGradient =
        fieldOf(lattice, 2, [](int c, double x, double, double) { return c == 0 ? 2 * pi * std::cos(2 * pi * x) : 0; });
    const RealField exactLaplacian =
        fieldOf(lattice, 1, [](int, double x, double, double) { return -4 * pi * pi * std::sin(2 * pi * x); });
    return {relativeL2(gradient, exactGradient), relativeL2(laplacian, exactLaplacian)};
}

TEST(SpectralOperators, HaveTheOrderOfTheirKernel)
{
    test::Bounds bounds;
    for (const LaplacianForm form : {LaplacianForm::morris, LaplacianForm::secondDerivative})
    {
        for (const double smoothingLength : {1.3, 2.0})
        {
            for (const int order : {2, 4, 6, 8, 10})
            {
                int compared = 0;
                for (const int n : {20, 40})
                {
                    const Errors coarse = errorsOf(n, order, smoothingLength, form);
                    const Errors fine = errorsOf(2 * n, order, smoothingLength, form);
                    for (const auto error : {&Errors::gradient, &Errors::laplacian})
                    {
                        if (fine.*error < 1e-12) { continue; } // round-off is near
                        EXPECT_TRUE(bounds.near(std::log2(coarse.*error / fine.*error), order, 0.1))
                            << "order " << order << ", h/dx " << smoothingLength << ", from " << n << " points";
                        ++compared;
                    }
                }
                EXPECT_GE(compared, order == 10 ? 1 : 2) << "order " << order << ", h/dx " << smoothingLength;
            }
        }
    }
}

TEST(SpectralOperators, ErrorsOfAWaveAreThoseOfTheTheory)
{
    // h = 2 dx and 100 points, gradient and Morris, printed to two digits.
    EXPECT_NEAR(errorsOf(100, 4, 2, LaplacianForm::morris).gradient, 7.8e-6, 0.05e-6);
    EXPECT_NEAR(errorsOf(100, 4, 2, LaplacianForm::morris).laplacian, 2.6e-6, 0.05e-6);
    EXPECT_NEAR(errorsOf(100, 6, 2, LaplacianForm::morris).gradient, 1.0e-8, 0.05e-8);
    EXPECT_NEAR(errorsOf(100, 6, 2, LaplacianForm::morris).laplacian, 2.6e-9, 0.05e-9);
    EXPECT_NEAR(errorsOf(100, 4, 8, LaplacianForm::morris).gradient, 1.9e-3, 0.05e-3);
    EXPECT_NEAR(errorsOf(100, 10, 8, LaplacianForm::morris).laplacian, 1.3e-9, 0.05e-9);
}

TEST(SpectralOperators, ExactOnesDifferentiateTrigonometricPolynomials)
{
    const Lattice lattice = test::periodicBox({1, 9, 8}, {0, 1, 2}); // x is left out
    SpectralOperators operators = operatorsOf(lattice, test::exactKernel(), LaplacianForm::exact);
    const RealField f =
        fieldOf(lattice, 2, [](int c, double, double y, double z) { return c + std::sin(2 * pi * (4 * y + 1.5 * z)); });
    RealField gradient(2, lattice.points());
    operators.gradient(f, 1, gradient);
    const RealField expected = fieldOf(lattice, 2,
                                       [](int c, double, double y, double z)
                                       { return 2 * pi * (c == 0 ? 4 : 1.5) * std::cos(2 * pi * (4 * y + 1.5 * z)); });
    EXPECT_LE(relativeL2(gradient, expected), 1e-14);

    RealField laplacian(2, lattice.points());
    operators.laplacian(f, laplacian);
    const RealField curvature = fieldOf(lattice, 2,
                                        [](int, double, double y, double z)
                                        { return -4 * pi * pi * (16 + 2.25) * std::sin(2 * pi * (4 * y + 1.5 * z)); });
    EXPECT_LE(relativeL2(laplacian, curvature), 1e-14);
}

TEST(SpectralOperators, CurlIsThatOfTheComponents)
{
    const Lattice square = test::unitSquare(12);
    SpectralOperators plane = operatorsOf(square, test::exactKernel(), LaplacianForm::exact);
    const RealField u =
        fieldOf(square, 2,
                [](int c, double x, double y, double) { return c == 0 ? std::sin(2 * pi * y) : std::sin(4 * pi * x); });
    RealField vorticity(1, square.points());
    plane.curl(u, vorticity);
    EXPECT_LE(relativeL2(vorticity, fieldOf(square, 1,
                                            [](int, double x, double y, double)
                                            { return 4 * pi * std::cos(4 * pi * x) - 2 * pi * std::cos(2 * pi * y); })),
              1e-14);

    // Arnold-Beltrami-Childress flow: its curl is 2 pi times itself.
    const Lattice cube = test::unitCube(8);
    SpectralOperators space = operatorsOf(cube, test::exactKernel(), LaplacianForm::exact);
    const RealField abc = fieldOf(cube, 3,
                                  [](int c, double x, double y, double z)
                                  {
                                      const std::array<double, 3> r{2 * pi * x, 2 * pi * y, 2 * pi * z};
                                      const auto i = static_cast<std::size_t>(c);
                                      return std::sin(r[(i + 2) % 3]) + std::cos(r[(i + 1) % 3]);
                                  });
    RealField curl(3, cube.points());
    space.curl(abc, curl);
    for (int c = 0; c < 3; ++c)
    {
        for (double& value : curl[c]) { value /= 2 * pi; }
    }
    EXPECT_LE(relativeL2(curl, abc), 1e-14);
}

TEST(Laplacians, AreListed)
{
    EXPECT_EQ(laplacians()[(Word{"morris", {}})], LaplacianForm::morris);
    EXPECT_EQ(laplacians()[(Word{"secondDerivative", {}})], LaplacianForm::secondDerivative);
    EXPECT_EQ(laplacians()[(Word{"exact", {}})], LaplacianForm::exact);
}

} // namespace
} // namespace isph
