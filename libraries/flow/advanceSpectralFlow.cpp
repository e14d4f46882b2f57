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
    const int dimensions = lattice_.dimensions();
    std::optional<PlainSubstep> plain;
    if (isPlain(substep)) { plain = plainSubstep(substep, dt, from, state_); }
    const ModeRows& rows = derivative_.rows();
    const auto count = static_cast<std::ptrdiff_t>(rows.count());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t r = 0; r < count; ++r)
    {
        const auto row = static_cast<std::size_t>(r);
        const std::size_t kept = keptRow(row) ? retained_.length() : 0;
        if (plain && kept > 0)
        {
            advancePlain(*plain, dimensions, rows.offset(row), kept,
                         {rows.derivative(row, 1), dimensions == 3 ? rows.derivative(row, 2) : 0});
        }
        for (std::size_t begin = 0; begin < kept && !plain; begin += stretch)
        {
            advanceStretch(row, begin, std::min(begin + stretch, kept), substep, dt, from, state_);
        }
        if (convection_) { clearRow(row, kept, inputModes_); }
    }
    if (iterated_)
    {
        solveForPressure(substep);
        correctVelocity(substep, substep.a * dt);
    }
    clearCheckerboards();
    inputModesReady_ = convection_ != nullptr;
    inputsReady_ = false;
    if (substep.last) { subtractMean(); }
    else if (meanFlowFactors_)
    {
        for (int c = 0; c < lattice_.dimensions(); ++c) { inputModes_[c][0] -= mean_[static_cast<std::size_t>(c)]; }
    }
}

bool SpectralFlow::isPlain(const Substep& substep) const
{
    const bool explicitViscosity = !viscousSymbol_.empty() && !viscousFactors_;
    const bool filters = substep.last && !filterFactors_[0].empty();
    const bool meanFlow = meanFlowFactors_ && meanFlowFactors_->active();
    return settings_.convection == ConvectionForm::divergence && projectAlongWavevector_ && !fluid_.bodyForce &&
           !explicitViscosity && !filters && !meanFlow;
}

PlainSubstep SpectralFlow::plainSubstep(const Substep& substep, double dt, const SpectralField& from, SpectralField& to)
{
    const std::span<const double> smoothing = derivative_.smoothing();
    PlainSubstep modes{.prediction = {.now = dt * substep.g,
                                      .before = dt * substep.z,
                                      .lessOne = viscousFactors_ ? viscousFactors_->lessOne(substep).data() : nullptr,
                                      .first = substep.first,
                                      .last = substep.last},
                       .scale = 1.0 / static_cast<double>(lattice_.points()),
                       .k0 = derivative_.rows().wavenumbers().derivative[0].data(),
                       .smoothing = smoothing.empty() ? nullptr : smoothing.data(),
                       .inverse = inverse_.data(),
                       .products = {},
                       .from = {},
                       .carried = {},
                       .to = {},
                       .inputs = {}};
    for (int i = 0; i < productModes_.components(); ++i)
    {
        modes.products[static_cast<std::size_t>(i)] = productModes_[i].data();
    }
    for (int c = 0; c < lattice_.dimensions(); ++c)
    {
        const auto component = static_cast<std::size_t>(c);
        modes.from[component] = from[c].data();
        modes.carried[component] = rate_[c].data();
        modes.to[component] = to[c].data();
        modes.inputs[component] = inputModes_[c].data();
    }
    return modes;
}

void SpectralFlow::advanceStretch(std::size_t row, std::size_t begin, std::size_t end, const Substep& substep,
                                  double dt, const SpectralField& from, SpectralField& to)
{
    alignas(64) double d[3][stretch];
    // Pairs of doubles: an array of complex numbers would be set to zero first.
    alignas(64) double rate[3][2 * stretch];
    alignas(64) double value[3][2 * stretch];
    Stretch modes{.row = row, .begin = begin, .first = derivative_.rows().offset(row) + begin, .length = end - begin};
    for (std::size_t c = 0; c < 3; ++c)
    {
        modes.d[c] = d[c];
        modes.rate[c] = reinterpret_cast<Complex*>(rate[c]);
        modes.value[c] = reinterpret_cast<Complex*>(value[c]);
    }
    // The next substep's transform wants the velocity as well: it is made where that one looks for it.
    const int dimensions = lattice_.dimensions();
    for (int c = 0; convection_ && c < dimensions; ++c)
    {
        modes.value[static_cast<std::size_t>(c)] = inputModes_[c].data() + modes.first;
    }

    derivative_.row(row, begin, end, modes.d);
    evaluateRate(modes, from);
    predictVelocity(modes, substep, dt, from);
    if (iterated_)
    {
        if (settings_.incremental) { subtractSlope(modes, substep.a * dt, pressureModes_); }
        gatherSource(modes, substep.a * dt);
        for (int c = 0; c < dimensions; ++c)
        {
            std::copy_n(modes.value[static_cast<std::size_t>(c)], modes.length, to[c].data() + modes.first);
        }
        return;
    }
    projectVelocity(modes, substep.a * dt);
    if (substep.last && !filterFactors_[0].empty()) { filterVelocity(modes); }
    for (int c = 0; c < dimensions; ++c)
    {
        std::copy_n(modes.value[static_cast<std::size_t>(c)], modes.length, to[c].data() + modes.first);
    }
    if (!convection_ || convection_->inputs() == dimensions) { return; }
    derivative_.row(row, begin, end, modes.d);
    convection_->deriveInputs({modes.first, modes.length, {modes.d[0], modes.d[1], modes.d[2]}}, inputModes_);
}

