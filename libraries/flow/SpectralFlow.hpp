#pragma once

#include "core/Timings.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "flow/IteratedPressure.hpp"
#include "flow/OutputPressure.hpp"
#include "flow/ViscousFactors.hpp"
#include "operators/DerivativeSymbol.hpp"

#include <optional>

namespace isph
{

struct PlainSubstep;

/// Pseudo-spectral ISPH in a periodic box (Fourtakas et al. 2021): the velocity lives in Fourier space, where kernels,
/// viscosity, projection and filter are diagonal; only the products of the convective term are formed at the points.
///
/// Everything after the products' transform is one pass over the modes, in stretches that stay in the first-level
/// cache.
class SpectralFlow : public IncompressibleFlow
{
public:
    /// fluid and settings must outlive the flow.
    SpectralFlow(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings, Timings& timings,
                 PlanEffort effort = PlanEffort::measured);

    StartReport start(const RealField& velocity, bool project) override;
    void save(FieldWriter& writer) const override;
    void restore(const FieldReader& reader) override;
    bool restores(const FieldReader& reader) const override;
    void stepBack() override;
    StepRates rates() override;
    void advance(const Substep& substep, double t, double dt) override;
    const RealField& velocity() override;
    const RealField& pressure(double t) override;
    const RealField& divergence() override;
    long transforms() const override;
    std::string planFingerprint() const override;
    const PressureRecord* pressureRecord() const override { return iterated_ ? &iterated_->record() : nullptr; }

    const OperatorBounds& bounds() const { return bounds_; }

private:
    using Complex = std::complex<double>;
    using Direction = std::array<double, 3>;

    /// Modes handled together: their buffers stay in the first-level cache.
    static constexpr std::size_t stretch = 128;

    void stateChanged();
    void subtractMean();
    void gatherInputs();
    void ensureInputs();
    void updateForce(double t);
    bool keptRow(std::size_t row) const;
    void clearCheckerboards();
    void clearRow(std::size_t row, std::size_t from, SpectralField& target);
    void advanceStretch(std::size_t row, std::size_t begin, std::size_t end, const Substep& substep, double dt,
                        const SpectralField& from, SpectralField& to);

    /// Modes handled together, with their buffers.
    struct Stretch
    {
        std::size_t row;
        std::size_t begin; ///< index of the first mode in its row
        std::size_t first; ///< and in a component
        std::size_t length;
        std::array<double*, 3> d = {};      ///< the derivative's symbol, later the direction of the projection
        std::array<Complex*, 3> rate = {};  ///< F
        std::array<Complex*, 3> value = {}; ///< u*, later the velocity
    };

    /// Whether advancePlain is all there is to a substep: nothing of what it leaves out is asked for.
    bool isPlain(const Substep& substep) const;
    PlainSubstep plainSubstep(const Substep& substep, double dt, const SpectralField& from, SpectralField& to);

    /// Convection, force, and the viscous term where it is explicit.
    void evaluateRate(const Stretch& modes, const SpectralField& from) const;
    /// u* = E (u + dt (g F + z F_before))
    void predictVelocity(const Stretch& modes, const Substep& substep, double dt, const SpectralField& from);
    /// u = u* - d (d . u*)/L, along k where that is the same; the pressure acts over period.
    void projectVelocity(const Stretch& modes, double period);
    void filterVelocity(const Stretch& modes) const;
    /// u -= period D p
    void subtractSlope(const Stretch& modes, double period, const SpectralField& p) const;

    /// The projection where the pressure is iterated: the source of all modes, to the points, phi, and back.
    void makeIteration(PlanEffort effort);
    void gatherSource(const Stretch& modes, double period);
    void solveForPressure(const Substep& substep);
    void correctVelocity(const Substep& substep, double period);

    Lattice lattice_;
    const Fluid& fluid_;
    const FlowSettings& settings_;
    Timings& timings_;
    DerivativeSymbol derivative_;
    RetainedModes retained_;
    AlignedVector<double> viscousSymbol_; ///< nu times minus the Laplacian; empty if inviscid
    AlignedVector<double> inverse_;       ///< 1/eigenvalues of the pressure equation
    bool projectAlongWavevector_;         ///< consistent and parallel: Leray's projector, no division by the kernel
    OperatorBounds bounds_;
    std::vector<std::size_t> checkerboards_; ///< modes that are kept at zero
    std::array<std::vector<double>, 3> filterFactors_;
    std::unique_ptr<Convection> convection_;
    std::optional<FourierTransform> inputTransform_;
    std::optional<FourierTransform> productTransform_;
    std::optional<FourierTransform> forceTransform_;
    std::optional<ViscousFactors> viscousFactors_;
    std::optional<MeanFlowFactors> meanFlowFactors_;
    std::optional<IteratedPressure> iterated_; ///< instead of inverse_
    std::optional<FourierTransform> pressureTransform_;
    SpectralField phiModes_; ///< of the source, then of phi
    RealField source_;
    RealField phi_;

    SpectralField state_;
    SpectralField before_; ///< the state before the last step
    SpectralField rate_;   ///< carried from substep to substep
    SpectralField inputModes_;
    SpectralField productModes_;
    SpectralField forceModes_;
    SpectralField pressureModes_; ///< incremental coupling
    SpectralField pressureBefore_;
    RealField points_;                            ///< inputs of the convective term, then its products in their place
    std::array<double, 3> uniformForce_{0, 0, 0}; ///< feeds the mean alone
    RealField force_;                             ///< one that is not uniform
    Direction mean_{0, 0, 0};                     ///< carried exactly; zero where that is switched off

    bool inputModesReady_ = false;
    bool inputsReady_ = false;
    bool forceReady_ = false;
    RealField velocity_; ///< the following only when asked for
    RealField pressure_;
    RealField divergence_;
    std::optional<OutputPressure> outputPressure_;
    std::optional<FourierTransform> scalarTransform_;
    std::optional<FourierTransform> velocityTransform_;
};

} // namespace isph
