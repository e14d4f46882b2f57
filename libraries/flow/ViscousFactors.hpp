#pragma once

#include "fields/AlignedAllocator.hpp"
#include "schemes/TimeScheme.hpp"
#include "spectral/ModeRows.hpp"

#include <array>
#include <complex>
#include <span>
#include <vector>

namespace isph
{

/// The integrating factor of the viscous term, exp(-a nu L dt) for every substep a of a scheme.
///
/// Kept as exp(...) - 1: near 1 a stored factor would carry the same rounding into every step, and a thousand steps
/// would add them up. One expm1 a mode; the substeps' factors are integer powers of it.
class ViscousFactors
{
public:
    /// \param symbol nu L by mode, >= 0
    ViscousFactors(std::span<const double> symbol, const TimeScheme& scheme);

    /// Recomputes the tables if dt is another than the last time.
    void setStep(double dt);

    /// exp(...) - 1 of the substep whose a has this numerator.
    std::span<const double> lessOne(const Substep& substep) const;

private:
    std::span<const double> symbol_;
    struct Table
    {
        int numerator;
        AlignedVector<double> values;
    };
    std::vector<Table> tables_;
    int denominator_;
    double dt_;
};

/// Phase factors exp(-i k.U0 a dt) that carry a uniform velocity U0 exactly, one table an axis and substep.
class MeanFlowFactors
{
public:
    MeanFlowFactors(const ModeRows& rows, const TimeScheme& scheme);

    /// Recomputes the tables if U0 or dt is another than the last time.
    void set(const std::array<double, 3>& mean, double dt);

    /// Whether there is a mean flow at all.
    bool active() const { return active_; }

    /// Factors along the first axis, and the one of a row for the others.
    const std::complex<double>* first(const Substep& substep) const;
    std::complex<double> ofRow(const Substep& substep, std::size_t row) const;

private:
    struct Table
    {
        int numerator;
        double a;
        std::array<std::vector<std::complex<double>>, 3> values;
    };
    const Table& tableOf(const Substep& substep) const;

    ModeRows rows_;
    std::vector<Table> tables_;
    std::array<double, 3> mean_{0, 0, 0};
    double dt_ = 0;
    bool active_ = false;
};

} // namespace isph
