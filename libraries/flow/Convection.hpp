#pragma once

#include "core/Selection.hpp"
#include "fields/Field.hpp"

#include <array>
#include <memory>

namespace isph
{

/// How the convective term is written. All forms are equal for exact derivatives; for smoothed ones they differ in what
/// they conserve and in the transforms they cost (docs/theory/periodic.md, sections 7 and 9).
enum class ConvectionForm
{
    divergence,
    rotational,
    advective,
    skewSymmetric,
    none
};

const Selection<ConvectionForm>& convectionForms();

/// A stretch of modes of one row, with the derivative's symbol d_j along it.
struct ModeSpan
{
    std::size_t first; ///< index of its first mode in a component
    std::size_t length;
    std::array<const double*, 3> d;
};

/// The convective rate -(u . D)u of a flow that lives in Fourier space: what has to be transformed to physical space,
/// the products formed there, and the rate their transforms give.
class Convection
{
public:
    using Complex = std::complex<double>;

    virtual ~Convection() = default;

    /// Fields transformed to physical space; the velocity is the first of them.
    virtual int inputs() const = 0;

    /// Products transformed back.
    virtual int products() const = 0;

    /// Fills the inputs beyond the velocity (vorticity, gradients) from the velocity in inputs.
    virtual void deriveInputs(const ModeSpan& span, SpectralField& inputs) const = 0;

    /// Turns the inputs at the points into the products, in place: the field has components for the more of the two.
    virtual void multiply(RealField& points) const = 0;

    /// Rate of each velocity component along the span, from products that carry a factor 1/scale.
    virtual void rate(const ModeSpan& span, const SpectralField& products, double scale,
                      const std::array<Complex*, 3>& rate) const = 0;
};

/// \param continuity whether D.u = 0 holds with the very same D, so that one diagonal gradient follows from the others
/// \return null for ConvectionForm::none
std::unique_ptr<Convection> makeConvection(ConvectionForm form, int dimensions, bool continuity);

} // namespace isph
