#pragma once

#include "core/Selection.hpp"
#include "operators/DerivativeSymbol.hpp"

namespace isph
{

/// Which Laplacian the pressure equation inverts.
enum class Eigenvalues
{
    consistent,  ///< divergence of the discrete gradient: the projection is exact
    exact,       ///< -k^2 (Fourtakas et al. 2021, table 1)
    morris,      ///< the Morris Laplacian of the iterative solvers
    secondOrder, ///< central differences over three points an axis
    fourthOrder, ///< over five
};

const Selection<Eigenvalues>& eigenvalueForms();

/// Minus the eigenvalues by mode, over all modes.
/// \param morris table of laplacianSymbol for LaplacianForm::morris, needed for Eigenvalues::morris only
AlignedVector<double> poissonEigenvalues(const Lattice& lattice, Eigenvalues form, const DerivativeSymbol& derivative,
                                         std::span<const double> morris);

/// 1/eigenvalue by mode, 0 for the null modes: those whose value is at most 1e-24 k^2 of their own wave vector (a
/// global threshold would take good modes of stretched boxes for null).
AlignedVector<double> invertedEigenvalues(const ModeRows& rows, AlignedVector<double> eigenvalues);

} // namespace isph
