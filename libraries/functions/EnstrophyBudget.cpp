#include "functions/EnstrophyBudget.hpp"

namespace isph
{

double EnstrophyBudget::next(double time, double energy, double power, double enstrophy)
{
    const double step = time - time_;
    if (rows_ == 0) { slope_ = power - 2 * nu_ * enstrophy; }
    else if (step > 0)
    {
        const double chord = (energy - energy_) / step;
        slope_ = rows_ == 1 ? 2 * chord - slope_ : chord + (chord - lastChord_) * step / (step + lastStep_);
        lastStep_ = step;
        lastChord_ = chord;
    }
    else { return (power - slope_) / (2 * nu_); } // the same time again
    time_ = time;
    energy_ = energy;
    ++rows_;
    return (power - slope_) / (2 * nu_);
}

} // namespace isph
