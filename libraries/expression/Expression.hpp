#pragma once

#include "core/Origin.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace isph
{

/// A formula of x, y, z, t, pi and named constants, evaluated in double precision by muParser.
///
/// Knows + - * / ^, comparisons, && ||, cond ? a : b, sin cos tan asin acos atan atan2 sinh cosh tanh exp log (natural)
/// sqrt abs min max erf pow floor sign, sum(n, 1, 64, ...) over an integer n, and noise(seed), uniform in [-1, 1] and a
/// fixed function of the point (contract, section 1). Besides, for OpenFOAM's #eval: log10 ceil sqr cbrt mag hypot
/// degToRad radToDeg and pi(). One object serves one thread at a time.
class Expression
{
public:
    /// Value of a name that is none of x y z t pi, or nothing if there is no such name.
    using Constants = std::function<std::optional<double>(const std::string& name)>;

    /// \throws Error(input) at origin, for a syntax error (with the position) or an unknown name (with the nearest).
    Expression(const std::string& text, const Constants& constants, const Origin& origin);
    ~Expression();
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    /// \throws Error(input) at the origin when the value is not finite, naming the point.
    double operator()(double x, double y, double z, double t) const;

    /// At many points of one time; an empty span of coordinates stands for zeros.
    /// \throws Error(input) at the origin when a value is not finite, naming the point.
    void evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z, double t,
                  std::span<double> values) const;

    bool dependsOnTime() const;
    bool dependsOnSpace() const;
    const std::string& text() const;

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

} // namespace isph
