#pragma once

#include "kernels/KernelSettings.hpp"
#include "lattice/Lattice.hpp"
#include "operators/LaplacianForm.hpp"

#include <array>
#include <vector>

namespace isph
{

/// The classical SPH operators on a lattice as weights of neighbours: (D_j f)_a = sum_b gradient[j][b] f_b and
/// (lap f)_a = sum_b laplacian[b] f_b, over the neighbours b of a, itself included.
///
/// Gradient: Fourtakas et al. 2021, eq. 2.15. Both Laplacians act on differences f_b - f_a.
///
/// Morris: eq. 3.2 of the same with the factor of docs/theory/errata.md, -2 f/h^2. In scaled coordinates x_j/h_j it
/// knows one h only, so where the spacings differ it supplies what the widest axis has of the Laplacian, and the
/// kernel's second derivatives the rest, (1/h_j^2 - 1/h_max^2) (f + (x_j/h_j)^2 g): second derivatives of smooth
/// kernels keep their order on a lattice. (The weights ((d + 2) (x_j/h_j)^2/q^2 - 1) f/h_j^2 of Espanol & Revenga 2003
/// do not, being of no direction at q = 0: measured in two dimensions at h/dx = 2, order 10 is 27 % off along the wide
/// axis at spacings 2 : 1, and grows waves at 10 : 1.)
///
/// What the narrow axis' weights leave along a wide one grows with the square of the ratio of spacings, as it does for
/// the second-derivative form. Relative error of d2/dx2 at 10 : 1 and 100 : 1, h/dx = 2: 4e-7 and 4e-5 for order 10
/// with 6h, 2e-6 and 2e-4 for order 4 with 5h, but 1 % and 100 % for order 4 with 4h, 0.6 % and 60 % for the quintic
/// spline, which beyond 20 : 1 may also let waves grow. Closed symbols have no such limit.
struct KernelSamples
{
    /// \throws Error(input) without origin when the support holds too many neighbours, or none.
    KernelSamples(const Lattice& lattice, const KernelSettings& settings, LaplacianForm form);

    std::vector<std::array<int, 3>> offsets; ///< along the active axes
    std::array<std::vector<double>, 3> gradient;
    std::vector<double> laplacian; ///< empty for LaplacianForm::exact, which has no samples
};

} // namespace isph
