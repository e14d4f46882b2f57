#pragma once

#include "boundary/FlowBoundary.hpp"
#include "continuation/ContinuedDerivative.hpp"
#include "continuation/ContinuedFilter.hpp"
#include "core/Timings.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "flow/IteratedPressure.hpp"
#include "flow/OutflowCondition.hpp"
#include "flow/VolumeBalance.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "operators/ExtendedOperators.hpp"
#include "poisson/BoundedPoisson.hpp"
#include "poisson/ContinuedHelmholtz.hpp"
#include "poisson/MirroredPoisson.hpp"

#include <optional>
#include <vector>

namespace isph
{

/// ISPH in a box with walls, inlets and outlets: operators by Fourier continuation, one axis at a time, the pressure by
/// real transforms (Lin, Fourtakas & Rogers 2026, with the wall condition of docs/theory/walls.md).
class BoundedFlow : public IncompressibleFlow
{
public:
    /// fluid, settings and boundary must outlive the flow; the boundary holds the data of the flow's time.
    /// \throws Error(input) without origin where an axis has too few points.
    BoundedFlow(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings, FlowBoundary& boundary,
                Timings& timings, PlanEffort effort = PlanEffort::measured);

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
    std::string planFingerprint() const override { return fingerprint_; }
    const PressureRecord* pressureRecord() const override { return iterated_ ? &iterated_->record() : nullptr; }

    std::vector<std::string> cautions() const override;
    std::string_view viscousStep() const override;

    const OperatorBounds& bounds() const { return bounds_; }

private:
    /// The derivative of a velocity component along an active axis, and what its walls give it.
    ContinuedDerivative& derivative(int component, int d);
    EndData endData(int component, int d) const;
    std::array<EndData, 3> allEndData(int component) const; ///< by direction
    /// What continuations know of a velocity component, or of the pressure: that one past the last component.
    ExtendedOperators::Ends endsOf(int component) const;

    void makeDerivatives(PlanEffort effort);
    void makeExtended(PlanEffort effort);
    void makeHelmholtz();
    void makePoisson(const std::array<AxisEnds, 3>& ends, PlanEffort effort);
    /// A hash of what the operators make of noise: plans that differ show in its last bits.
    std::string probe();
    /// Whether the viscous term can be taken implicitly; for viscous auto, which has a choice.
    bool canYield();
    bool marches(WallTreatment treatment) const { return settings_.walls == treatment; }
    /// Whether the pressure is marched: by its treatment of the walls, or by an implicit viscous term.
    bool marchesPressure() const;
    void makeIncrements();

    /// rate = -(u . D)u + nu lap u + f at all points, walls included.
    void evaluateRate(double t, double nu);
    /// u += dt (g F^k + z F^{k-1}); the rates change places.
    void addRates(const Substep& substep, double dt);
    /// rate += -carrier du + nu d2u along an axis, for a velocity component; the axes one after the other from 0.
    void addTransport(int component, int d, std::span<const double> u, std::span<const double> carrier, double nu,
                      std::span<double> rate);
    void slopeOfVelocity(const RealField& u, int d, std::span<double> slope);   ///< of component d along axis d
    void slopeOfPressure(const RealField& phi, int d, std::span<double> slope); ///< the axes from 0, too
    void laplacian(const RealField& u, RealField& result);
    void gradientOf(const RealField& phi, RealField& result);
    /// Tangential wall values = what the walls prescribe + period D phi: what the projection will take away again.
    void presetTangential(double period);
    /// Solves (1 - beta lap) u* = u with what the walls prescribe.
    void solveViscous(double beta);
    void projectIncrement(double period);
    void advanceByPressurePoisson(const Substep& substep, double t, double dt);
    void finishStep(const Substep& substep);
    /// divergence = factor div u
    void divergenceOf(const RealField& u, double factor, RealField& divergence);
    /// u -= period D phi, phi what solvePoisson found last.
    void subtractGradient(double period, const RealField& phi, RealField& u);
    /// A time in which walls that move hardly change their speed [s].
    double pauseAt(double t) const;
    /// What walls have done to the velocity since t, in slopes_: less their acceleration.
    void subtractAcceleration(double t);
    /// Solves lap phi = div u/period with what slopes_ says at the faces. \param keepsWalls u has what walls prescribe
    void solvePressure(const RealField& u, double period, bool keepsWalls, RealField& phi);
    void solvePoisson(bool keepsWalls, RealField& phi);
    /// What the faces ask of the gradient of phi: the normal component of u there ...
    void readNormal(const RealField& u, double factor, bool add = false);
    /// ... less the prescribed one ...
    void subtractPrescribed(double factor);
    /// ... but where the pressure itself is prescribed, or its slope.
    void readPressures();
    void slopesOfSource(int d);
    static constexpr int pointsOfSlopes = 6;

