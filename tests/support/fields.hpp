#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <cmath>
#include <functional>
#include <random>

namespace isph::test
{

/// A field from a function of x, y, z and the component (along active axes).
inline RealField fieldOf(const Lattice& lattice, int components,
                         const std::function<double(int, double, double, double)>& function)
{
    RealField field(components, lattice.points());
    const auto [x, y, z] = lattice.coordinates();
    for (int c = 0; c < components; ++c)
    {
        for (std::size_t i = 0; i < lattice.points(); ++i) { field[c][i] = function(c, x[i], y[i], z[i]); }
    }
    return field;
}

/// Uniform noise in [-1, 1], the same for the same seed.
inline RealField noise(const Lattice& lattice, int components, unsigned seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    return fieldOf(lattice, components, [&](int, double, double, double) { return uniform(engine); });
}

/// ||a - b|| / ||b|| over all components.
inline double relativeL2(const RealField& a, const RealField& b)
{
    double difference = 0;
    double norm = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            difference += (a[c][i] - b[c][i]) * (a[c][i] - b[c][i]);
            norm += b[c][i] * b[c][i];
        }
    }
    return std::sqrt(difference / norm);
}

inline double norm(const RealField& a)
{
    double total = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (const double value : a[c]) { total += value * value; }
    }
    return std::sqrt(total);
}

} // namespace isph::test
