#pragma once

namespace isph
{

/// The enstrophy that the loss of kinetic energy tells of: -(dE/dt - power)/(2 nu), which a periodic box keeps equal to
/// the enstrophy itself. What a scheme dissipates besides nu shows as the difference of the two.
///
/// dE/dt comes from the energies of successive rows, second order in their distance: backward differences over three
/// rows of any spacing. The second row has but one before it and uses the slope there: the line through both ends has
/// the mean of the two slopes. The first row has none before it; its dE/dt is the one that closes the budget.
class EnstrophyBudget
{
public:
    /// \param nu kinematic viscosity [m2/s], > 0
    explicit EnstrophyBudget(double nu) : nu_(nu) {}

    /// The budget at the next row.
    /// \param power of the forces on the fluid
    double next(double time, double energy, double power, double enstrophy);

private:
    double nu_;
    int rows_ = 0;
    double time_ = 0; ///< of the row before
    double energy_ = 0;
    double slope_ = 0;     ///< dE/dt there
    double lastStep_ = 0;  ///< between the two rows before
    double lastChord_ = 0; ///< difference quotient of the energy there
};

} // namespace isph
