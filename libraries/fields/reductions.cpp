#include "fields/reductions.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace isph
{

namespace
{

/// Sum of term(i) for i < size: blocks of fixed length, then a Neumaier-compensated sum of the blocks in order.
template<class Term>
double blockedSum(std::size_t size, Term term)
{
    constexpr std::size_t block = 256;
    double total = 0;
    double lost = 0;
    for (std::size_t begin = 0; begin < size; begin += block)
    {
        const std::size_t end = begin + block < size ? begin + block : size;
        double part = 0;
        for (std::size_t i = begin; i < end; ++i) { part += term(i); }
        const double next = total + part;
        lost += std::abs(total) >= std::abs(part) ? (total - next) + part : (part - next) + total;
        total = next;
    }
    // An overflow makes the compensation a NaN; the plain sum still says what happened.
    return std::isfinite(lost) ? total + lost : total;
}

} // namespace

double sum(std::span<const double> values)
{
    return blockedSum(values.size(), [values](std::size_t i) { return values[i]; });
}

double sumOfSquares(std::span<const double> values) { return sumOfProducts(values, values); }

double sumOfProducts(std::span<const double> a, std::span<const double> b)
{
    assert(a.size() == b.size());
    return blockedSum(a.size(), [a, b](std::size_t i) { return a[i] * b[i]; });
}

double sumOfProducts(std::span<const double> a, std::span<const double> b, std::span<const double> c)
{
    assert(a.size() == b.size() && a.size() == c.size());
    return blockedSum(a.size(), [a, b, c](std::size_t i) { return a[i] * b[i] * c[i]; });
}

double largestMagnitude(std::span<const double> values)
{
    double largest = 0;
    for (const double value : values)
    {
        const double magnitude = std::abs(value);
        if (!(magnitude <= largest)) { largest = magnitude; }
        if (std::isnan(largest)) { return std::numeric_limits<double>::quiet_NaN(); }
    }
    return largest;
}

bool allFinite(std::span<const double> values)
{
    // x - x is 0 for a finite x and NaN otherwise, and sums of zeros vectorise.
    return blockedSum(values.size(), [values](std::size_t i) { return values[i] - values[i]; }) == 0.0;
}

} // namespace isph
