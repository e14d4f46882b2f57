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
    const bool consistent = settings_.eigenvalues == Eigenvalues::consistent && !settings_.iteration;
    projectAlongWavevector_ = consistent && derivative_.parallel() && !settings_.incremental && !settings_.iteration;

    AlignedVector<double> laplacian;
    if (fluid_.nu > 0) { laplacian = laplacianOf(lattice, settings_.kernel, settings_.laplacian); }
    bounds_ = operatorBounds(derivative_, laplacian, retained_);
    viscousSymbol_ = std::move(laplacian);
    for (double& value : viscousSymbol_) { value *= fluid_.nu; }
    if (fluid_.nu > 0 && settings_.integratingFactor) { viscousFactors_.emplace(viscousSymbol_, *settings_.time); }

    if (settings_.iteration) { makeIteration(effort); }
    else if (projectAlongWavevector_)
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

    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        for (std::size_t i = 0; keptRow(row) && i < retained_.length(); ++i)
        {
            if (rows.checkerboard(row, i)) { checkerboards_.push_back(rows.offset(row) + i); }
        }
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
    if (const auto uniform = fluid_.bodyForce ? fluid_.bodyForce->uniform() : std::nullopt)
    {
        uniformForce_ = *uniform;
    }
    else if (fluid_.bodyForce)
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
    if (iterated_) { iterated_->save(writer); }
}

void SpectralFlow::restore(const FieldReader& reader)
{
    reader.readState("spectralU", state_);
    if (settings_.incremental && reader.hasState("p")) { reader.readState("p", pressureModes_); }
    if (iterated_) { iterated_->restore(reader); }
    stateChanged();
}

bool SpectralFlow::restores(const FieldReader& reader) const { return reader.hasState("spectralU"); }

void SpectralFlow::stepBack()
{
    std::swap(state_, before_);
    std::swap(pressureModes_, pressureBefore_);
    if (iterated_) { iterated_->stepBack(); }
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

void SpectralFlow::clearCheckerboards()
{
    // Products at the points alias onto them, and so may a force.
    for (const std::size_t mode : checkerboards_)
    {
        for (int c = 0; c < state_.components(); ++c) { state_[c][mode] = 0; }
        for (int c = 0; c < inputModes_.components(); ++c) { inputModes_[c][mode] = 0; }
    }
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
        // Nothing is transformed: only see to it that the state is finite, and how large it is.
        for (int c = 0; c < state_.components(); ++c)
        {
            const auto* numbers = reinterpret_cast<const double*>(state_[c].data());
            if (!allFinite({numbers, 2 * state_.size()})) { rates.courant = std::nan(""); }
            rates.magnitude += sumOfSquares({numbers, 2 * state_.size()});
        }
        rates.magnitude = std::sqrt(rates.magnitude);
        return rates;
    }
    ensureInputs();
    const auto scope = timings_.scope(Phase::pointwise);
    addConvectiveRates(lattice_, points_, bounds_, fluid_.nu, rates);
    return rates;
}

void SpectralFlow::updateForce(double t)
{
    if (!forceTransform_ || (forceReady_ && !fluid_.bodyForce->dependsOnTime())) { return; }
    {
        const auto scope = timings_.scope(Phase::pointwise);
        fluid_.bodyForce->evaluate(t, force_);
    }
    const auto scope = timings_.scope(Phase::transforms);
    forceTransform_->forward(force_, forceModes_);
    forceReady_ = true;
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
    if (forceTransform_) { fluid_.bodyForce->evaluate(t, force_); }
    if (convection_) { ensureInputs(); }
    outputPressure_->evaluate(convection_ ? &points_ : nullptr, forceTransform_ ? &force_ : nullptr, pressure_);
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
    for (const auto* transform : {&inputTransform_, &productTransform_, &forceTransform_, &pressureTransform_})
    {
        if (*transform) { count += (*transform)->count(); }
    }
    return count;
}

std::string SpectralFlow::planFingerprint() const
{
    std::string fingerprint;
    for (const auto* transform : {&inputTransform_, &productTransform_, &forceTransform_, &pressureTransform_})
    {
        if (*transform) { fingerprint += ((*transform)->fingerprint() + " "); }
    }
    return fingerprint.substr(0, fingerprint.empty() ? 0 : fingerprint.size() - 1);
}

} // namespace isph
