#include "flow/SpectralFlow.hpp"

#include "fields/reductions.hpp"
#include "flow/convectiveRates.hpp"
#include "flow/modeLoops.hpp"
#include "flow/sceneSymbols.hpp"
#include "flow/startVelocity.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace isph
{

namespace
{

using Complex = std::complex<double>;

} // namespace

SpectralFlow::SpectralFlow(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings, Timings& timings,
                           PlanEffort effort)
    : lattice_(lattice),
      fluid_(fluid),
      settings_(settings),
      timings_(timings),
      derivative_(derivativeOf(lattice, settings_.kernel)),
      retained_(lattice, settings_.dealiasing)
{
    const int dimensions = lattice.dimensions();
    const ModeRows& rows = derivative_.rows();
    const bool consistent = settings_.eigenvalues == Eigenvalues::consistent;
    projectAlongWavevector_ = consistent && derivative_.parallel() && !settings_.incremental;

    AlignedVector<double> laplacian;
    if (fluid_.nu > 0) { laplacian = laplacianOf(lattice, settings_.kernel, settings_.laplacian); }
    bounds_ = operatorBounds(derivative_, laplacian, retained_);
    viscousSymbol_ = std::move(laplacian);
    for (double& value : viscousSymbol_) { value *= fluid_.nu; }
    if (fluid_.nu > 0 && settings_.integratingFactor) { viscousFactors_.emplace(viscousSymbol_, *settings_.time); }

    if (projectAlongWavevector_)
    {
        AlignedVector<double> k2(rows.modes());
        const auto& k0 = rows.wavenumbers().derivative[0];
        for (std::size_t row = 0; row < rows.count(); ++row)
        {
            double ofRow = 0;
            for (int d = 1; d < dimensions; ++d) { ofRow += rows.derivative(row, d) * rows.derivative(row, d); }
            for (std::size_t i = 0; i < rows.length(); ++i) { k2[rows.offset(row) + i] = k0[i] * k0[i] + ofRow; }
        }
        inverse_ = invertedEigenvalues(rows, std::move(k2));
    }
    else
    {
        AlignedVector<double> morris;
        if (settings_.eigenvalues == Eigenvalues::morris)
        {
            morris = laplacianOf(lattice, settings_.kernel, LaplacianForm::morris);
        }
        inverse_ = invertedEigenvalues(rows, poissonEigenvalues(lattice, settings_.eigenvalues, derivative_, morris));
    }

    convection_ = makeConvection(settings_.convection, dimensions, consistent);
    if (convection_)
    {
        inputTransform_.emplace(lattice, convection_->inputs(), effort);
        productTransform_.emplace(lattice, convection_->products(), effort);
        inputModes_ = SpectralField(convection_->inputs(), rows.modes());
        productModes_ = SpectralField(convection_->products(), rows.modes());
        points_ = RealField(std::max(convection_->inputs(), convection_->products()), lattice.points());
        if (settings_.exactMeanFlow) { meanFlowFactors_.emplace(rows, *settings_.time); }
    }
    if (fluid_.bodyForce)
    {
        forceTransform_.emplace(lattice, dimensions, effort);
        force_ = RealField(dimensions, lattice.points());
        forceModes_ = SpectralField(dimensions, rows.modes());
    }
    if (settings_.filter.type != FilterSettings::Type::none)
    {
        filterFactors_ = filterFactors(lattice, settings_.filter);
    }
    state_ = SpectralField(dimensions, rows.modes());
    before_ = SpectralField(dimensions, rows.modes());
    rate_ = SpectralField(dimensions, rows.modes());
    if (settings_.incremental)
    {
        pressureModes_ = SpectralField(1, rows.modes());
        pressureBefore_ = SpectralField(1, rows.modes());
    }
}

StartReport SpectralFlow::start(const RealField& velocity, bool project)
{
    const StartReport report = startVelocity(lattice_, derivative_, retained_, velocity, project, state_);
    stateChanged();
    return report;
}

void SpectralFlow::save(FieldWriter& writer) const
{
    writer.writeState("spectralU", state_);
    if (settings_.incremental) { writer.writeState("p", pressureModes_); }
}

void SpectralFlow::restore(const FieldReader& reader)
{
    reader.readState("spectralU", state_);
    if (settings_.incremental && reader.hasState("p")) { reader.readState("p", pressureModes_); }
    stateChanged();
}

bool SpectralFlow::restores(const FieldReader& reader) const { return reader.hasState("spectralU"); }

void SpectralFlow::stepBack()
{
    std::swap(state_, before_);
    std::swap(pressureModes_, pressureBefore_);
    stateChanged();
}

void SpectralFlow::stateChanged()
{
    inputModesReady_ = false;
    inputsReady_ = false;
    subtractMean();
}

void SpectralFlow::subtractMean()
{
    mean_ = {0, 0, 0};
    if (!meanFlowFactors_) { return; }
    for (int c = 0; c < lattice_.dimensions(); ++c) { mean_[static_cast<std::size_t>(c)] = state_[c][0].real(); }
    // Between steps the whole mean is carried; within a step a force may add to it.
    for (int c = 0; c < lattice_.dimensions() && inputModesReady_; ++c) { inputModes_[c][0] = 0; }
}

bool SpectralFlow::keptRow(std::size_t row) const
{
    const ModeRows& rows = derivative_.rows();
    return retained_.index(1, rows.index(row, 1)) && retained_.index(2, rows.index(row, 2));
}

void SpectralFlow::clearRow(std::size_t row, std::size_t from, SpectralField& target)
{
    const std::size_t first = derivative_.rows().offset(row) + from;
    const std::size_t length = derivative_.rows().length() - from;
    for (int c = 0; c < target.components(); ++c) { std::fill_n(target[c].data() + first, length, Complex(0)); }
}

void SpectralFlow::gatherInputs()
{
    const ModeRows& rows = derivative_.rows();
    alignas(64) double d[3][stretch];
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        if (!keptRow(row))
        {
            clearRow(row, 0, inputModes_);
            continue;
        }
        for (std::size_t begin = 0; begin < retained_.length(); begin += stretch)
        {
            const std::size_t end = std::min(begin + stretch, retained_.length());
            const std::size_t first = rows.offset(row) + begin;
            for (int c = 0; c < lattice_.dimensions(); ++c)
            {
                std::copy_n(state_[c].data() + first, end - begin, inputModes_[c].data() + first);
            }
            derivative_.row(row, begin, end, {d[0], d[1], d[2]});
            convection_->deriveInputs({first, end - begin, {d[0], d[1], d[2]}}, inputModes_);
        }
        clearRow(row, retained_.length(), inputModes_);
    }
    inputModesReady_ = true;
    subtractMean();
}

