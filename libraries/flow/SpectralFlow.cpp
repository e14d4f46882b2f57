#include "flow/SpectralFlow.hpp"

#include "fields/reductions.hpp"
#include "flow/convectiveRates.hpp"
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

/// values *= factor along a stretch, without the checks for infinities that complex multiplication makes.
void multiply(Complex* values, const Complex* first, Complex ofRow, std::size_t length)
{
    for (std::size_t i = 0; i < length; ++i)
    {
        const double re = first[i].real() * ofRow.real() - first[i].imag() * ofRow.imag();
        const double im = first[i].real() * ofRow.imag() + first[i].imag() * ofRow.real();
        const Complex value = values[i];
        values[i] = {value.real() * re - value.imag() * im, value.real() * im + value.imag() * re};
    }
}

} // namespace

SpectralFlow::SpectralFlow(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings, Timings& timings,
                           PlanEffort effort)
    : lattice_(lattice), fluid_(fluid), settings_(settings), timings_(timings),
      derivative_(derivativeOf(lattice, settings_.kernel)), retained_(lattice, settings_.dealiasing)
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
        inputs_ = RealField(convection_->inputs(), lattice.points());
        products_ = RealField(convection_->products(), lattice.points());
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
    inputTransform_->backward(inputModes_, inputs_);
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
    addConvectiveRates(lattice_, inputs_, bounds_, fluid_.nu, rates);
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
            convection_->multiply(inputs_, products_);
        }
        const auto scope = timings_.scope(Phase::transforms);
        productTransform_->forward(products_, productModes_);
    }
    updateForce(t + substep.start * dt);

    const auto scope = timings_.scope(Phase::pointwise);
    if (viscousFactors_) { viscousFactors_->setStep(dt); }
    if (meanFlowFactors_) { meanFlowFactors_->set(mean_, dt); }
    if (substep.first && settings_.incremental)
    {
        std::ranges::copy(pressureModes_[0], pressureBefore_[0].begin());
    }

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
    alignas(64) double k[3][stretch];
    alignas(64) Complex rate[3][stretch];
    alignas(64) Complex value[3][stretch];
    derivative_.row(row, begin, end, {d[0], d[1], d[2]});
    const ModeSpan span{first, length, {d[0], d[1], d[2]}};

    // Rate: convection, force, and the viscous term where it is explicit.
    const double scale = 1.0 / static_cast<double>(lattice_.points());
    if (convection_) { convection_->rate(span, productModes_, scale, {rate[0], rate[1], rate[2]}); }
    for (int c = 0; c < dimensions; ++c)
    {
        if (!convection_) { std::fill_n(rate[c], length, Complex(0)); }
        if (fluid_.bodyForce)
        {
            const Complex* force = forceModes_[c].data() + first;
            for (std::size_t i = 0; i < length; ++i) { rate[c][i] += scale * force[i]; }
        }
        if (!viscousSymbol_.empty() && !viscousFactors_)
        {
            const Complex* u = from[c].data() + first;
            const double* lambda = viscousSymbol_.data() + first;
            for (std::size_t i = 0; i < length; ++i) { rate[c][i] -= lambda[i] * u[i]; }
        }
    }

    // Predictor: u* = E (u + dt (g F + z F_before)).
    for (int c = 0; c < dimensions; ++c)
    {
        const Complex* u = from[c].data() + first;
        Complex* carried = rate_[c].data() + first;
        const double now = dt * substep.g;
        const double before = dt * substep.z;
        if (substep.first)
        {
            for (std::size_t i = 0; i < length; ++i) { value[c][i] = u[i] + now * rate[c][i]; }
        }
        else
        {
            for (std::size_t i = 0; i < length; ++i)
            {
                value[c][i] = u[i] + now * rate[c][i] + before * carried[i];
            }
        }
        if (viscousFactors_)
        {
            const double* lessOne = viscousFactors_->lessOne(substep).data() + first;
            for (std::size_t i = 0; i < length; ++i) { value[c][i] += lessOne[i] * value[c][i]; }
            if (!substep.last)
            {
                for (std::size_t i = 0; i < length; ++i) { rate[c][i] += lessOne[i] * rate[c][i]; }
            }
        }
        if (meanFlowFactors_ && meanFlowFactors_->active())
        {
            const Complex ofRow = meanFlowFactors_->ofRow(substep, row);
            multiply(value[c], meanFlowFactors_->first(substep) + begin, ofRow, length);
            if (!substep.last) { multiply(rate[c], meanFlowFactors_->first(substep) + begin, ofRow, length); }
        }
        if (!substep.last) { std::copy_n(rate[c], length, carried); }
    }

    // Projection: u = u* - d (d . u*)/L, along k where that is the same.
    const double period = substep.a * dt;
    if (settings_.incremental)
    {
        const Complex* p = pressureModes_[0].data() + first;
        for (int c = 0; c < dimensions; ++c)
        {
            for (std::size_t i = 0; i < length; ++i)
            {
                const double slope = period * d[c][i];
                value[c][i] += Complex(slope * p[i].imag(), -slope * p[i].real());
            }
        }
    }
    auto& along = projectAlongWavevector_ ? k : d;
    if (projectAlongWavevector_) { derivative_.wavevectorRow(row, begin, end, {k[0], k[1], k[2]}); }
    const double* inverse = inverse_.data() + first;
    for (std::size_t i = 0; i < length; ++i)
    {
        Complex divergence = along[0][i] * value[0][i] + along[1][i] * value[1][i];
        if (dimensions == 3) { divergence += along[2][i] * value[2][i]; }
        divergence *= inverse[i];
        value[0][i] -= along[0][i] * divergence;
        value[1][i] -= along[1][i] * divergence;
        if (dimensions == 3) { value[2][i] -= along[2][i] * divergence; }
        if (settings_.incremental)
        {
            // phi = -i (d . u*)/(L a dt) is what the pressure lacked.
            Complex& p = pressureModes_[0][first + i];
            p += Complex(divergence.imag(), -divergence.real()) / period;
        }
    }

    for (int c = 0; c < dimensions; ++c)
    {
        if (substep.last && !filterFactors_[0].empty())
        {
            const ModeRows& rows = derivative_.rows();
            double ofRow = 1;
            for (int axis = 1; axis < dimensions; ++axis)
            {
                ofRow *= filterFactors_[static_cast<std::size_t>(axis)][rows.index(row, axis)];
            }
            const double* sigma = filterFactors_[0].data() + begin;
            for (std::size_t i = 0; i < length; ++i) { value[c][i] *= ofRow * sigma[i]; }
        }
        std::copy_n(value[c], length, to[c].data() + first);
        if (convection_) { std::copy_n(value[c], length, inputModes_[c].data() + first); }
    }
    if (convection_) { convection_->deriveInputs(span, inputModes_); }
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
        std::ranges::transform(inputs_[c], velocity_[c].begin(), [mean](double u) { return u + mean; });
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
    const RealField& u = convection_ ? (ensureInputs(), inputs_) : velocity();
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
