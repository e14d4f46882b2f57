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

} // namespace

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
