#include "operators/LaplacianForm.hpp"

#include <array>

namespace isph
{

const Selection<LaplacianForm>& laplacians()
{
    static constexpr std::array<Selection<LaplacianForm>::Variant, 3> table{{
        {"morris", "Morris, Fox & Zhu 1997: monotone and negative, robust", LaplacianForm::morris},
        {"secondDerivative", "second derivative of the kernel", LaplacianForm::secondDerivative},
        {"exact", "-k^2 of the trigonometric interpolant", LaplacianForm::exact},
    }};
    static_assert(distinct(table));
    static constexpr Selection<LaplacianForm> selection("laplacian", table);
    return selection;
}

} // namespace isph
