#pragma once

#include <cmath>

namespace isph
{

/// A number as the unevaluated sum of two doubles, some 31 digits (Dekker 1971): for tables that double precision is
/// not enough to make.
class DoubleDouble
{
public:
    constexpr DoubleDouble(double value = 0) : high_(value) {}
    constexpr DoubleDouble(double high, double low) : high_(high), low_(low) {}

    double rounded() const { return high_ + low_; }

    friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b)
    {
        const DoubleDouble s = exactSum(a.high_, b.high_);
        const DoubleDouble t = exactSum(a.low_, b.low_);
        const DoubleDouble first = quickSum(s.high_, s.low_ + t.high_);
        return quickSum(first.high_, first.low_ + t.low_);
    }
    friend DoubleDouble operator-(DoubleDouble a) { return {-a.high_, -a.low_}; }
    friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }
    friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b)
    {
        const double product = a.high_ * b.high_;
        const double error = std::fma(a.high_, b.high_, -product);
        return quickSum(product, error + (a.high_ * b.low_ + a.low_ * b.high_));
    }
    friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b)
    {
        const double first = a.high_ / b.high_;
        const DoubleDouble rest = a - b * first;
        const double second = rest.high_ / b.high_;
        const DoubleDouble last = rest - b * second;
        return quickSum(first, second) + last.high_ / b.high_;
    }
    friend DoubleDouble squareRoot(DoubleDouble a)
    {
        if (a.high_ <= 0) { return 0; }
        const DoubleDouble root = std::sqrt(a.high_);
        return root + (a - root * root) / (root + root);
    }

private:
    static DoubleDouble quickSum(double a, double b)
    {
        const double sum = a + b;
        return {sum, b - (sum - a)};
    }
    static DoubleDouble exactSum(double a, double b)
    {
        const double sum = a + b;
        const double part = sum - a;
        return {sum, (a - (sum - part)) + (b - part)};
    }

    double high_;
    double low_ = 0;
};

} // namespace isph
