#pragma once

#include "continuation/ContinuedDerivative.hpp"
#include "core/Timings.hpp"
#include "flow/FlowSettings.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "schemes/stabilityLimits.hpp"
#include "transport/GivenVelocity.hpp"
#include "transport/ScalarBoundary.hpp"

#include <optional>
#include <vector>

namespace isph
{

/// A scalar T that a given velocity carries and diffusion spreads, dT/dt = -(U . D) T + DT D2 T at all points of a
/// lattice, with kernels acting line by line through Fourier continuation (Lin, Fourtakas & Rogers 2026).
class ScalarTransport
{
public:
    /// Of the settings, kernel, Laplacian, continuations, time scheme, filter and dealiasing are used. All arguments
    /// must outlive this object.
    /// \param diffusivity DT [m2/s], >= 0
    /// \throws Error(input) without origin where an axis has too few points.
    ScalarTransport(const Lattice& lattice, double diffusivity, const FlowSettings& settings,
                    const GivenVelocity& velocity, ScalarBoundary& boundary, Timings& timings);

    /// Starts from these values as they are.
    void start(const RealField& values, double t);

    /// Makes values fit to march: dealiased where a velocity that varies asks for it, and with those that the boundary
    /// prescribes at time t. \return the part of the L2 norm that dealiasing dropped
    double prepare(RealField& values, double t);

    /// A step of dt from time t.
    void step(double t, double dt);

    /// Goes back to the state before the last step.
    void stepBack();

    const RealField& values() const { return values_; }
    const RealField& velocity() const { return velocity_; } ///< of the last time it was asked for

    /// What limits a step from time t.
    StepRates rates(double t);

    /// Whether the values are finite and, where values alone are prescribed, below `over` times the largest of those
    /// and of the start: transport makes no new extremes.
    bool sound(double over) const;

    /// Largest magnitude of the values now.
    double largest() const;

    /// Largest |dT/dt| over points in the step of dt that was just taken [1/s].
    double rateOfChange(double dt) const;

    bool dealiases() const { return !dealiasing_.empty(); }
    bool convects() const { return settings_.convection != ConvectionForm::none; }
    long transforms() const { return transforms_; } ///< of one component in steps so far

private:
    /// Multiplies the modes along an active axis with factors: a symbol like that of a derivative.
    struct LineFilter
    {
        int axis;
        ContinuedDerivative apply;
    };

    ContinuedTransform transformAlong(int d) const;
    void makeDerivatives();
    void makeFilters();
    void evaluateVelocity(double t);
    void advance(const Substep& substep, double t, double dt);
    void addRate(RealField& rate);
    void filter(std::vector<LineFilter>& filters, RealField& values);

    Lattice lattice_;
    double diffusivity_;
    const FlowSettings& settings_;
    const GivenVelocity& given_;
    ScalarBoundary& boundary_;
    Timings& timings_;
    OperatorBounds bounds_;
    std::vector<ContinuedDerivative> derivatives_; ///< by active axis
    std::vector<LineFilter> lowPass_;              ///< once a step
    std::vector<LineFilter> dealiasing_;           ///< in every substep

    RealField velocity_;
    std::optional<double> velocityTime_;
    RealField values_;
    RealField before_; ///< the values before the last step
    RealField rate_;
    RealField previousRate_;
    double largestStart_ = 0;
    long transforms_ = 0;
};

} // namespace isph
