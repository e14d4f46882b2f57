#include "caseFields/VelocityDerivatives.hpp"

#include "continuation/SmoothGram.hpp"
#include "fields/reductions.hpp"
#include "kernels/ExactKernel.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <memory>

namespace isph
{

namespace
{

KernelSettings exactKernel()
{
    KernelSettings settings;
    settings.kernel = std::make_unique<ExactKernel>();
    return settings;
}

Continuations smoothContinuations(const Lattice& lattice)
{
    Continuations continuations;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (axis.periodic()) { continue; }
        continuations[static_cast<std::size_t>(lattice.direction(d))] =
            std::make_unique<SmoothGram>(defaultSmoothGram(axis.count));
    }
    return continuations;
}

} // namespace

VelocityDerivatives::VelocityDerivatives(const Lattice& lattice)
    : lattice_(lattice),
      operators_(lattice, smoothContinuations(lattice), exactKernel()),
      faces_(boundedFaces(lattice)),
      scratch_(1, lattice.points())
{
}

void VelocityDerivatives::derivative(const RealField& U, int component, int d, std::span<double> result)
{
    derivative(d, U[component], result);
    for (const LatticeFace& face : faces_)
    {
        if (face.direction() != lattice_.direction(component) || d == component) { continue; }
        if (flowsThrough(face, U[component])) { continue; }
        for (const std::size_t n : face.innerPoints()) { result[n] = 0; }
    }
}

void VelocityDerivatives::vorticity(const RealField& U, RealField& vorticity)
{
    assert(U.components() == lattice_.dimensions() && vorticity.components() == vorticityComponents());
    const bool plane = lattice_.dimensions() == 2;
    for (int c = 0; c < vorticity.components(); ++c)
    {
        const int a = plane ? 0 : (c + 1) % 3;
        const int b = plane ? 1 : (c + 2) % 3;
        const double sign = plane ? normalSign(lattice_) : 1;
        derivative(U, b, a, vorticity[c]);
        derivative(U, a, b, scratch_[0]);
        std::ranges::transform(vorticity[c], scratch_[0], vorticity[c].begin(),
                               [sign](double dUbda, double dUadb) { return sign * (dUbda - dUadb); });
    }
}

RealField VelocityDerivatives::vorticity(const RealField& U)
{
    RealField result(vorticityComponents(), lattice_.points());
    vorticity(U, result);
    return result;
}

RealField VelocityDerivatives::divergence(const RealField& U)
{
    RealField result(1, lattice_.points());
    operators_.divergence(U, result);
    return result;
}

RealField VelocityDerivatives::Q(const RealField& U)
{
    const int dimensions = lattice_.dimensions();
    const auto along = [&](int direction)
    {
        RealField derivatives(dimensions, lattice_.points());
        for (int c = 0; c < dimensions; ++c) { derivative(U, c, direction, derivatives[c]); }
        return derivatives;
    };
    // The second invariant is the sum of the principal minors of the gradient: one for each pair of axes.
    RealField result(1, lattice_.points());
    for (int a = 0; a < dimensions; ++a)
    {
        const RealField alongA = along(a);
        for (int b = a + 1; b < dimensions; ++b)
        {
            const RealField alongB = along(b);
            for (std::size_t n = 0; n < result.size(); ++n)
            {
                result[0][n] += alongA[a][n] * alongB[b][n] - alongB[a][n] * alongA[b][n];
            }
        }
    }
    return result;
}

bool flowsThrough(const LatticeFace& face, std::span<const double> normalVelocity)
{
    if (face.innerPoints().empty()) { return true; }
    std::vector<double> values(face.points());
    face.values(normalVelocity, values);
    double inner = 0;
    for (const std::size_t n : face.innerPoints()) { inner = std::max(inner, std::abs(normalVelocity[n])); }
    // A formula may miss zero by round-off.
    return inner > 1e-12 * largestMagnitude(values);
}

double normalSign(const Lattice& lattice) { return lattice.direction(1) - lattice.direction(0) == 2 ? -1 : 1; }

} // namespace isph
