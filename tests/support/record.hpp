#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <string>

namespace isph::test
{

/// Keeps a measured figure with the test's result: `--gtest_output=xml` lists them all.
inline void record(const std::string& what, double value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    testing::Test::RecordProperty(what, text);
}

/// Compares measured figures with their bounds and keeps, with the test's result, how close the closest one came:
/// the property `closest`, 1 at the bound itself.
class Bounds
{
public:
    Bounds() = default;
    Bounds(const Bounds&) = delete;
    Bounds& operator=(const Bounds&) = delete;
    ~Bounds() { record("closest", closest_); }

    testing::AssertionResult atMost(double value, double bound)
    {
        return judge(value <= bound, value == bound ? 1 : value / bound, value, "above", bound);
    }
    testing::AssertionResult atLeast(double value, double bound)
    {
        return judge(value >= bound, value == bound ? 1 : bound / value, value, "below", bound);
    }
    testing::AssertionResult near(double value, double wanted, double tolerance)
    {
        return judge(std::abs(value - wanted) <= tolerance, std::abs(value - wanted) / tolerance, value,
                     "not within its tolerance of", wanted);
    }

private:
    testing::AssertionResult judge(bool holds, double part, double value, const char* how, double bound)
    {
        closest_ = part > closest_ || std::isnan(part) ? part : closest_;
        if (holds) { return testing::AssertionSuccess(); }
        return testing::AssertionFailure() << value << " is " << how << " " << bound;
    }

    double closest_ = 0;
};

} // namespace isph::test
