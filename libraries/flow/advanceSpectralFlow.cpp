#include "flow/modeLoops.hpp"
#include "flow/SpectralFlow.hpp"

#include <algorithm>

namespace isph
{

void SpectralFlow::advance(const Substep& substep, double t, double dt)
{
    if (convection_)
    {
        ensureInputs();
        {
            const auto scope = timings_.scope(Phase::pointwise);
            convection_->multiply(points_);
        }
        const auto scope = timings_.scope(Phase::transforms);
        productTransform_->forward(points_, productModes_);
    }
    updateForce(t + substep.start * dt);

    const auto scope = timings_.scope(Phase::pointwise);
    if (viscousFactors_) { viscousFactors_->setStep(dt); }
    if (meanFlowFactors_) { meanFlowFactors_->set(mean_, dt); }
    if (substep.first && settings_.incremental) { std::ranges::copy(pressureModes_[0], pressureBefore_[0].begin()); }

    // The first substep writes beside the state, so that the step can be taken back.
    if (substep.first) { std::swap(state_, before_); }
    const SpectralField& from = substep.first ? before_ : state_;
    const ModeRows& rows = derivative_.rows();
    const auto count = static_cast<std::ptrdiff_t>(rows.count());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t r = 0; r < count; ++r)
    {
        const auto row = static_cast<std::size_t>(r);
        const std::size_t kept = keptRow(row) ? retained_.length() : 0;
        for (std::size_t begin = 0; begin < kept; begin += stretch)
        {
            advanceStretch(row, begin, std::min(begin + stretch, kept), substep, dt, from, state_);
        }
        if (convection_) { clearRow(row, kept, inputModes_); }
    }
    inputModesReady_ = convection_ != nullptr;
    inputsReady_ = false;
    if (substep.last) { subtractMean(); }
    else if (meanFlowFactors_)
    {
        for (int c = 0; c < lattice_.dimensions(); ++c) { inputModes_[c][0] -= mean_[static_cast<std::size_t>(c)]; }
    }
}

void SpectralFlow::advanceStretch(std::size_t row, std::size_t begin, std::size_t end, const Substep& substep,
                                  double dt, const SpectralField& from, SpectralField& to)
{
    const int dimensions = lattice_.dimensions();
    const std::size_t first = derivative_.rows().offset(row) + begin;
    const std::size_t length = end - begin;
    alignas(64) double d[3][stretch];
    // Pairs of doubles: an array of complex numbers would be set to zero first.
    alignas(64) double rateStore[3][2 * stretch];
    alignas(64) double valueStore[3][2 * stretch];
    const auto complexes = [](double* pairs) { return reinterpret_cast<Complex*>(pairs); };
    const std::array<Complex*, 3> rate{complexes(rateStore[0]), complexes(rateStore[1]), complexes(rateStore[2])};
    const std::array<Complex*, 3> value{complexes(valueStore[0]), complexes(valueStore[1]), complexes(valueStore[2])};
    derivative_.row(row, begin, end, {d[0], d[1], d[2]});
    const ModeSpan span{first, length, {d[0], d[1], d[2]}};

    // Rate: convection, force, and the viscous term where it is explicit.
    const double scale = 1.0 / static_cast<double>(lattice_.points());
    if (convection_) { convection_->rate(span, productModes_, scale, rate); }
    for (std::size_t c = 0; c < static_cast<std::size_t>(dimensions); ++c)
    {
        if (!convection_) { std::fill_n(rate[c], length, Complex(0)); }
        if (fluid_.bodyForce)
        {
            const Complex* force = forceModes_[static_cast<int>(c)].data() + first;
            for (std::size_t i = 0; i < length; ++i) { rate[c][i] += scale * force[i]; }
        }
        if (!viscousSymbol_.empty() && !viscousFactors_)
        {
            const Complex* u = from[static_cast<int>(c)].data() + first;
            const double* lambda = viscousSymbol_.data() + first;
            for (std::size_t i = 0; i < length; ++i) { rate[c][i] -= lambda[i] * u[i]; }
        }
    }

    // Predictor: u* = E (u + dt (g F + z F_before)).
    Prediction prediction{.now = dt * substep.g,
                          .before = dt * substep.z,
                          .lessOne = nullptr,
                          .first = substep.first,
                          .last = substep.last};
    if (viscousFactors_) { prediction.lessOne = viscousFactors_->lessOne(substep).data() + first; }
    const bool meanFlow = meanFlowFactors_ && meanFlowFactors_->active();
    for (std::size_t c = 0; c < static_cast<std::size_t>(dimensions); ++c)
    {
        Complex* carried = rate_[static_cast<int>(c)].data() + first;
        predict(prediction, from[static_cast<int>(c)].data() + first, rate[c], carried, value[c], length);
        if (!meanFlow) { continue; }
        const Complex ofRow = meanFlowFactors_->ofRow(substep, row);
        multiplyByPhase(value[c], meanFlowFactors_->first(substep) + begin, ofRow, length);
        if (!substep.last) { multiplyByPhase(carried, meanFlowFactors_->first(substep) + begin, ofRow, length); }
    }

    // Projection: u = u* - d (d . u*)/L, along k where that is the same.
    const double period = substep.a * dt;
    if (settings_.incremental)
    {
        const Complex* p = pressureModes_[0].data() + first;
        for (std::size_t c = 0; c < static_cast<std::size_t>(dimensions); ++c)
        {
            for (std::size_t i = 0; i < length; ++i)
            {
                const double slope = period * d[c][i];
                value[c][i] += Complex(slope * p[i].imag(), -slope * p[i].real());
            }
        }
    }
    if (projectAlongWavevector_) { derivative_.wavevectorRow(row, begin, end, {d[0], d[1], d[2]}); }
    Complex* multiplier = settings_.incremental ? rate[0] : nullptr; // the rate was used up
    project({d[0], d[1], d[2]}, inverse_.data() + first, dimensions, value, multiplier, length);
    if (settings_.incremental)
    {
        // phi = -i (d . u*)/(L a dt) is what the pressure lacked.
        Complex* p = pressureModes_[0].data() + first;
        for (std::size_t i = 0; i < length; ++i)
        {
            p[i] += Complex(multiplier[i].imag(), -multiplier[i].real()) / period;
        }
    }

    for (std::size_t c = 0; c < static_cast<std::size_t>(dimensions); ++c)
    {
        if (substep.last && !filterFactors_[0].empty())
        {
            const ModeRows& rows = derivative_.rows();
            double ofRow = 1;
            for (int axis = 1; axis < dimensions; ++axis)
            {
                ofRow *= filterFactors_[static_cast<std::size_t>(axis)][rows.index(row, axis)];
            }
            multiplyByFactors(value[c], filterFactors_[0].data() + begin, ofRow, length);
        }
        std::copy_n(value[c], length, to[static_cast<int>(c)].data() + first);
        if (convection_) { std::copy_n(value[c], length, inputModes_[static_cast<int>(c)].data() + first); }
    }
    if (convection_)
    {
        if (projectAlongWavevector_ && convection_->inputs() > dimensions)
        {
            derivative_.row(row, begin, end, {d[0], d[1], d[2]});
        }
        convection_->deriveInputs(span, inputModes_);
    }
}

} // namespace isph
