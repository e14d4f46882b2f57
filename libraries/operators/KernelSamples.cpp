#include "operators/KernelSamples.hpp"

#include "neighbours/LatticeStencil.hpp"

#include <cmath>

namespace isph
{

KernelSamples::KernelSamples(const Lattice& lattice, const KernelSettings& settings, LaplacianForm form)
    : offsets(latticeStencil(lattice, settings.smoothingLength, settings.supportRadius))
{
    const int dimensions = lattice.dimensions();
    const Kernel& kernel = *settings.kernel;
    std::array<double, 3> dx{1, 1, 1};
    std::array<double, 3> h{1, 1, 1};
    double scale = 1; // volume of a point over prod h
    for (int d = 0; d < dimensions; ++d)
    {
        const auto axis = static_cast<std::size_t>(d);
        dx[axis] = lattice.activeAxis(d).spacing();
        h[axis] = settings.smoothingLength * dx[axis];
        scale /= settings.smoothingLength;
    }

    std::array<double, 3> firstMoment{0, 0, 0}; // of gradient[j] with x_j; 1 for a consistent operator
    double secondMoment = 0;                    // of the second-derivative Laplacian at equal spacings, likewise
    double sumOfWeights = 0;
    std::size_t self = 0;
    for (std::size_t b = 0; b < offsets.size(); ++b)
    {
        double q2 = 0;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
        {
            const double scaled = offsets[b][d] * dx[d] / h[d];
            q2 += scaled * scaled;
        }
        const double q = std::sqrt(q2);
        const double f = scale * kernel.f(q, dimensions);
        const double g = form == LaplacianForm::secondDerivative ? scale * kernel.g(q, dimensions) : 0;
        secondMoment += 0.5 * q2 * (f + q2 * g / dimensions);
        if (q2 == 0) { self = b; }

        double weight = 0;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
        {
            const double x = offsets[b][d] * dx[d];
            const double scaled2 = (x / h[d]) * (x / h[d]);
            // grad W(x_a - x_b) with x_b - x_a = x, hence the minus.
            const double slope = -x * f / (h[d] * h[d]);
            gradient[d].push_back(slope);
            firstMoment[d] += slope * x;

            if (form == LaplacianForm::morris && q2 > 0)
            {
                weight -= ((dimensions + 2) * scaled2 / q2 - 1) * f / (h[d] * h[d]);
            }
            if (form == LaplacianForm::secondDerivative) { weight += (f + scaled2 * g) / (h[d] * h[d]); }
        }
        if (form != LaplacianForm::exact) { laplacian.push_back(weight); }
        sumOfWeights += weight;
    }

    if (settings.renormalise)
    {
        double mean = 0;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
        {
            for (double& weight : gradient[d]) { weight /= firstMoment[d]; }
            mean += firstMoment[d] / dimensions;
        }
        const double moment = form == LaplacianForm::morris ? mean : secondMoment;
        for (double& weight : laplacian) { weight /= moment; }
        sumOfWeights /= moment;
    }
    // Laplacians act on differences f_b - f_a, as a truncated kernel's weights do not add up to zero by themselves: the
    // point itself carries minus the sum of the others.
    if (!laplacian.empty()) { laplacian[self] -= sumOfWeights; }
}

} // namespace isph
