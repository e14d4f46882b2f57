#include "flow/Convection.hpp"

namespace isph
{

namespace
{

using Complex = Convection::Complex;

/// i d c, without the checks for infinities that complex multiplication makes.
inline Complex timesI(double d, const Complex& c) { return {-d * c.imag(), d * c.real()}; }

/// Products that are the rate already, but for their scale.
void scaledProducts(const ModeSpan& span, const SpectralField& products, double scale, int components,
                    const std::array<Complex*, 3>& rate)
{
    for (int c = 0; c < components; ++c)
    {
        const Complex* product = products[c].data() + span.first;
        Complex* out = rate[static_cast<std::size_t>(c)];
        for (std::size_t i = 0; i < span.length; ++i) { out[i] = scale * product[i]; }
    }
}

/// Divergence of u u with its last diagonal entry taken off the whole diagonal: that part is a pure gradient, which the
/// projection removes. 2-D: uu - vv, uv. 3-D: uu - ww, vv - ww, uv, uw, vw.
template<int D>
class DivergenceForm : public Convection
{
public:
    int inputs() const override { return D; }
    int products() const override { return D == 2 ? 2 : 5; }
    void deriveInputs(const ModeSpan&, SpectralField&) const override {}

    void multiply(RealField& points) const override
    {
        const double* u = points[0].data();
        const double* v = points[1].data();
        std::array<double*, 5> out{};
        for (int c = 0; c < (D == 2 ? 2 : 5); ++c) { out[static_cast<std::size_t>(c)] = points[c].data(); }
        const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(points.size());
        if constexpr (D == 2)
        {
#pragma omp parallel for simd schedule(static)
            for (std::ptrdiff_t i = 0; i < size; ++i)
            {
                const double x = u[i];
                const double y = v[i];
                out[0][i] = (x - y) * (x + y);
                out[1][i] = x * y;
            }
        }
        else
        {
            const double* w = points[2].data();
#pragma omp parallel for simd schedule(static)
            for (std::ptrdiff_t i = 0; i < size; ++i)
            {
                const double x = u[i];
                const double y = v[i];
                const double z = w[i];
                out[0][i] = (x - z) * (x + z);
                out[1][i] = (y - z) * (y + z);
                out[2][i] = x * y;
                out[3][i] = x * z;
                out[4][i] = y * z;
            }
        }
    }

    void rate(const ModeSpan& span, const SpectralField& products, double scale,
              const std::array<Complex*, 3>& rate) const override
    {
        const auto product = [&](int component) { return products[component].data() + span.first; };
        const double* dx = span.d[0];
        const double* dy = span.d[1];
        if constexpr (D == 2)
        {
            const Complex* difference = product(0);
            const Complex* shear = product(1);
            for (std::size_t i = 0; i < span.length; ++i)
            {
                rate[0][i] = timesI(-scale * dx[i], difference[i]) + timesI(-scale * dy[i], shear[i]);
                rate[1][i] = timesI(-scale * dx[i], shear[i]);
            }
        }
        else
        {
            const double* dz = span.d[2];
            const Complex* xx = product(0);
            const Complex* yy = product(1);
            const Complex* xy = product(2);
            const Complex* xz = product(3);
            const Complex* yz = product(4);
            for (std::size_t i = 0; i < span.length; ++i)
            {
                const double x = -scale * dx[i];
                const double y = -scale * dy[i];
                const double z = -scale * dz[i];
                rate[0][i] = timesI(x, xx[i]) + timesI(y, xy[i]) + timesI(z, xz[i]);
                rate[1][i] = timesI(x, xy[i]) + timesI(y, yy[i]) + timesI(z, yz[i]);
                rate[2][i] = timesI(x, xz[i]) + timesI(y, yz[i]);
            }
        }
    }
};

/// u x omega; the gradient of the kinetic energy is left to the projection.
template<int D>
class RotationalForm : public Convection
{
public:
    int inputs() const override { return D == 2 ? 3 : 6; }
    int products() const override { return D; }

    void deriveInputs(const ModeSpan& span, SpectralField& inputs) const override
    {
        const auto field = [&](int component) { return inputs[component].data() + span.first; };
        if constexpr (D == 2) { subtractedDerivatives(span, 0, field(1), 1, field(0), field(2)); }
        else
        {
            subtractedDerivatives(span, 1, field(2), 2, field(1), field(3));
            subtractedDerivatives(span, 2, field(0), 0, field(2), field(4));
            subtractedDerivatives(span, 0, field(1), 1, field(0), field(5));
        }
    }

    void multiply(RealField& points) const override
    {
        std::array<double*, 6> f{};
        for (int c = 0; c < inputs(); ++c) { f[static_cast<std::size_t>(c)] = points[c].data(); }
        const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(points.size());
#pragma omp parallel for simd schedule(static)
        for (std::ptrdiff_t i = 0; i < size; ++i)
        {
            const double u = f[0][i];
            const double v = f[1][i];
            if constexpr (D == 2)
            {
                const double omega = f[2][i];
                f[0][i] = v * omega;
                f[1][i] = -u * omega;
            }
            else
            {
                const double w = f[2][i];
                f[0][i] = v * f[5][i] - w * f[4][i];
                f[1][i] = w * f[3][i] - u * f[5][i];
                f[2][i] = u * f[4][i] - v * f[3][i];
            }
        }
    }