void SpectralFlow::ensureInputs()
{
    if (inputsReady_) { return; }
    if (!inputModesReady_)
    {
        const auto scope = timings_.scope(Phase::pointwise);
        gatherInputs();
    }
    const auto scope = timings_.scope(Phase::transforms);
    inputTransform_->backward(inputModes_, points_);
    inputModesReady_ = false; // the transform uses its input as scratch
    inputsReady_ = true;
}

StepRates SpectralFlow::rates()
{
    StepRates rates;
    if (fluid_.nu > 0 && !settings_.integratingFactor) { rates.viscous = fluid_.nu * bounds_.laplacian; }
    if (!convection_)
    {
        // Nothing is transformed: only see to it that the state is finite.
        for (int c = 0; c < state_.components(); ++c)
        {
            const auto* numbers = reinterpret_cast<const double*>(state_[c].data());
            if (!allFinite({numbers, 2 * state_.size()})) { rates.courant = std::nan(""); }
        }
        return rates;
    }
    ensureInputs();
    const auto scope = timings_.scope(Phase::pointwise);
    addConvectiveRates(lattice_, points_, bounds_, fluid_.nu, rates);
    return rates;
}

void SpectralFlow::updateForce(double t)
{
    if (!fluid_.bodyForce || (forceReady_ && !fluid_.bodyForce->dependsOnTime())) { return; }
    {
        const auto scope = timings_.scope(Phase::pointwise);
        fluid_.bodyForce->evaluate(t, force_);
    }
    const auto scope = timings_.scope(Phase::transforms);
    forceTransform_->forward(force_, forceModes_);
    forceReady_ = true;
}

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

const RealField& SpectralFlow::velocity()
{
    const int dimensions = lattice_.dimensions();
    if (velocity_.components() == 0) { velocity_ = RealField(dimensions, lattice_.points()); }
    if (!convection_)
    {
        if (!velocityTransform_) { velocityTransform_.emplace(lattice_, dimensions); }
        SpectralField copy = copyOf(state_);
        velocityTransform_->backward(copy, velocity_);
        return velocity_;
    }
    ensureInputs();
    for (int c = 0; c < dimensions; ++c)
    {
        const double mean = mean_[static_cast<std::size_t>(c)];
        std::ranges::transform(points_[c], velocity_[c].begin(), [mean](double u) { return u + mean; });
    }
    return velocity_;
}

const RealField& SpectralFlow::pressure(double t)
{
    if (!outputPressure_)
    {
        outputPressure_.emplace(lattice_);
        pressure_ = RealField(1, lattice_.points());
    }
    if (fluid_.bodyForce) { fluid_.bodyForce->evaluate(t, force_); }
    const RealField& u = convection_ ? (ensureInputs(), points_) : velocity();
    if (!convection_)
    {
        // No convection: the pressure balances the force alone.
        RealField still(lattice_.dimensions(), lattice_.points());
        outputPressure_->evaluate(still, fluid_.bodyForce ? &force_ : nullptr, pressure_);
        return pressure_;
    }
    outputPressure_->evaluate(u, fluid_.bodyForce ? &force_ : nullptr, pressure_);
    return pressure_;
}

const RealField& SpectralFlow::divergence()
{
    if (!scalarTransform_)
    {
        scalarTransform_.emplace(lattice_, 1);
        divergence_ = RealField(1, lattice_.points());
    }
    const ModeRows& rows = derivative_.rows();
    SpectralField modes(1, rows.modes());
    std::array<std::vector<double>, 3> d;
    for (auto& row : d) { row.assign(rows.length(), 0.0); }
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        derivative_.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            Complex sum = 0;
            for (int c = 0; c < lattice_.dimensions(); ++c)
            {
                sum += d[static_cast<std::size_t>(c)][i] * state_[c][rows.offset(row) + i];
            }
            modes[0][rows.offset(row) + i] = {-sum.imag(), sum.real()};
        }
    }
    scalarTransform_->backward(modes, divergence_);
    return divergence_;
}

long SpectralFlow::transforms() const
{
    long count = 0;
    for (const auto* transform : {&inputTransform_, &productTransform_, &forceTransform_})
    {
        if (*transform) { count += (*transform)->count(); }
    }
    return count;
}

std::string SpectralFlow::planFingerprint() const
{
    std::string fingerprint;
    for (const auto* transform : {&inputTransform_, &productTransform_, &forceTransform_})
    {
        if (*transform) { fingerprint += ((*transform)->fingerprint() + " "); }
    }
    return fingerprint.substr(0, fingerprint.empty() ? 0 : fingerprint.size() - 1);
}

} // namespace isph
