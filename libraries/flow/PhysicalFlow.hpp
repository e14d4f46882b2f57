#pragma once

#include "core/Timings.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "flow/IteratedPressure.hpp"
#include "flow/OutputPressure.hpp"
#include "operators/Operators.hpp"
#include "poisson/FourierPoisson.hpp"

#include <optional>

namespace isph
{

/// ISPH whose velocity lives at the points and whose operators act there: the classical scheme of neighbour summation,
/// with the pressure solved by transforms or, all classically, by iterations. The viscous term is explicit and nothing
/// is dealiased or filtered.
class PhysicalFlow : public IncompressibleFlow
{
public:
    /// fluid and settings must outlive the flow.
    /// \throws Error(input) without origin for settings that only a flow in Fourier space can honour.
    PhysicalFlow(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings, Timings& timings);

    StartReport start(const RealField& velocity, bool project) override;
    void save(FieldWriter& writer) const override;
    void restore(const FieldReader& reader) override;
    bool restores(const FieldReader& reader) const override;
    void stepBack() override;
    StepRates rates() override;
    void advance(const Substep& substep, double t, double dt) override;
    const RealField& velocity() override { return velocity_; }
    const RealField& pressure(double t) override;
    const RealField& divergence() override;
    long transforms() const override { return transforms_; }
    std::string planFingerprint() const override { return "estimated"; }
    const PressureRecord* pressureRecord() const override { return iterated_ ? &iterated_->record() : nullptr; }

    const OperatorBounds& bounds() const { return bounds_; }

private:
    /// rate = -(u . D)u + nu lap u + f.
    void evaluateRate(double t);
    void addConvection();
    void makePoisson();
    /// Takes the checkerboards out of the velocity, as the start does: products at the points alias onto them.
    void clearCheckerboards();

    Lattice lattice_;
    const Fluid& fluid_;
    const FlowSettings& settings_;
    Timings& timings_;
    DerivativeSymbol derivative_;
    OperatorBounds bounds_;
    std::unique_ptr<Operators> operators_;
    std::optional<FourierPoisson> poisson_;
    std::optional<IteratedPressure> iterated_; ///< instead
    RealField velocity_;
    RealField before_; ///< the velocity before the last step
    RealField rate_;
    RealField previousRate_;
    RealField gradient_; ///< scratch
    RealField products_; ///< scratch of one component
    RealField laplacian_;
    RealField force_;
    RealField source_;
    RealField phi_;
    RealField incrementalPressure_;
    RealField pressureBefore_;
    RealField pressure_;
    std::optional<OutputPressure> outputPressure_;
    long transforms_ = 0;
};

} // namespace isph
