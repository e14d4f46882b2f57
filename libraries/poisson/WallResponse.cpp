#include "poisson/WallResponse.hpp"

#include <cmath>
#include <utility>

namespace isph
{

namespace
{

/// (sinh(a)/a - 1)/t or (cosh(a) - 1)/t for a^2 = ratio t, by their series.
double series(double ratio, double t, bool cosh)
{
    constexpr int terms = 14; // enough for a <= 2
    double term = 1;
    double sum = 0;
    for (int j = 1; j <= terms; ++j)
    {
        term *= ratio / (cosh ? (2 * j - 1) * (2 * j) : (2 * j) * (2 * j + 1));
        sum += term;
        term *= t;
    }
    return sum;
}

} // namespace

WallResponse::WallResponse(const BoundedAxis& axis, AlignedVector<double> kappa2)
    : spacing_(axis.spacing),
      staggered_(axis.staggered),
      kappa2_(std::move(kappa2)),
      decay_(kappa2_.size()),
      quarter_(kappa2_.size()),
      relative2_(kappa2_.size()),
      axisK2_(axis.k2),
      axisSine2_(axis.sine2)
{
    for (std::size_t t = 0; t < kappa2_.size(); ++t)
    {
        const double x = 0.5 * std::sqrt(kappa2_[t]) * spacing_;
        const double sinhOverX = x > 0 ? -std::expm1(-2 * x) / (2 * x) : 1; // times exp(-x)
        decay_[t] = std::exp(-2 * x);
        relative2_[t] = sinhOverX * sinhOverX;
        quarter_[t] = x * x * relative2_[t];
    }
    low_ = ofEnd(axis.ends.low);
    high_ = ofEnd(axis.ends.high);
}

WallResponse::OfEnd WallResponse::ofEnd(End end) const
{
    const std::size_t modes = kappa2_.size();
    OfEnd result{AlignedVector<double>(modes), AlignedVector<double>(modes), AlignedVector<double>(modes)};
    const bool neumann = end == End::neumann;
    for (std::size_t t = 0; t < modes; ++t)
    {
        const double x2 = 0.25 * kappa2_[t] * spacing_ * spacing_;
        const double x = std::sqrt(x2);
        const double e = decay_[t];
        const double root = std::exp(-x);
        const double sinhOverX = std::sqrt(relative2_[t]); // times exp(-x)
        double f = e;
        if (neumann) { f = sinhOverX * (staggered_ ? root : 0.5 * (1 + e)); }
        else if (staggered_) { f = 0.5 * root * (1 + e); }
        double slope = 0;
        double relativeSlope = 0; // of sinh x/x, times exp(-x)
        if (x > 1)
        {
            slope = neumann || staggered_ ? (f - e) / x2 : 0;
            relativeSlope = (sinhOverX - root) / x2;
        }
        else
        {
            if (neumann) { slope = e * series(staggered_ ? 1 : 4, x2, false); }
            else if (staggered_) { slope = e * series(1, x2, true); }
            relativeSlope = root * series(1, x2, false);
        }
        result.f[t] = f;
        result.slope[t] = slope;
        if (kappa2_[t] > 0)
        {
            result.mean[t] = (slope - relativeSlope * (sinhOverX + root)) / (relative2_[t] * kappa2_[t]);
        }
    }
    return result;
}

void WallResponse::scale(AlignedVector<double>& low, AlignedVector<double>& high) const
{
    for (std::size_t t = 0; t < kappa2_.size(); ++t)
    {
        low[t] *= low_.f[t];
        high[t] *= high_.f[t];
    }
}

double WallResponse::closure(std::size_t t, std::size_t i, const OfEnd& end) const
{
    const double s2 = axisSine2_[i];
    if (s2 == 0) { return end.mean[t]; }
    const double quarterSpacing2 = 0.25 * spacing_ * spacing_;
    return (1 / (kappa2_[t] + axisK2_[i]) -
            quarterSpacing2 * (relative2_[t] - s2 * end.slope[t]) / denominator(t, s2)) /
           s2;
}

} // namespace isph
