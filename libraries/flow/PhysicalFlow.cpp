#include "flow/PhysicalFlow.hpp"

#include "core/Error.hpp"
#include "fields/fieldOperations.hpp"
#include "flow/convectiveRates.hpp"
#include "flow/startVelocity.hpp"
#include "operators/DirectSumOperators.hpp"

#include <algorithm>
#include <utility>

namespace isph
{

namespace
{

void requireSampled(const FlowSettings& settings)
{
    const auto refuse = [](const std::string& what, const std::string& advice)
    { throw Error(Fault::input, "operators directSum: " + what, advice); };
    if (settings.kernel.symbol != KernelSettings::Symbol::sampled)
    {
        refuse("a sum over neighbours needs a sampled kernel",
               "write symbol sampled; in kernel, or operators spectral;");
    }
    if (settings.laplacian == LaplacianForm::exact)
    {
        refuse("the exact Laplacian has no neighbours", "choose laplacian morris; or secondDerivative;");
    }
    if (settings.integratingFactor) { refuse("the viscous term is explicit", "write viscous explicit;"); }
    if (settings.exactMeanFlow) { refuse("the mean flow is not carried exactly", "write meanFlow none;"); }
    if (settings.dealiasing != Dealiasing::none || settings.filter.type != FilterSettings::Type::none)
    {
        refuse("dealiasing and filter act on modes", "write dealiasing none; filter { type none; }");
    }
}

} // namespace

PhysicalFlow::PhysicalFlow(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings, Timings& timings)
    : lattice_(lattice),
      fluid_(fluid),
      settings_((requireSampled(settings), settings)),
      timings_(timings),
      derivative_(
          [&]
          {
              const KernelSamples samples(lattice, settings_.kernel, LaplacianForm::exact);
              return DerivativeSymbol(lattice, settings_.kernel, &samples);
          }())
{
    const int dimensions = lattice.dimensions();
    const std::size_t points = lattice.points();
    const bool viscous = fluid_.nu > 0;
    KernelSamples samples(lattice, settings_.kernel, viscous ? settings_.laplacian : LaplacianForm::exact);
    AlignedVector<double> laplacian;
    if (viscous) { laplacian = laplacianSymbol(lattice, settings_.kernel, settings_.laplacian, &samples); }
    bounds_ = operatorBounds(derivative_, laplacian, RetainedModes(lattice, Dealiasing::none));

    if (settings_.iteration)
    {
        iterated_.emplace(lattice, settings_.kernel, wallEnds(lattice), *settings_.iteration, *settings_.time);
    }
    else { makePoisson(); }
    operators_ = std::make_unique<DirectSumOperators>(lattice, std::move(samples));

    velocity_ = RealField(dimensions, points);
    before_ = RealField(dimensions, points);
    rate_ = RealField(dimensions, points);
    previousRate_ = RealField(dimensions, points);
    gradient_ = RealField(dimensions, points);
    products_ = RealField(1, points);
    if (viscous) { laplacian_ = RealField(dimensions, points); }
    if (fluid_.bodyForce) { force_ = RealField(dimensions, points); }
    source_ = RealField(1, points);
    phi_ = RealField(1, points);
    if (settings_.incremental)
    {
        incrementalPressure_ = RealField(1, points);
        pressureBefore_ = RealField(1, points);
    }
}

void PhysicalFlow::makePoisson()
{
    AlignedVector<double> morris;
    if (settings_.eigenvalues == Eigenvalues::morris)
    {
        const KernelSamples samples(lattice_, settings_.kernel, LaplacianForm::morris);
        morris = laplacianSymbol(lattice_, settings_.kernel, LaplacianForm::morris, &samples);
    }
    auto eigenvalues = poissonEigenvalues(lattice_, settings_.eigenvalues, derivative_, morris);
    poisson_.emplace(lattice_, invertedEigenvalues(derivative_.rows(), std::move(eigenvalues)));
}

StartReport PhysicalFlow::start(const RealField& velocity, bool project)
{
    SpectralField modes(lattice_.dimensions(), derivative_.rows().modes());
    const StartReport report =
        startVelocity(lattice_, derivative_, RetainedModes(lattice_, Dealiasing::none), velocity, project, modes);
    FourierTransform(lattice_, lattice_.dimensions()).backward(modes, velocity_);
    return report;
}

void PhysicalFlow::save(FieldWriter& writer) const
{
    writer.writeState("physicalU", velocity_);
    if (settings_.incremental) { writer.writeState("p", incrementalPressure_); }
    if (iterated_) { iterated_->save(writer); }
}

void PhysicalFlow::restore(const FieldReader& reader)
{
    reader.readState("physicalU", velocity_);
    if (settings_.incremental && reader.hasState("p")) { reader.readState("p", incrementalPressure_); }
    if (iterated_) { iterated_->restore(reader); }
}

bool PhysicalFlow::restores(const FieldReader& reader) const { return reader.hasState("physicalU"); }

void PhysicalFlow::stepBack()
{
    std::swap(velocity_, before_);
    std::swap(incrementalPressure_, pressureBefore_);
    if (iterated_) { iterated_->stepBack(); }
}

StepRates PhysicalFlow::rates()
{
    const auto scope = timings_.scope(Phase::pointwise);
    StepRates rates;
    if (fluid_.nu > 0) { rates.viscous = fluid_.nu * bounds_.laplacian; }
    addConvectiveRates(lattice_, velocity_, bounds_, fluid_.nu, rates);
    if (settings_.convection == ConvectionForm::none) { rates.convective = rates.unbalancedConvection = 0; }
    return rates;
}

void PhysicalFlow::addConvection()
{
    const int dimensions = lattice_.dimensions();
    const auto product = products_[0];
    // The divergence form and the advective one; skew-symmetric is their mean, rotational the advective one less
    // u_j D_c u_j.
    const double divergenceShare = settings_.convection == ConvectionForm::divergence      ? 1
                                   : settings_.convection == ConvectionForm::skewSymmetric ? 0.5
                                                                                           : 0;
    for (int c = 0; c < dimensions; ++c)
    {
        if (divergenceShare > 0)
        {
            for (int j = 0; j < dimensions; ++j)
            {
                std::ranges::transform(velocity_[c], velocity_[j], product.begin(), std::multiplies{});
                if (j == c)
                {
                    // The trace that the form leaves to the projection, which takes all of it only where it is exact.
                    const auto last = velocity_[dimensions - 1];
                    std::ranges::transform(product, last, product.begin(),
                                           [](double square, double w) { return square - w * w; });
                }
                operators_->gradient(products_, 0, gradient_);
                std::ranges::transform(rate_[c], gradient_[j], rate_[c].begin(),
                                       [divergenceShare](double rate, double slope)
                                       { return rate - divergenceShare * slope; });
            }
        }
        if (divergenceShare < 1)
        {
            operators_->gradient(velocity_, c, gradient_);
            for (int j = 0; j < dimensions; ++j)
            {
                const auto carrier = velocity_[j];
                const auto slope = gradient_[j];
                const auto rate = rate_[c];
                for (std::size_t i = 0; i < rate.size(); ++i)
                {
                    rate[i] -= (1 - divergenceShare) * carrier[i] * slope[i];
                }
                if (settings_.convection != ConvectionForm::rotational) { continue; }
                const auto along = rate_[j];
                const auto u = velocity_[c];
                for (std::size_t i = 0; i < along.size(); ++i) { along[i] += u[i] * slope[i]; }
            }
        }
    }
}

void PhysicalFlow::evaluateRate(double t)
{
    for (int c = 0; c < rate_.components(); ++c) { std::ranges::fill(rate_[c], 0.0); }
    if (settings_.convection != ConvectionForm::none) { addConvection(); }
    if (fluid_.nu > 0)
    {
        operators_->laplacian(velocity_, laplacian_);
        addScaled(fluid_.nu, laplacian_, rate_);
    }
    if (fluid_.bodyForce)
    {
        fluid_.bodyForce->evaluate(t, force_);
        addScaled(1, force_, rate_);
    }
}

void PhysicalFlow::clearCheckerboards()
{
    std::array<std::size_t, 3> n{1, 1, 1};
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        n[static_cast<std::size_t>(d)] = static_cast<std::size_t>(lattice_.activeAxis(d).count);
    }
    // One bit an axis: alternating along it or not.
    for (std::size_t pattern = 1; pattern < 8; ++pattern)
    {
        bool possible = true;
        for (std::size_t d = 0; d < 3; ++d) { possible = possible && ((pattern >> d & 1) == 0 || n[d] % 2 == 0); }
        for (int c = 0; possible && c < velocity_.components(); ++c)
        {
            const auto forEach = [&](auto visit)
            {
                std::size_t point = 0;
                for (std::size_t k = 0; k < n[2]; ++k)
                {
                    for (std::size_t j = 0; j < n[1]; ++j)
                    {
                        for (std::size_t i = 0; i < n[0]; ++i, ++point)
                        {
                            const std::size_t odd =
                                (i * (pattern & 1) + j * (pattern >> 1 & 1) + k * (pattern >> 2 & 1)) % 2;
                            visit(velocity_[c][point], odd == 1 ? -1.0 : 1.0);
                        }
                    }
                }
            };
            double amplitude = 0;
            forEach([&](double& u, double sign) { amplitude += sign * u; });
            amplitude /= static_cast<double>(lattice_.points());
            forEach([&](double& u, double sign) { u -= sign * amplitude; });
        }
    }
}

