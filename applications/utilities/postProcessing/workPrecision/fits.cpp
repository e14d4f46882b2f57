#include "fits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph
{

namespace
{

bool counts(double x, double y) { return std::isfinite(x) && std::isfinite(y) && x > 0 && y > 0; }

/// Errors of the form 10^n, or {1, 2, 5} 10^n, between two, the largest first.
std::vector<double> levels(double smallest, double largest, const std::vector<double>& steps)
{
    constexpr double roundOff = 1e-9;
    std::vector<double> result;
    for (int power = static_cast<int>(std::ceil(std::log10(largest))) + 1;
         std::pow(10.0, power + 1) > smallest && power > -40; --power)
    {
        for (const double step : steps)
        {
            const double level = step * std::pow(10.0, power);
            if (level <= largest * (1 + roundOff) && level >= smallest * (1 - roundOff)) { result.push_back(level); }
        }
    }
    return result;
}

} // namespace

std::optional<Slope> fitSlope(const std::vector<double>& x, const std::vector<double>& y)
{
    double count = 0;
    double meanX = 0;
    double meanY = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        if (!counts(x[i], y[i])) { continue; }
        count += 1;
        meanX += std::log(x[i]);
        meanY += std::log(y[i]);
    }
    if (count < 2) { return std::nullopt; }
    meanX /= count;
    meanY /= count;
    double xx = 0;
    double xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        if (!counts(x[i], y[i])) { continue; }
        const double dx = std::log(x[i]) - meanX;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - meanY);
    }
    if (xx <= 1e-20) { return std::nullopt; }
    return Slope{xy / xx, static_cast<std::size_t>(count)};
}

std::optional<CostOf> costOf(const CostCurve& curve, double error)
{
    std::optional<CostOf> best;
    const auto take = [&best](double cost, bool atMost)
    {
        if (!best || cost < best->cost) { best = CostOf{cost, atMost}; }
    };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < curve.cost.size(); ++i)
    {
        if (counts(curve.cost[i], curve.error[i])) { least = std::min(least, curve.cost[i]); }
    }
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < curve.cost.size(); ++i)
    {
        if (curve.error[i] == 0 && counts(curve.cost[i], error))
        {
            take(curve.cost[i], curve.cost[i] <= least); // whatever is asked, but there is no line to it
            before.reset();
            continue;
        }
        if (!counts(curve.cost[i], curve.error[i])) { continue; }
        const double now = std::log(curve.error[i] / error);
        if (now <= 0) { take(curve.cost[i], curve.cost[i] == least && now < 0); }
        if (before)
        {
            const double then = std::log(curve.error[*before] / error);
            if (then * now < 0)
            {
                const double part = then / (then - now);
                take(curve.cost[*before] * std::pow(curve.cost[i] / curve.cost[*before], part), false);
            }
        }
        before = i;
    }
    return best;
}

std::vector<Cheapest> cheapest(const std::vector<CostCurve>& curves)
{
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const CostCurve& curve : curves)
    {
        for (std::size_t i = 0; i < curve.cost.size(); ++i)
        {
            if (!counts(curve.cost[i], curve.error[i])) { continue; }
            smallest = std::min(smallest, curve.error[i]);
            largest = std::max(largest, curve.error[i]);
        }
    }
    if (!(largest > 0)) { return {}; }
    std::vector<double> asked = levels(smallest, largest, {1});
    if (asked.size() < 2) { asked = levels(smallest, largest, {5, 2, 1}); }

    std::vector<Cheapest> result;
    for (const double error : asked)
    {
        std::optional<Cheapest> row;
        for (std::size_t i = 0; i < curves.size(); ++i)
        {
            const std::optional<CostOf> cost = costOf(curves[i], error);
            if (!cost) { continue; }
            if (!row) { row = Cheapest{error, i, *cost, {}, {}}; }
            else if (cost->cost < row->cost.cost) { row = Cheapest{error, i, *cost, row->curve, row->cost}; }
            else if (!row->secondCost || cost->cost < row->secondCost->cost)
            {
                row->second = i;
                row->secondCost = cost;
            }
        }
        if (row) { result.push_back(*row); }
    }
    return result;
}

} // namespace isph
