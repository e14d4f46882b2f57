#include "schemeTables.hpp"

#include "stability/schemeTable.hpp"

#include <fmt/format.h>

namespace isph
{

namespace
{

std::string numberText(const std::optional<double>& value) { return value ? fmt::format("{:.3g}", *value) : "-"; }

/// A rate of growth; none worth mentioning is a dash.
std::string growthText(double rate) { return rate > 1e-4 ? fmt::format("{:.1e}", rate) : "-"; }

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

} // namespace

void printSchemeTables(Log& log)
{
    log.line("Periodic square, 64^2 points, no dealiasing, laplacian morris. RK3: the largest Courant number |u| dt/dx "
             "of a");
    log.line("flow along an axis and along a diagonal, and the largest viscous number nu dt/dx^2; "
             "firstOrderProjection: the");
    log.line("latter alone, for it bears no flow without viscosity");
    log.line();
    log.line(fmt::format("{:<15}{:>6}{:>8}{:>10}{:>10}{:>22}", "kernel", "h/dx", "axis", "diagonal", "viscous",
                         "firstOrderProjection"));
    for (const PeriodicLimits& row : periodicLimits())
    {
        log.line(fmt::format("{:<15}{:>6}{:>8.3g}{:>10.3g}{:>10.3g}{:>22.3g}", row.kernel,
                             numberText(row.smoothingLength), row.axis, row.diagonal, row.viscous,
                             row.viscousFirstOrder));
    }
    log.line();
    log.line("Between walls, RK3, laplacian secondDerivative: limits of a square box of 64 intervals; the fastest mode "
             "of a");
    log.line("flow from an inlet to an outlet [|u|/dx] and of viscosity between walls [nu/dx^2], - where none grows; "
             "whether");
    log.line(
        "Crank-Nicolson can be had; and what a step multiplies modes at the walls by through the projection alone");
    log.line();
    log.line(fmt::format("{:<15}{:>6}  {:<24}{:>8}{:>9}{:>9}{:>9}{:>7}{:>11}", "kernel", "h/dx", "continuation",
                         "Courant", "viscous", "flow", "at walls", "C-N", "projection"));
    for (const WallLimits& row : wallLimits())
    {
        log.line(fmt::format("{:<15}{:>6}  {:<24}{:>8.3g}{:>9.3g}{:>9}{:>9}{:>7}{:>11}", row.kernel,
                             numberText(row.smoothingLength), row.continuation, row.courant, row.viscous,
                             growthText(row.flowGrowth), growthText(row.viscousGrowth), row.realModes ? "yes" : "no",
                             row.atRest > 1.003 ? fmt::format("{:.3g}", row.atRest) : "-"));
    }
}

Json schemeTables()
{
    Json periodic = Json::array();
    for (const PeriodicLimits& row : periodicLimits())
    {
        periodic.add(Json::object({{"kernel", row.kernel},
                                   {"smoothingLength", orNull(row.smoothingLength)},
                                   {"courantAlongAxis", row.axis},
                                   {"courantAlongDiagonal", row.diagonal},
                                   {"viscousNumber", row.viscous},
                                   {"viscousNumberOfFirstOrderProjection", row.viscousFirstOrder}}));
    }
    Json walls = Json::array();
    for (const WallLimits& row : wallLimits())
    {
        walls.add(Json::object({{"kernel", row.kernel},
                                {"smoothingLength", orNull(row.smoothingLength)},
                                {"continuation", row.continuation},
                                {"courant", row.courant},
                                {"viscousNumber", row.viscous},
                                {"flowGrowth", row.flowGrowth},
                                {"viscousGrowth", row.viscousGrowth},
                                {"crankNicolson", row.realModes},
                                {"growthAtRest", row.atRest}}));
    }
    return Json::object({{"schema", 1}, {"periodic", periodic}, {"walls", walls}});
}

} // namespace isph
