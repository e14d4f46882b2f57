#pragma once

#include <vector>

namespace isph
{

/// The enstrophy that the loss of kinetic energy tells of: -(dE/dt - power)/(2 nu), equal to the enstrophy itself in an
/// exact flow. What a scheme dissipates besides nu, or does not resolve, shows as the difference of the two.
///
/// dE/dt is the slope of the polynomial through the energies of the last five rows, whatever their distances: fourth
/// order in them. The first row has none before it; its slope is the one that closes the budget, and stands in for the
/// rows that are missing after it (second order at the second row, third at the third).
class EnstrophyBudget
{
public:
    /// \param nu kinematic viscosity [m2/s], > 0
    explicit EnstrophyBudget(double nu) : nu_(nu) {}

    /// The budget at the next row, the last one's where no time has passed.
    /// \param power of the forces on the fluid and of the boundary (FlowDiagnostics)
    double next(double time, double energy, double power, double enstrophy);

private:
    double slope() const;

    double nu_;
    double startSlope_ = 0;
    std::vector<double> times_; ///< newest first; the first row counts twice, once for its slope
    std::vector<double> energies_;
    double last_ = 0;
};

} // namespace isph
