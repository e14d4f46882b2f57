#pragma once

#include "poisson/BoundedAxis.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace isph::test
{

/// One axis of a test problem.
struct BoxAxis
{
    AxisEnds ends;
    bool staggered = false;
    int intervals = 8;
    double extent = 1;
};

inline const AxisEnds periodicEnds{End::periodic, End::periodic};
inline const AxisEnds neumannEnds{End::neumann, End::neumann};
inline const AxisEnds dirichletEnds{End::dirichlet, End::dirichlet};
inline const AxisEnds neumannDirichlet{End::neumann, End::dirichlet};
inline const AxisEnds dirichletNeumann{End::dirichlet, End::neumann};

inline std::vector<AxisEnds> wallEnds() { return {neumannEnds, dirichletEnds, neumannDirichlet, dirichletNeumann}; }

inline std::string nameOf(const BoxAxis& axis)
{
    const auto letter = [](End end) { return end == End::periodic ? "p" : end == End::neumann ? "N" : "D"; };
    return std::string(letter(axis.ends.low)) + letter(axis.ends.high) + (axis.staggered ? " staggered" : "");
}

/// A function of one coordinate with its first derivative.
struct Profile
{
    std::function<double(double)> value;
    std::function<double(double)> slope;
};

/// Mode number m of an axis [0, extent] under homogeneous conditions, and its wavenumber.
struct AxisMode
{
    double k;
    Profile profile;

    AxisMode(const BoxAxis& axis, int m)
    {
        const AxisEnds ends = axis.ends;
        const bool periodic = ends.low == End::periodic;
        const double halfWaves = periodic                   ? 2 * m
                                 : ends.low != ends.high    ? m + 0.5
                                 : ends.low == End::neumann ? m
                                                            : m + 1;
        const double wave = std::numbers::pi * halfWaves / axis.extent;
        const double phase = periodic ? 0.7 : ends.low == End::neumann ? 0 : -0.5 * std::numbers::pi;
        k = wave;
        profile = {[=](double s) { return std::cos(wave * s + phase); },
                   [=](double s) { return -wave * std::sin(wave * s + phase); }};
    }
};

/// Solution of f'' = kappa^2 f that is about 1 at both walls, whatever kappa.
inline Profile wallLayers(double kappa, double extent)
{
    return {[=](double s) { return std::exp(-kappa * s) + 0.6 * std::exp(-kappa * (extent - s)); },
            [=](double s) { return kappa * (0.6 * std::exp(-kappa * (extent - s)) - std::exp(-kappa * s)); }};
}

using Scalar = std::function<double(double, double, double)>;

/// A scalar function with its derivatives along the axes.
struct Exact
{
    Scalar value;
    std::array<Scalar, 3> slope;
};

inline Exact product(const std::array<Profile, 3>& f)
{
    return {[=](double x, double y, double z) { return f[0].value(x) * f[1].value(y) * f[2].value(z); },
            {[=](double x, double y, double z) { return f[0].slope(x) * f[1].value(y) * f[2].value(z); },
             [=](double x, double y, double z) { return f[0].value(x) * f[1].slope(y) * f[2].value(z); },
             [=](double x, double y, double z) { return f[0].value(x) * f[1].value(y) * f[2].slope(z); }}};
}

inline Exact sum(const Exact& a, const Exact& b)
{
    const auto add = [](const Scalar& f, const Scalar& g)
    { return [=](double x, double y, double z) { return f(x, y, z) + g(x, y, z); }; };
    return {add(a.value, b.value),
            {add(a.slope[0], b.slope[0]), add(a.slope[1], b.slope[1]), add(a.slope[2], b.slope[2])}};
}

inline const Profile constantProfile{[](double) { return 1.0; }, [](double) { return 0.0; }};

} // namespace isph::test