void PhysicalFlow::advance(const Substep& substep, double t, double dt)
{
    const double period = substep.a * dt;
    {
        const auto scope = timings_.scope(Phase::pointwise);
        if (substep.first)
        {
            copyInto(velocity_, before_);
            if (settings_.incremental) { copyInto(incrementalPressure_, pressureBefore_); }
        }
        evaluateRate(t + substep.start * dt);
        addScaled(dt * substep.g, rate_, velocity_);
        if (!substep.first) { addScaled(dt * substep.z, previousRate_, velocity_); }
        std::swap(rate_, previousRate_);
        if (settings_.incremental)
        {
            operators_->gradient(incrementalPressure_, 0, gradient_);
            addScaled(-period, gradient_, velocity_);
        }
        operators_->divergence(velocity_, source_);
        for (double& value : source_[0]) { value /= period; }
    }
    {
        const auto scope = timings_.scope(Phase::poisson);
        if (iterated_)
        {
            iterated_->begin(substep);
            iterated_->solve(source_, {}, phi_);
        }
        else
        {
            poisson_->solve(source_, phi_);
            transforms_ += 2;
        }
    }
    const auto scope = timings_.scope(Phase::pointwise);
    operators_->gradient(phi_, 0, gradient_);
    addScaled(-period, gradient_, velocity_);
    clearCheckerboards();
    if (settings_.incremental) { addScaled(1, phi_, incrementalPressure_); }
}

const RealField& PhysicalFlow::pressure(double t)
{
    if (!outputPressure_)
    {
        outputPressure_.emplace(lattice_);
        pressure_ = RealField(1, lattice_.points());
    }
    if (fluid_.bodyForce) { fluid_.bodyForce->evaluate(t, force_); }
    const bool convects = settings_.convection != ConvectionForm::none;
    outputPressure_->evaluate(convects ? &velocity_ : nullptr, fluid_.bodyForce ? &force_ : nullptr, pressure_);
    return pressure_;
}

const RealField& PhysicalFlow::divergence()
{
    operators_->divergence(velocity_, source_);
    return source_;
}

} // namespace isph
