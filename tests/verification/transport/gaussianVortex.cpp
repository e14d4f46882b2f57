// A Gaussian that enters nothing and leaves through open faces: Lin, Fourtakas & Rogers 2026, section 5, with alpha =
// 100, unit square, U = (1, 0.5), values at the inlets x = 0 and y = 0, nothing at the outlets.

#include "kernels/Gaussian.hpp"
#include "support/record.hpp"
#include "support/transportRun.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace
{

double vortex(double x, double y, double, double t)
{
    const double dx = x - 0.5 - t;
    const double dy = y - 0.5 - 0.5 * t;
    return std::exp(-100 * (dx * dx + dy * dy));
}

struct Errors
{
    double passing; ///< L2 at t = 0.2, the vortex about to reach the outlets
    double left;    ///< L2 at t = 3, when it has left long ago
};

Errors errorsOf(int n, int kernelOrder, double smoothingLength, int degree, double end)
{
    const Lattice lattice = boxOf({n, n, 0}, {true, true, false});
    FlowSettings settings = transportSettings(lattice, degree);
    settings.kernel.kernel = std::make_unique<Gaussian>(kernelOrder);
    settings.kernel.smoothingLength = smoothingLength;
    ScalarFaces faces;
    for (std::size_t d = 0; d < 2; ++d) { faces[d] = {valueFace(vortex), outflowFace()}; }
    TransportRun run(lattice, 0, std::move(settings), uniformVelocity({1, 0.5, 0}), std::move(faces));
    run.start(vortex);
    run.marchAtCourant(0.2, 0.4);
    const double passing = run.error(vortex);
    run.marchAtCourant(end, 0.4);
    return {passing, run.error(vortex)};
}

void recordErrors(const std::string& name, const std::array<Errors, 3>& errors)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        record(name + ".passing." + std::to_string(40 << i), errors[i].passing);
        record(name + ".left." + std::to_string(40 << i), errors[i].left);
    }
}

// What an unbounded lattice would give while the vortex is still inside: the Fourier integral of the Gaussian with the
// kernel's symbol and the growth factor of RK3 (tutorials/scalarTransportFoam/gaussianVortexConvection/validation).
constexpr std::array<double, 2> unboundedOrder20{4.821984e-5, 6.114494e-6};
constexpr std::array<double, 2> unboundedOrder4{2.417720e-3, 1.764138e-4};

double order(double coarse, double fine) { return std::log2(coarse / fine); }

} // namespace

TEST(GaussianVortex, defaultKernel)
{
    const std::array<Errors, 3> errors{errorsOf(40, 20, 1.5, 4, 3), errorsOf(80, 20, 1.5, 4, 3),
                                       errorsOf(160, 20, 1.5, 4, 3)};
    recordErrors("order20", errors);
    // The time scheme is third order, and nothing else is left.
    EXPECT_GE(order(errors[0].passing, errors[1].passing), 2.9);
    EXPECT_GE(order(errors[1].passing, errors[2].passing), 2.9);
    for (std::size_t i = 0; i < 2; ++i) { EXPECT_NEAR(errors[i].passing / unboundedOrder20[i], 1, 0.01); }
    for (const Errors& error : errors) { EXPECT_LE(error.left, 1e-4); }
    EXPECT_LT(errors[1].left, errors[0].left);
    EXPECT_LT(errors[2].left, errors[1].left);
}

TEST(GaussianVortex, gaussianOfOrderFour)
{
    const std::array<Errors, 3> errors{errorsOf(40, 4, 1.3, 4, 0.3), errorsOf(80, 4, 1.3, 4, 0.3),
                                       errorsOf(160, 4, 1.3, 4, 0.3)};
    recordErrors("order4", errors);
    EXPECT_GE(order(errors[0].passing, errors[1].passing), 3.5);
    EXPECT_GE(order(errors[1].passing, errors[2].passing), 3.5);
    for (std::size_t i = 0; i < 2; ++i) { EXPECT_NEAR(errors[i].passing / unboundedOrder4[i], 1, 0.001); }
}

// A Gaussian of order 4 with continuation of degree 4 has eigenvalues a little to the right of the imaginary axis;
// degree 3 has none (tests/verification/continuation).
TEST(GaussianVortex, gaussianOfOrderFourLeavesNothingBehind)
{
    for (const int degree : {3, 4})
    {
        const std::array<Errors, 2> errors{errorsOf(40, 4, 1.3, degree, 3), errorsOf(80, 4, 1.3, degree, 3)};
        record("order4.degree" + std::to_string(degree) + ".left.40", errors[0].left);
        record("order4.degree" + std::to_string(degree) + ".left.80", errors[1].left);
        EXPECT_LE(errors[1].left, 1e-4) << "degree " << degree;
        EXPECT_LT(errors[1].left, errors[0].left) << "degree " << degree;
    }
}
