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
/// Gradient: Fourtakas et al. 2021, eq. 2.15. Morris: their eq. 3.2 with the factor of docs/theory/errata.md; where the
/// spacings differ, its generalisation by Espanol & Revenga 2003, the sum over axes of
/// ((d + 2) (x_j/h_j)^2/q^2 - 1) f/h_j^2, which is Morris' where they are equal.
struct KernelSamples
{
    /// \throws Error(input) without origin when the support is too large.
    KernelSamples(const Lattice& lattice, const KernelSettings& settings, LaplacianForm form);

    std::vector<std::array<int, 3>> offsets; ///< along the active axes
    std::array<std::vector<double>, 3> gradient;
    std::vector<double> laplacian; ///< empty for LaplacianForm::exact, which has no samples
};

} // namespace isph
