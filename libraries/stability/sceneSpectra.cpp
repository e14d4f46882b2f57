#include "stability/sceneSpectra.hpp"

#include "flow/faceConditions.hpp"
#include "flow/sceneSymbols.hpp"
#include "stability/LineSpectra.hpp"
#include "stability/trialFlows.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Of the unit: what is smaller comes from rounding, and no run is long enough to see it.
constexpr double growthHidden = 1e-4;

OperatorSpectrum summary(std::string name, int derivative, const LineSpectra::Spectrum& values, double spacing)
{
    OperatorSpectrum result{.name = std::move(name), .derivative = derivative, .words = {}};
    const double unit = std::pow(std::numbers::pi / spacing, derivative);
    result.count = values.size();
    result.growth = -std::numeric_limits<double>::infinity();
    for (const auto& value : values)
    {
        result.radius = std::max(result.radius, std::abs(value) / unit);
        result.growth = std::max(result.growth, value.real() / unit);
        result.imaginary = std::max(result.imaginary, std::abs(value.imag()) / unit);
    }
    result.grows = result.growth > growthHidden;
    return result;
}

std::string wordsOf(const OperatorSpectrum& spectrum, bool periodic)
{
    if (spectrum.count == 0) { return fmt::format("more than {} points: not computed", LineSpectra::longest); }
    const std::string_view modes = periodic ? "waves" : "modes at the ends";
    const std::string unit = spectrum.derivative == 1 ? "|u| pi/dx" : "nu (pi/dx)^2";
    if (spectrum.grows)
    {
        return fmt::format("{} grow in exact time, at up to {:.2g} {}", modes, spectrum.growth, unit);
    }
    if (spectrum.derivative == 1)
    {
        return periodic ? "imaginary: waves are carried, none grows or dies out"
                        : "nothing grows: waves are carried, modes at the ends die out";
    }
    return spectrum.imaginary > growthHidden ? "nothing grows; some modes die out in pairs that turn"
                                             : "real and negative: everything dies out";
}

std::vector<OperatorSpectrum> ofPeriodicBox(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings)
{
    const OperatorBounds bounds = boundsOf(lattice, fluid, settings);
    std::vector<OperatorSpectrum> spectra;
    double least = lattice.activeAxis(0).spacing();
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const double largest = bounds.derivative[at(d)];
        least = std::min(least, axis.spacing());
        spectra.push_back(
            summary(fmt::format("d/d{}", axis.name), 1, {{0, largest}, {0, -largest}, {0, 0}}, axis.spacing()));
    }
    if (fluid.nu > 0)
    {
        spectra.push_back(
            summary("Laplacian", 2, {{-bounds.laplacian, 0}, {-bounds.leastLaplacian, 0}, {0, 0}}, least));
    }
    for (OperatorSpectrum& spectrum : spectra) { spectrum.words = wordsOf(spectrum, true); }
    return spectra;
}

/// Whether lines of the component along an axis end as those of the others do.
bool closedAlike(const Lattice& lattice, const FlowBoundary& boundary, int d)
{
    const int direction = lattice.direction(d);
    const bool staggered = lattice.axis(direction).staggered;
    for (const Side side : {Side::low, Side::high})
    {
        const FaceCondition& face = boundary.face(direction, side);
        if (holdsValue(face, true) != holdsValue(face, false)) { return false; }
        if (velocityEnd(face, true, staggered) != velocityEnd(face, false, staggered)) { return false; }
    }
    return true;
}

} // namespace

std::vector<OperatorSpectrum> sceneSpectra(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                                           const FlowBoundary& boundary)
{
    if (lattice.periodic()) { return ofPeriodicBox(lattice, fluid, settings); }
    const LineSpectra lines(lattice, settings, boundary);
    const auto passage = passageOf(lattice, boundary);
    std::vector<OperatorSpectrum> spectra;
    const auto add =
        [&](std::string name, int derivative, const std::optional<LineSpectra::Spectrum>& values, const Axis& axis)
    {
        OperatorSpectrum found =
            summary(std::move(name), derivative, values.value_or(LineSpectra::Spectrum()), axis.spacing());
        found.words = wordsOf(found, axis.periodic());
        spectra.push_back(std::move(found));
    };
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const int along = d == 0 ? 1 : 0;
        // Components along a face share their conditions; the one through it may have others.
        const bool alike = axis.periodic() || closedAlike(lattice, boundary, d);
        for (const int c : alike ? std::vector<int>{along} : std::vector<int>{d, along})
        {
            const std::string of = alike ? "" : fmt::format(" of U.{}", lattice.activeAxis(c).name);
            if (settings.convection != ConvectionForm::none)
            {
                const int sign = passage && passage->d == d ? passage->sign : 1;
                add(fmt::format("d/d{}{}", axis.name, of), 1, lines.convection(c, d, sign), axis);
            }
            if (fluid.nu > 0) { add(fmt::format("d2/d{0}2{1}", axis.name, of), 2, lines.diffusion(c, d), axis); }
        }
    }
    return spectra;
}

} // namespace isph
