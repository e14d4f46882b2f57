#include "flow/modeLoops.hpp"

namespace isph
{

namespace
{

using Complex = std::complex<double>;

double* pairs(Complex* values) { return reinterpret_cast<double*>(values); }
const double* pairs(const Complex* values) { return reinterpret_cast<const double*>(values); }

template<bool First, bool Last, bool Factor>
void predictLoop(const Prediction& prediction, const double* __restrict u, const double* __restrict rate,
                 double* __restrict carried, double* __restrict value, std::size_t length)
{
    const double now = prediction.now;
    const double before = prediction.before;
    const double* __restrict lessOne = prediction.lessOne;
    for (std::size_t i = 0; i < length; ++i)
    {
        for (std::size_t part = 0; part < 2; ++part)
        {
            const std::size_t n = 2 * i + part;
            double sum = u[n] + now * rate[n];
            if constexpr (!First) { sum += before * carried[n]; }
            if constexpr (Factor) { sum += lessOne[i] * sum; }
            value[n] = sum;
            if constexpr (!Last && Factor) { carried[n] = rate[n] + lessOne[i] * rate[n]; }
            if constexpr (!Last && !Factor) { carried[n] = rate[n]; }
        }
    }
}

template<bool First, bool Last>
void predictWith(const Prediction& prediction, const double* u, const double* rate, double* carried, double* value,
                 std::size_t length)
{
    if (prediction.lessOne != nullptr) { predictLoop<First, Last, true>(prediction, u, rate, carried, value, length); }
    else { predictLoop<First, Last, false>(prediction, u, rate, carried, value, length); }
}

template<int D, bool Keep>
void projectLoop(const std::array<const double*, 3>& d, const double* __restrict inverse,
                 const std::array<Complex*, 3>& value, Complex* multiplier, std::size_t length)
{
    const double* __restrict dx = d[0];
    const double* __restrict dy = d[1];
    const double* __restrict dz = d[2];
    double* __restrict u = pairs(value[0]);
    double* __restrict v = pairs(value[1]);
    double* __restrict w = D == 3 ? pairs(value[2]) : nullptr;
    double* __restrict kept = Keep ? pairs(multiplier) : nullptr;
    for (std::size_t i = 0; i < length; ++i)
    {
        for (std::size_t part = 0; part < 2; ++part)
        {
            const std::size_t n = 2 * i + part;
            double sum = dx[i] * u[n] + dy[i] * v[n];
            if constexpr (D == 3) { sum += dz[i] * w[n]; }
            sum *= inverse[i];
            u[n] -= dx[i] * sum;
            v[n] -= dy[i] * sum;
            if constexpr (D == 3) { w[n] -= dz[i] * sum; }
            if constexpr (Keep) { kept[n] = sum; }
        }
    }
}

template<int D, bool Smoothed, bool First, bool Last, bool Factor>
void plainLoop(const PlainSubstep& modes, std::size_t first, std::size_t length, const std::array<double, 2>& kRow)
{
    constexpr std::size_t products = D == 2 ? 2 : 5;
    std::array<const double*, products> p;
    std::array<const double*, D> from;
    std::array<double*, D> carried;
    std::array<double*, D> to;
    std::array<double*, D> inputs;
    for (std::size_t i = 0; i < products; ++i) { p[i] = pairs(modes.products[i] + first); }
    for (std::size_t c = 0; c < D; ++c)
    {
        from[c] = pairs(modes.from[c] + first);
        carried[c] = pairs(modes.carried[c] + first);
        to[c] = pairs(modes.to[c] + first);
        inputs[c] = pairs(modes.inputs[c] + first);
    }
    const double now = modes.prediction.now;
    const double before = modes.prediction.before;
    const double* lessOne = Factor ? modes.prediction.lessOne + first : nullptr;
    const double* k0 = modes.k0;
    const auto [ky, kz] = kRow;
    const double* smoothing = Smoothed ? modes.smoothing + first : nullptr;
    const double* inverse = modes.inverse + first;
    const double perPoint = -modes.scale;
    // Every value is read before it is written, and at no other place.
#pragma GCC ivdep
    for (std::size_t i = 0; i < length; ++i)
    {
        const double scale = Smoothed ? perPoint * smoothing[i] : perPoint;
        const double x = scale * k0[i];
        const double y = scale * ky;
        const double z = scale * kz;
        const std::size_t n = 2 * i;
        // i times a real combination of products.
        std::array<std::array<double, D>, 2> rate;
        for (std::size_t part = 0; part < 2; ++part)
        {
            const std::size_t m = n + part;
            std::array<double, D> sum;
            if constexpr (D == 2)
            {
                sum[0] = x * p[0][m] + y * p[1][m];
                sum[1] = x * p[1][m];
            }
            else
            {
                sum[0] = x * p[0][m] + y * p[2][m] + z * p[3][m];
                sum[1] = x * p[2][m] + y * p[1][m] + z * p[4][m];
                sum[2] = x * p[3][m] + y * p[4][m];
            }
            for (std::size_t c = 0; c < D; ++c) { rate[1 - part][c] = part == 0 ? sum[c] : -sum[c]; }
        }
        for (std::size_t part = 0; part < 2; ++part)
        {
            const std::size_t m = n + part;
            std::array<double, D> u;
            for (std::size_t c = 0; c < D; ++c)
            {
                u[c] = from[c][m] + now * rate[part][c];
                if constexpr (!First) { u[c] += before * carried[c][m]; }
                if constexpr (Factor) { u[c] += lessOne[i] * u[c]; }
                if constexpr (!Last && Factor) { carried[c][m] = rate[part][c] + lessOne[i] * rate[part][c]; }
                if constexpr (!Last && !Factor) { carried[c][m] = rate[part][c]; }
            }
            double sum = k0[i] * u[0] + ky * u[1];
            if constexpr (D == 3) { sum += kz * u[2]; }
            sum *= inverse[i];
            u[0] -= k0[i] * sum;
            u[1] -= ky * sum;
            if constexpr (D == 3) { u[2] -= kz * sum; }
            for (std::size_t c = 0; c < D; ++c) { to[c][m] = inputs[c][m] = u[c]; }
        }
    }
}

using PlainLoop = void (*)(const PlainSubstep&, std::size_t, std::size_t, const std::array<double, 2>&);

template<int D, bool Smoothed, bool Factor>
PlainLoop plainWith(bool first, bool last)
{
    if (first)
    {
        return last ? &plainLoop<D, Smoothed, true, true, Factor> : &plainLoop<D, Smoothed, true, false, Factor>;
    }
    return last ? &plainLoop<D, Smoothed, false, true, Factor> : &plainLoop<D, Smoothed, false, false, Factor>;
}

template<int D>
PlainLoop plainIn(const PlainSubstep& modes)
{
    const double* lessOne = modes.prediction.lessOne;
    const bool first = modes.prediction.first;
    const bool last = modes.prediction.last;
    if (modes.smoothing == nullptr)
    {
        return lessOne != nullptr ? plainWith<D, false, true>(first, last) : plainWith<D, false, false>(first, last);
    }
    return lessOne != nullptr ? plainWith<D, true, true>(first, last) : plainWith<D, true, false>(first, last);
}

} // namespace

void advancePlain(const PlainSubstep& modes, int dimensions, std::size_t first, std::size_t length,
                  const std::array<double, 2>& kRow)
{
    const PlainLoop loop = dimensions == 2 ? plainIn<2>(modes) : plainIn<3>(modes);
    loop(modes, first, length, kRow);
}

void predict(const Prediction& prediction, const Complex* u, const Complex* rate, Complex* carried, Complex* value,
             std::size_t length)
{
    const auto with = prediction.first ? (prediction.last ? &predictWith<true, true> : &predictWith<true, false>)
                                       : (prediction.last ? &predictWith<false, true> : &predictWith<false, false>);
    with(prediction, pairs(u), pairs(rate), pairs(carried), pairs(value), length);
}

void project(const std::array<const double*, 3>& d, const double* inverse, int dimensions,
             const std::array<Complex*, 3>& value, Complex* multiplier, std::size_t length)
{
    const bool keep = multiplier != nullptr;
    const auto loop = dimensions == 2 ? (keep ? &projectLoop<2, true> : &projectLoop<2, false>)
                                      : (keep ? &projectLoop<3, true> : &projectLoop<3, false>);
    loop(d, inverse, value, multiplier, length);
}

void multiplyByPhase(Complex* values, const Complex* first, Complex ofRow, std::size_t length)
{
    double* v = pairs(values);
    const double* f = pairs(first);
    for (std::size_t i = 0; i < length; ++i)
    {
        const double re = f[2 * i] * ofRow.real() - f[2 * i + 1] * ofRow.imag();
        const double im = f[2 * i] * ofRow.imag() + f[2 * i + 1] * ofRow.real();
        const double x = v[2 * i];
        const double y = v[2 * i + 1];
        v[2 * i] = x * re - y * im;
        v[2 * i + 1] = x * im + y * re;
    }
}

void multiplyByFactors(Complex* values, const double* factors, double ofRow, std::size_t length)
{
    double* v = pairs(values);
    for (std::size_t i = 0; i < length; ++i)
    {
        const double factor = factors[i] * ofRow;
        v[2 * i] *= factor;
        v[2 * i + 1] *= factor;
    }
}

} // namespace isph