void SpectralFlow::evaluateRate(const Stretch& modes, const SpectralField& from) const
{
    const double scale = 1.0 / static_cast<double>(lattice_.points());
    if (convection_)
    {
        convection_->rate({modes.first, modes.length, {modes.d[0], modes.d[1], modes.d[2]}}, productModes_, scale,
                          modes.rate);
    }
    for (int c = 0; c < lattice_.dimensions(); ++c)
    {
        Complex* rate = modes.rate[static_cast<std::size_t>(c)];
        if (!convection_) { std::fill_n(rate, modes.length, Complex(0)); }
        if (modes.first == 0) { rate[0] += uniformForce_[static_cast<std::size_t>(c)]; }
        if (forceTransform_)
        {
            const Complex* force = forceModes_[c].data() + modes.first;
            for (std::size_t i = 0; i < modes.length; ++i) { rate[i] += scale * force[i]; }
        }
        if (!viscousSymbol_.empty() && !viscousFactors_)
        {
            const Complex* u = from[c].data() + modes.first;
            const double* lambda = viscousSymbol_.data() + modes.first;
            for (std::size_t i = 0; i < modes.length; ++i) { rate[i] -= lambda[i] * u[i]; }
        }
    }
}

void SpectralFlow::predictVelocity(const Stretch& modes, const Substep& substep, double dt, const SpectralField& from)
{
    Prediction prediction{.now = dt * substep.g,
                          .before = dt * substep.z,
                          .lessOne = nullptr,
                          .first = substep.first,
                          .last = substep.last};
    if (viscousFactors_) { prediction.lessOne = viscousFactors_->lessOne(substep).data() + modes.first; }
    const bool meanFlow = meanFlowFactors_ && meanFlowFactors_->active();
    for (int c = 0; c < lattice_.dimensions(); ++c)
    {
        const auto component = static_cast<std::size_t>(c);
        Complex* carried = rate_[c].data() + modes.first;
        predict(prediction, from[c].data() + modes.first, modes.rate[component], carried, modes.value[component],
                modes.length);
        if (!meanFlow) { continue; }
        const Complex ofRow = meanFlowFactors_->ofRow(substep, modes.row);
        const Complex* phase = meanFlowFactors_->first(substep) + modes.begin;
        multiplyByPhase(modes.value[component], phase, ofRow, modes.length);
        if (!substep.last) { multiplyByPhase(carried, phase, ofRow, modes.length); }
    }
}

void SpectralFlow::projectVelocity(const Stretch& modes, double period)
{
    if (projectAlongWavevector_)
    {
        derivative_.wavevectorRow(modes.row, modes.begin, modes.begin + modes.length, modes.d);
    }
    const std::array<const double*, 3> d{modes.d[0], modes.d[1], modes.d[2]};
    const double* inverse = inverse_.data() + modes.first;
    if (!settings_.incremental)
    {
        project(d, inverse, lattice_.dimensions(), modes.value, nullptr, modes.length);
        return;
    }

    // The predictor knows the old pressure; phi = -i (d . u*)/(L period) is what that one lacked.
    subtractSlope(modes, period, pressureModes_);
    Complex* p = pressureModes_[0].data() + modes.first;
    Complex* multiplier = modes.rate[0]; // the rate was used up
    project(d, inverse, lattice_.dimensions(), modes.value, multiplier, modes.length);
    for (std::size_t i = 0; i < modes.length; ++i)
    {
        p[i] += Complex(multiplier[i].imag(), -multiplier[i].real()) / period;
    }
}

void SpectralFlow::subtractSlope(const Stretch& modes, double period, const SpectralField& p) const
{
    const Complex* pressure = p[0].data() + modes.first;
    for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimensions()); ++c)
    {
        for (std::size_t i = 0; i < modes.length; ++i)
        {
            const double slope = period * modes.d[c][i];
            modes.value[c][i] += Complex(slope * pressure[i].imag(), -slope * pressure[i].real());
        }
    }
}

void SpectralFlow::filterVelocity(const Stretch& modes) const
{
    const ModeRows& rows = derivative_.rows();
    double ofRow = 1;
    for (int axis = 1; axis < lattice_.dimensions(); ++axis)
    {
        ofRow *= filterFactors_[static_cast<std::size_t>(axis)][rows.index(modes.row, axis)];
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimensions()); ++c)
    {
        multiplyByFactors(modes.value[c], filterFactors_[0].data() + modes.begin, ofRow, modes.length);
    }
}

} // namespace isph
