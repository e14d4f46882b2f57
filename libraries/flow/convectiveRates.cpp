#include "flow/convectiveRates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace isph
{

namespace
{

struct Largest
{
    double courant = 0;
    double sumOfCourants = 0;
    double axes = 0;   ///< largest sum |u_j| max|D_j|
    double speed2 = 0; ///< largest |u|^2
};

template<int D>
Largest scan(const RealField& velocity, std::size_t begin, std::size_t end, const std::array<double, 3>& perSpacing,
             const std::array<double, 3>& derivative)
{
    Largest largest;
    std::array<const double*, D> u{};
    for (int d = 0; d < D; ++d) { u[static_cast<std::size_t>(d)] = velocity[d].data(); }
    // Independent lanes: one maximum would have to wait for the one before at every point.
    constexpr std::size_t lanes = 8;
    std::array<double, lanes> courants{};
    std::array<double, lanes> sums{};
    std::array<double, lanes> axes{};
    std::array<double, lanes> speeds2{};
    const auto visit = [&](std::size_t i, std::size_t lane)
    {
        double courant = 0;
        double ofAxes = 0;
        double speed2 = 0;
        for (std::size_t d = 0; d < D; ++d)
        {
            const double magnitude = std::abs(u[d][i]);
            courant += magnitude * perSpacing[d];
            ofAxes += magnitude * derivative[d];
            speed2 += magnitude * magnitude;
        }
        // A maximum would pass over a NaN; the sum does not.
        courants[lane] = courant > courants[lane] ? courant : courants[lane];
        axes[lane] = ofAxes > axes[lane] ? ofAxes : axes[lane];
        speeds2[lane] = speed2 > speeds2[lane] ? speed2 : speeds2[lane];
        sums[lane] += courant;
    };
    const std::size_t whole = begin + (end - begin) / lanes * lanes;
    for (std::size_t i = begin; i < whole; i += lanes)
    {
        for (std::size_t lane = 0; lane < lanes; ++lane) { visit(i + lane, lane); }
    }
    for (std::size_t i = whole; i < end; ++i) { visit(i, i - whole); }
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
        largest.courant = std::max(largest.courant, courants[lane]);
        largest.axes = std::max(largest.axes, axes[lane]);
        largest.speed2 = std::max(largest.speed2, speeds2[lane]);
        largest.sumOfCourants += sums[lane];
    }
    return largest;
}

} // namespace

void addConvectiveRates(const Lattice& lattice, const RealField& velocity, const OperatorBounds& bounds, double nu,
                        StepRates& rates)
{
    std::array<double, 3> perSpacing{0, 0, 0};
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        perSpacing[static_cast<std::size_t>(d)] = 1 / lattice.activeAxis(d).spacing();
    }

    // Blocks of fixed length, so that the mean has the same bits whatever the number of threads.
    constexpr std::size_t block = 4096;
    const std::size_t size = lattice.points();
    double sum = 0;
    double axes = 0;
    double speed2 = 0;
    for (std::size_t begin = 0; begin < size; begin += block)
    {
        const std::size_t end = begin + block < size ? begin + block : size;
        const Largest part = lattice.dimensions() == 2 ? scan<2>(velocity, begin, end, perSpacing, bounds.derivative)
                                                       : scan<3>(velocity, begin, end, perSpacing, bounds.derivative);
        rates.courant = part.courant > rates.courant ? part.courant : rates.courant;
        axes = part.axes > axes ? part.axes : axes;
        speed2 = part.speed2 > speed2 ? part.speed2 : speed2;
        sum += part.sumOfCourants;
    }
    rates.meanCourant = sum / static_cast<double>(size);
    if (!std::isfinite(sum) || !std::isfinite(speed2))
    {
        rates.courant = rates.convective = std::numeric_limits<double>::quiet_NaN();
        return;
    }
    const double isotropic = std::sqrt(speed2) * bounds.derivativeMagnitude;
    rates.convective = isotropic < axes ? isotropic : axes;
    if (nu > 0) { rates.unbalancedConvection = speed2 * bounds.derivativeOverLaplacian / nu; }
}

} // namespace isph