    void rate(const ModeSpan& span, const SpectralField& products, double scale,
              const std::array<Complex*, 3>& rate) const override
    {
        scaledProducts(span, products, scale, D, rate);
    }

private:
    /// out = D_a f - D_b g.
    static void subtractedDerivatives(const ModeSpan& span, std::size_t a, const Complex* f, std::size_t b,
                                      const Complex* g, Complex* out)
    {
        for (std::size_t i = 0; i < span.length; ++i)
        {
            out[i] = timesI(span.d[a][i], f[i]) - timesI(span.d[b][i], g[i]);
        }
    }
};

/// u . grad u; with continuity the last diagonal gradient is minus the sum of the others and is not transformed.
template<int D>
class AdvectiveForm : public Convection
{
public:
    explicit AdvectiveForm(bool continuity) : gradients_(D * D - (continuity ? 1 : 0)) {}

    int inputs() const override { return D + gradients_; }
    int products() const override { return D; }

    void deriveInputs(const ModeSpan& span, SpectralField& inputs) const override
    {
        // Component c along axis j is gradient c D + j; the last one, D_d u_d, comes last so that it can be left out.
        for (int gradient = 0; gradient < gradients_; ++gradient)
        {
            const Complex* f = inputs[gradient / D].data() + span.first;
            const double* d = span.d[static_cast<std::size_t>(gradient % D)];
            Complex* out = inputs[D + gradient].data() + span.first;
            for (std::size_t i = 0; i < span.length; ++i) { out[i] = timesI(d[i], f[i]); }
        }
    }

    void multiply(RealField& points) const override { write(points, 0); }

    /// Writes u . grad u, negative, behind firstProduct components.
    void write(RealField& points, int firstProduct) const
    {
        std::array<const double*, D + D * D> in{};
        for (int c = 0; c < inputs(); ++c) { in[static_cast<std::size_t>(c)] = points[c].data(); }
        std::array<double*, D> out{};
        for (int c = 0; c < D; ++c) { out[static_cast<std::size_t>(c)] = points[firstProduct + c].data(); }
        const bool complete = gradients_ == D * D;
        const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(points.size());
#pragma omp parallel for simd schedule(static)
        for (std::ptrdiff_t i = 0; i < size; ++i)
        {
            std::array<double, D> u;
            for (std::size_t j = 0; j < D; ++j) { u[j] = in[j][i]; }
            double trace = 0; // of the diagonal gradients but the last
            for (std::size_t c = 0; c < D; ++c)
            {
                double sum = 0;
                for (std::size_t j = 0; j < D; ++j)
                {
                    const bool last = c == D - 1 && j == D - 1;
                    const double gradient = !last || complete ? in[D + c * D + j][i] : -trace;
                    if (c == j) { trace += gradient; }
                    sum += u[j] * gradient;
                }
                out[c][i] = -sum;
            }
        }
    }

    void rate(const ModeSpan& span, const SpectralField& products, double scale,
              const std::array<Complex*, 3>& rate) const override
    {
        scaledProducts(span, products, scale, D, rate);
    }

private:
    int gradients_;
};

/// The mean of the advective and the divergence form: conserves energy for any antisymmetric derivative.
template<int D>
class SkewSymmetricForm : public Convection
{
public:
    explicit SkewSymmetricForm(bool continuity) : advective_(continuity) {}

    int inputs() const override { return advective_.inputs(); }
    int products() const override { return advective_.products() + divergence_.products(); }
    void deriveInputs(const ModeSpan& span, SpectralField& inputs) const override
    {
        advective_.deriveInputs(span, inputs);
    }

    void multiply(RealField& points) const override
    {
        // At every point a gradient is read before something is written in its place.
        advective_.write(points, divergence_.products());
        divergence_.multiply(points);
    }

    void rate(const ModeSpan& span, const SpectralField& products, double scale,
              const std::array<Complex*, 3>& rate) const override
    {
        divergence_.rate(span, products, scale, rate);
        for (int c = 0; c < D; ++c)
        {
            const Complex* advective = products[divergence_.products() + c].data() + span.first;
            Complex* out = rate[static_cast<std::size_t>(c)];
            for (std::size_t i = 0; i < span.length; ++i) { out[i] = 0.5 * (out[i] + scale * advective[i]); }
        }
    }

private:
    AdvectiveForm<D> advective_;
    DivergenceForm<D> divergence_; // its products come first
};

template<int D>
std::unique_ptr<Convection> make(ConvectionForm form, bool continuity)
{
    switch (form)
    {
    case ConvectionForm::divergence:
        return std::make_unique<DivergenceForm<D>>();
    case ConvectionForm::rotational:
        return std::make_unique<RotationalForm<D>>();
    case ConvectionForm::advective:
        return std::make_unique<AdvectiveForm<D>>(continuity);
    case ConvectionForm::skewSymmetric:
        return std::make_unique<SkewSymmetricForm<D>>(continuity);
    case ConvectionForm::none:
        break;
    }
    return nullptr;
}

} // namespace

const Selection<ConvectionForm>& convectionForms()
{
    static constexpr std::array<Selection<ConvectionForm>::Variant, 5> table{{
        {"divergence", "div(uu), trace removed: fewest transforms, robust", ConvectionForm::divergence},
        {"rotational", "omega x u: conserves energy", ConvectionForm::rotational},
        {"advective", "u . grad u, as the 2021 paper", ConvectionForm::advective},
        {"skewSymmetric", "mean of advective and divergence: conserves energy", ConvectionForm::skewSymmetric},
        {"none", "no convection (Stokes flow)", ConvectionForm::none},
    }};
    static_assert(distinct(table));
    static constexpr Selection<ConvectionForm> selection("convection", table);
    return selection;
}

std::unique_ptr<Convection> makeConvection(ConvectionForm form, int dimensions, bool continuity)
{
    return dimensions == 2 ? make<2>(form, continuity) : make<3>(form, continuity);
}

} // namespace isph
