#include "functions/EnstrophyBudget.hpp"

#include <cstddef>

namespace isph
{

namespace
{

constexpr std::size_t rows = 5;

} // namespace

double EnstrophyBudget::next(double time, double energy, double power, double enstrophy)
{
    if (times_.empty())
    {
        startSlope_ = power - 2 * nu_ * enstrophy;
        times_.assign(2, time);
        energies_.assign(2, energy);
        return last_ = enstrophy;
    }
    if (!(time > times_.front())) { return last_; }
    times_.insert(times_.begin(), time);
    energies_.insert(energies_.begin(), energy);
    if (times_.size() > rows)
    {
        times_.pop_back();
        energies_.pop_back();
    }
    return last_ = (power - slope()) / (2 * nu_);
}

double EnstrophyBudget::slope() const
{
    // Newton's form at the newest row: sum over k of f[t0 ... tk] (t0 - t1) ... (t0 - t(k-1)).
    std::vector<double> differences = energies_;
    double slope = 0;
    double product = 1;
    for (std::size_t k = 1; k < times_.size(); ++k)
    {
        for (std::size_t i = 0; i + k < times_.size(); ++i)
        {
            const double distance = times_[i] - times_[i + k];
            differences[i] = distance > 0 ? (differences[i] - differences[i + 1]) / distance : startSlope_;
        }
        slope += product * differences[0];
        product *= times_[0] - times_[k];
    }
    return slope;
}

} // namespace isph
