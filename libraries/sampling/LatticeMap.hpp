#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"
#include "spectral/FourierTransform.hpp"

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// Takes fields of one lattice to the points of another.
///
/// Where both boxes are one period along every axis, by their Fourier modes: a finer lattice gets the Fourier series
/// itself, a coarser one the modes it can hold, so that nothing is aliased; a shift of the box is a phase. Else point
/// by point, by the Fourier series of the values along periodic axes, of their continuation along bounded ones. An axis
/// that the source leaves out is uniform; an axis that the target leaves out is cut at the target's place.
class LatticeMap
{
public:
    /// \throws Error(input) if the target lies outside of the source along a bounded axis, or is no whole number of
    ///         periods long along a periodic one.
    LatticeMap(const Lattice& source, const Lattice& target);

    /// A scalar, or a vector with one component for each active axis of its lattice; a component along an axis that the
    /// source leaves out is zero.
    RealField operator()(const RealField& field);

    /// How values are found, for a report: "the points are the same", "Fourier modes", "spectral along x, spectral
    /// by continuation along y".
    std::string method() const;

private:
    /// Where a mode of the source goes along one axis; a Nyquist mode may go to two places.
    struct ModeStep
    {
        std::size_t from;
        std::size_t to;
        std::complex<double> factor;
    };
    using ModeSteps = std::array<std::vector<ModeStep>, 3>;

    /// The transforms of both lattices, where modes are mapped.
    struct Modes
    {
        Modes(const Lattice& source, const Lattice& target);
        void map(std::span<const double> field, std::span<double> mapped);

        std::array<std::size_t, 3> sourceExtents;
        std::array<std::size_t, 3> targetExtents;
        ModeSteps steps;
        FourierTransform sourceTransform;
        FourierTransform targetTransform;
        RealField sourceValues;
        RealField targetValues;
        SpectralField sourceModes;
        SpectralField targetModes;
    };

    static std::vector<ModeStep> stepsOf(const Axis& source, const Axis& target, bool half);
    void interpolate(std::span<const double> field, std::span<double> mapped) const;
    void map(std::span<const double> field, std::span<double> mapped);

    Lattice source_;
    Lattice target_;
    bool samePoints_ = false;
    std::optional<Modes> modes_;
};

} // namespace isph