    Lattice lattice_;
    const Fluid& fluid_;
    const FlowSettings& settings_;
    FlowBoundary& boundary_;
    Timings& timings_;
    int dimensions_;
    OperatorBounds bounds_;
    std::vector<ContinuedDerivative> derivatives_;
    std::array<std::array<std::size_t, 3>, 3> derivativeOf_{};        ///< by component and axis
    std::array<std::array<std::size_t, 3>, 3> viscousDerivativeOf_{}; ///< of a viscous term by itself
    std::array<std::size_t, 3> pressureDerivative_{};                 ///< by axis
    std::vector<ContinuedFilter> filters_;                            ///< by axis, as derivatives_
    std::vector<ExtendedOperators> extended_;                         ///< instead of derivatives_
    std::array<std::size_t, 4> extendedOf_{};                         ///< by component, the pressure after the last
    std::optional<BoundedPoisson> poisson_;                           ///< one of these four
    std::optional<MirroredPoisson> mirrored_;                         ///< eigenvalues morris
    std::optional<IteratedPressure> iterated_;                        ///< the same, by iterations
    std::optional<ContinuedHelmholtz> direct_;                        ///< solver direct
    OutflowCondition outflow_;
    std::optional<VolumeBalance> balance_;      ///< where there is an outlet
    std::vector<ContinuedHelmholtz> helmholtz_; ///< by velocity component; made when first needed
    /// Slopes of the pressure along the first periodic axis come with its solution, for one transform less.
    std::optional<PeriodicSlope> periodicSlope_;
    std::vector<double> periodicSymbol_;
    RealField slope_;
    std::optional<int> closedAxis_; ///< the only bounded axis: its pressure is fourth order
    std::array<std::array<std::vector<double>, 2>, 3> slopes_;
    std::array<std::vector<double>, 2> sourceSlopes_;

    RealField velocity_;
    RealField before_; ///< the velocity before the last step
    RealField rate_;
    RealField previousRate_;
    std::array<double, 3> uniformForce_{0, 0, 0};
    RealField force_; ///< one that is not uniform
    bool forceKnown_ = false;
    RealField scratch_;
    RealField source_;
    RealField phi_;
    RealField phiBefore_; ///< where the pressure is marched, too
    RealField gradient_;  ///< of phi, where a treatment needs it
    RealField laplacian_;
    RealField increment_; ///< of the pressure, or the divergence
    RealField pressure_;
    std::string fingerprint_;
    double lastStep_ = 0;
    double stepBefore_ = 0;      ///< the step before the last one
    double explicitRate_ = 0;    ///< one over the largest step with every term explicit
    bool pressureKnown_ = false; ///< phi_ is one that can be marched
    bool mayYield_ = false;      ///< viscous auto, and there is a way to take the term implicitly
    bool apart_ = false;         ///< the pressure is solved off the steps
    bool implicit_ = false;      ///< the viscous term in this step
    long transforms_ = 0;
};

} // namespace isph
