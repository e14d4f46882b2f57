#pragma once

namespace isph
{

/// A smoothing kernel in scaled form: everything is a function of q = |x|/h, with h = 1.
///
/// On a lattice with spacings dx_j each axis keeps its own h_j = (h/dx) dx_j, so that q^2 = sum (x_j/h_j)^2 and
///     W = w(q) / prod h,   dW/dx_j = x_j/h_j^2 f(q) / prod h,   d2W/dx_j^2 = (f + (x_j/h_j)^2 g) / (h_j^2 prod h)
/// with f = w'/q and g = f'/q, which are finite at q = 0. Fourier symbols are functions of s = sum (k_j h_j)^2/4 and do
/// not depend on the dimension (notes of docs/theory/periodic.md, section 1).
class Kernel
{
public:
    virtual ~Kernel() = default;

    /// Order of accuracy of the smoothing (2, 4, ...); 0 for the exact derivative, which has no order.
    virtual int order() const = 0;

    virtual double w(double q, int dimensions) const = 0;
    virtual double f(double q, int dimensions) const = 0;
    virtual double g(double q, int dimensions) const = 0;

    /// Support radius in h beyond which the samples are cut off when nothing else is asked for.
    virtual double supportRadius() const = 0;

    /// Whether the symbols below exist in closed form; else the kernel is sampled.
    virtual bool closed() const = 0;

    /// Fourier transform of W; the first derivative is i k_j symbol(s), the second-derivative Laplacian -k^2 symbol(s).
    virtual double symbol(double s) const = 0;

    /// The Laplacian of Morris et al. 1997 is -k^2 morrisSymbol(s).
    virtual double morrisSymbol(double s) const = 0;
};

} // namespace isph
