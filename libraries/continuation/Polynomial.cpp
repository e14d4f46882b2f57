#include "continuation/Polynomial.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/QR>
#include <string>

namespace isph
{

Polynomial::Polynomial(int newPoints, int degree, int points, int smoothness)
    : BlendedContinuation(newPoints, smoothness), degree_(degree), points_(points)
{
    if (degree < 0 || degree > largestDegree)
    {
        throw Error(Fault::input,
                    "degree " + std::to_string(degree) + " is not one of 0 ... " + std::to_string(largestDegree));
    }
    if (points < degree + 1)
    {
        throw Error(Fault::input,
                    std::to_string(points) + " points do not determine a polynomial of degree " +
                        std::to_string(degree),
                    "write at least points " + std::to_string(degree + 1) + ";");
    }
}

int Polynomial::automaticPoints(int intervals) { return std::max(8, intervals / 4); }

std::vector<BlendedContinuation::Extrapolation> Polynomial::extrapolations(EndCondition condition) const
{
    // The variable runs from 0 to 1 over the fitted points: powers of the coordinate itself would be ill-conditioned.
    const double scale = 1.0 / std::max(points_ - 1, 1);
    std::vector<int> powers;
    for (int power = 0; power <= degree_; ++power)
    {
        // A given derivative at the wall is subtracted from the data, and its power left out of the fit.
        if (power != 1 || condition == EndCondition::dirichlet) { powers.push_back(power); }
    }
    const auto columns = static_cast<Eigen::Index>(powers.size());
    Eigen::MatrixXd values(points_, columns);
    for (int c = 0; c < points_; ++c)
    {
        for (Eigen::Index j = 0; j < columns; ++j)
        {
            values(c, j) = std::pow(c * scale, powers[static_cast<std::size_t>(j)]);
        }
    }
    const Eigen::MatrixXd coefficients = values.householderQr().solve(Eigen::MatrixXd::Identity(points_, points_));

    std::vector<Extrapolation> steps;
    for (int k = 1; k <= newPoints(); ++k)
    {
        Eigen::RowVectorXd monomials(columns);
        for (Eigen::Index j = 0; j < columns; ++j)
        {
            monomials(j) = std::pow(-k * scale, powers[static_cast<std::size_t>(j)]);
        }
        const Eigen::RowVectorXd weights = monomials * coefficients;
        Extrapolation step;
        step.weights.assign(weights.data(), weights.data() + weights.size());
        if (condition == EndCondition::neumann)
        {
            step.datum = k;
            for (int c = 0; c < points_; ++c) { step.datum += c * weights(c); }
        }
        steps.push_back(step);
    }
    return steps;
}

} // namespace isph
