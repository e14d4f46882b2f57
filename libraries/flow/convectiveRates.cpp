#include "flow/convectiveRates.hpp"

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
    for (std::size_t i = begin; i < end; ++i)
    {
        double courant = 0;
        double axes = 0;
        double speed2 = 0;
        for (std::size_t d = 0; d < D; ++d)
        {
            const double magnitude = std::abs(u[d][i]);
            courant += magnitude * perSpacing[d];
            axes += magnitude * derivative[d];
            speed2 += magnitude * magnitude;
        }
        // A maximum would pass over a NaN; the sum below does not.
        largest.courant = courant > largest.courant ? courant : largest.courant;
        largest.axes = axes > largest.axes ? axes : largest.axes;
        largest.speed2 = speed2 > largest.speed2 ? speed2 : largest.speed2;
        largest.sumOfCourants += courant;
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
