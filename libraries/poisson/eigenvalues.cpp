#include "poisson/eigenvalues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace isph
{

namespace
{

/// Minus the symbol of the central second difference over 3 or 5 points.
double centralDifference(double k, double dx, bool fourthOrder)
{
    const double cosine = std::cos(k * dx);
    const double sine2 = std::pow(std::sin(0.5 * k * dx), 2);
    // 5/2 - 8/3 cos + 1/6 cos 2, written so that small k loses no digits.
    return fourthOrder ? sine2 * (14 - 2 * cosine) / (3 * dx * dx) : 4 * sine2 / (dx * dx);
}

} // namespace

const Selection<Eigenvalues>& eigenvalueForms()
{
    static constexpr std::array<Selection<Eigenvalues>::Variant, 5> table{{
        {"consistent", "divergence of the discrete gradient: divergence-free to round-off", Eigenvalues::consistent},
        {"exact", "-k^2, whatever the operators (as the 2021 paper)", Eigenvalues::exact},
        {"morris", "the Morris Laplacian, as iterative ISPH inverts it", Eigenvalues::morris},
        {"secondOrder", "second-order central differences", Eigenvalues::secondOrder},
        {"fourthOrder", "fourth-order central differences", Eigenvalues::fourthOrder},
    }};
    static_assert(distinct(table));
    static constexpr Selection<Eigenvalues> selection("kind of eigenvalues", table);
    return selection;
}

AlignedVector<double> poissonEigenvalues(const Lattice& lattice, Eigenvalues form, const DerivativeSymbol& derivative,
                                         std::span<const double> morris)
{
    const ModeRows& rows = derivative.rows();
    if (form == Eigenvalues::morris)
    {
        if (morris.size() != rows.modes()) { throw std::logic_error("poissonEigenvalues: no Morris symbol"); }
        return {morris.begin(), morris.end()};
    }
    AlignedVector<double> values(rows.modes());
    std::array<std::vector<double>, 3> d;
    for (auto& row : d) { row.assign(rows.length(), 0.0); }
    const auto& k0 = rows.wavenumbers().k[0];
    const double dx0 = lattice.activeAxis(0).spacing();
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        if (form == Eigenvalues::consistent)
        {
            derivative.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
        }
        const bool fourth = form == Eigenvalues::fourthOrder;
        double differencesOfRow = 0;
        for (int axis = 1; axis < rows.dimensions(); ++axis)
        {
            differencesOfRow += centralDifference(rows.k(row, axis), lattice.activeAxis(axis).spacing(), fourth);
        }
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            double& value = values[rows.offset(row) + i];
            switch (form)
            {
            case Eigenvalues::consistent:
                value = d[0][i] * d[0][i] + d[1][i] * d[1][i] + d[2][i] * d[2][i];
                break;
            case Eigenvalues::exact:
                value = k0[i] * k0[i] + rows.k2OfRow(row);
                break;
            default:
                value = centralDifference(k0[i], dx0, fourth) + differencesOfRow;
            }
        }
    }
    return values;
}

AlignedVector<double> invertedEigenvalues(const ModeRows& rows, AlignedVector<double> eigenvalues)
{
    const auto& k0 = rows.wavenumbers().k[0];
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        const double k2OfRow = rows.k2OfRow(row);
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            double& value = eigenvalues[rows.offset(row) + i];
            value = value > 1e-24 * (k0[i] * k0[i] + k2OfRow) ? 1 / value : 0;
        }
    }
    return eigenvalues;
}

} // namespace isph
