#include "neighbours/LatticeStencil.hpp"

#include "core/Error.hpp"

#include <cmath>

namespace isph
{

std::vector<std::array<int, 3>> latticeStencil(const Lattice& lattice, double smoothingLength, double supportRadius)
{
    const double radius =
        smoothingLength * supportRadius * (1 + 1e-12); // in spacings: h_j/dx_j is the same on each axis
    const int dimensions = lattice.dimensions();
    constexpr double largest = 2e7;
    if (std::pow(2 * radius + 1, dimensions) > largest)
    {
        throw Error(Fault::input, "the sampled kernel would have more than 20 million neighbours",
                    "choose a smaller supportRadius or smoothingLength, or symbol closed;");
    }

    const int reach = static_cast<int>(radius);
    const auto reachOf = [dimensions, reach](int d) { return d < dimensions ? reach : 0; };
    std::vector<std::array<int, 3>> offsets;
    for (int k = -reachOf(2); k <= reachOf(2); ++k)
    {
        for (int j = -reachOf(1); j <= reachOf(1); ++j)
        {
            for (int i = -reach; i <= reach; ++i)
            {
                const double distance2 =
                    static_cast<double>(i) * i + static_cast<double>(j) * j + static_cast<double>(k) * k;
                if (distance2 <= radius * radius) { offsets.push_back({i, j, k}); }
            }
        }
    }
    return offsets;
}

} // namespace isph
