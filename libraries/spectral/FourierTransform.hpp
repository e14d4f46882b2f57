#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <memory>
#include <string>

namespace isph
{

/// How hard the planner looks for a fast transform.
enum class PlanEffort
{
    estimated, ///< at once; for programs that transform a few times
    measured,  ///< tries candidates and keeps what it learned in the user's cache; for time loops
};

/// Real Fourier transform of every component of a field over all active axes of a periodic lattice.
///
/// Modes are stored as reals are: the first active axis fastest, with count/2 + 1 non-negative wavenumbers; the others
/// run 0 ... n/2, then the negative ones. Neither direction is normalised: backward(forward(f)) = points * f.
/// Plans are made in the constructor, on their own scratch; transforming allocates nothing.
class FourierTransform
{
public:
    /// Plans for a batch of components.
    FourierTransform(const Lattice& lattice, int components, PlanEffort effort = PlanEffort::estimated);
    ~FourierTransform();
    FourierTransform(FourierTransform&&) noexcept;
    FourierTransform& operator=(FourierTransform&&) noexcept;

    /// Transforms the first components() components of both fields; real stays as it is.
    void forward(const RealField& real, SpectralField& modes);

    /// Overwrites modes with scratch.
    void backward(SpectralField& modes, RealField& real);

    int components() const;
    std::size_t points() const;
    std::size_t modes() const; ///< complex coefficients of one component

    /// Transforms of one component made so far, both directions.
    long count() const;

    /// Tells plans apart: two runs with the same fingerprint transform in the same bits.
    const std::string& fingerprint() const;

private:
    struct Plans;
    std::unique_ptr<Plans> plans_;
};

/// Extents of the spectral arrays, first active axis first: {n0/2 + 1, n1, n2}, 1 where there is no axis.
std::array<std::size_t, 3> modeExtents(const Lattice& lattice);

} // namespace isph
