#include "schemes/TimeScheme.hpp"

#include <array>

namespace isph
{

namespace
{

/// Third order, low storage: Wray's coefficients (Lin et al. 2026, eq. 5).
constexpr std::array<Substep, 3> rungeKutta3{{
    {.a = 8.0 / 15, .g = 8.0 / 15, .z = 0, .start = 0, .numerator = 8, .denominator = 15, .first = true, .last = false},
    {.a = 2.0 / 15,
     .g = 5.0 / 12,
     .z = -17.0 / 60,
     .start = 8.0 / 15,
     .numerator = 2,
     .denominator = 15,
     .first = false,
     .last = false},
    {.a = 1.0 / 3,
     .g = 3.0 / 4,
     .z = -5.0 / 12,
     .start = 2.0 / 3,
     .numerator = 5,
     .denominator = 15,
     .first = false,
     .last = true},
}};

/// Cummins & Rudman 1999: forward Euler and one projection (Fourtakas et al. 2021, eqs 2.3-2.5).
constexpr std::array<Substep, 1> forwardEuler{
    {{.a = 1, .g = 1, .z = 0, .start = 0, .numerator = 1, .denominator = 1, .first = true, .last = true}}};

constexpr TimeScheme thirdOrder{rungeKutta3, 3, 1.7320508075688772, 2.5127453266183286};
constexpr TimeScheme firstOrder{forwardEuler, 1, 0, 2};

constexpr std::array<Selection<const TimeScheme*>::Variant, 2> table{{
    {"RK3", "third-order low-storage Runge-Kutta, a projection in each substep", &thirdOrder},
    {"firstOrderProjection", "forward Euler and one projection (Cummins & Rudman 1999)", &firstOrder},
}};
static_assert(distinct(table));

} // namespace

const Selection<const TimeScheme*>& timeSchemes()
{
    static constexpr Selection<const TimeScheme*> selection("time scheme", table);
    return selection;
}

void advance(const TimeScheme& scheme, IncompressibleSystem& system, double t, double dt)
{
    for (const Substep& substep : scheme.substeps) { system.advance(substep, t, dt); }
}

} // namespace isph
