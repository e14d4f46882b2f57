#pragma once

#include "core/Selection.hpp"

namespace isph
{

/// The discrete Laplacian of the viscous term.
enum class LaplacianForm
{
    morris,
    secondDerivative,
    exact
};

const Selection<LaplacianForm>& laplacians();

} // namespace isph
