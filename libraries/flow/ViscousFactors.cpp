#include "flow/ViscousFactors.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace isph
{

namespace
{

/// (1 + a)(1 + b) - 1.
double productLessOne(double a, double b) { return a + b + a * b; }

/// (1 + x)^n - 1.
double powerLessOne(double x, int n)
{
    double result = 0;
    for (; n > 0; n /= 2)
    {
        if (n % 2 == 1) { result = productLessOne(result, x); }
        x = productLessOne(x, x);
    }
    return result;
}

} // namespace

ViscousFactors::ViscousFactors(std::span<const double> symbol, const TimeScheme& scheme)
    : symbol_(symbol), denominator_(scheme.substeps.front().denominator), dt_(std::numeric_limits<double>::quiet_NaN())
{
    for (const Substep& substep : scheme.substeps)
    {
        const bool known =
            std::ranges::any_of(tables_, [&](const Table& t) { return t.numerator == substep.numerator; });
        if (!known) { tables_.push_back({substep.numerator, AlignedVector<double>(symbol.size())}); }
    }
}

void ViscousFactors::setStep(double dt)
{
    if (dt == dt_) { return; }
    dt_ = dt;
    const double unit = -dt / denominator_;
    const auto size = static_cast<std::ptrdiff_t>(symbol_.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
        const auto mode = static_cast<std::size_t>(i);
        const double base = std::expm1(unit * symbol_[mode]);
        for (Table& table : tables_) { table.values[mode] = powerLessOne(base, table.numerator); }
    }
}

std::span<const double> ViscousFactors::lessOne(const Substep& substep) const
{
    for (const Table& table : tables_)
    {
        if (table.numerator == substep.numerator) { return table.values; }
    }
    assert(false);
    return {};
}

MeanFlowFactors::MeanFlowFactors(const ModeRows& rows, const TimeScheme& scheme) : rows_(rows)
{
    for (const Substep& substep : scheme.substeps)
    {
        Table table{substep.numerator, substep.a, {}};
        for (std::size_t d = 0; d < 3; ++d) { table.values[d].resize(rows_.wavenumbers().derivative[d].size()); }
        tables_.push_back(std::move(table));
    }
}

void MeanFlowFactors::set(const std::array<double, 3>& mean, double dt)
{
    if (mean == mean_ && dt == dt_) { return; }
    mean_ = mean;
    dt_ = dt;
    active_ = mean != std::array<double, 3>{0, 0, 0};
    if (!active_) { return; }
    for (Table& table : tables_)
    {
        for (std::size_t d = 0; d < 3; ++d)
        {
            const auto& k = rows_.wavenumbers().derivative[d];
            for (std::size_t i = 0; i < k.size(); ++i)
            {
                const double angle = k[i] * mean[d] * (table.a * dt);
                table.values[d][i] = {std::cos(angle), -std::sin(angle)};
            }
        }
    }
}

const MeanFlowFactors::Table& MeanFlowFactors::tableOf(const Substep& substep) const
{
    const auto found = std::ranges::find(tables_, substep.numerator, &Table::numerator);
    assert(found != tables_.end());
    return *found;
}

const std::complex<double>* MeanFlowFactors::first(const Substep& substep) const
{
    return tableOf(substep).values[0].data();
}

std::complex<double> MeanFlowFactors::ofRow(const Substep& substep, std::size_t row) const
{
    std::complex<double> factor = 1;
    for (int d = 1; d < rows_.dimensions(); ++d)
    {
        factor *= tableOf(substep).values[static_cast<std::size_t>(d)][rows_.index(row, d)];
    }
    return factor;
}

} // namespace isph
