#pragma once

#include <array>
#include <complex>
#include <cstddef>

namespace isph
{

/// The inner loops of SpectralFlow over a stretch of modes, kept apart so that each is plain enough to be vectorised.
/// Complex values are handled as pairs of doubles: complex multiplication would check for infinities.

/// What a substep does to one velocity component before the projection.
struct Prediction
{
    double now;            ///< dt g
    double before;         ///< dt z
    const double* lessOne; ///< integrating factor less one; null: none
    bool first;            ///< no rate is carried yet
    bool last;             ///< no rate needs to be carried on
};

/// value = E (u + now rate + before carried); carried = E rate.
void predict(const Prediction& prediction, const std::complex<double>* u, const std::complex<double>* rate,
             std::complex<double>* carried, std::complex<double>* value, std::size_t length);

/// A substep whose rate is the divergence of products alone, of a kernel whose derivative is parallel to the wave
/// vector: all of it in one loop, no buffer in between. Pointers are to the first mode of a component.
struct PlainSubstep
{
    Prediction prediction;
    double scale;                                        ///< of the products
    const double* k0;                                    ///< wave vector along a row
    const double* smoothing;                             ///< of the derivative; null: 1
    const double* inverse;                               ///< 1/k^2
    std::array<const std::complex<double>*, 5> products; ///< as Convection orders them
    std::array<const std::complex<double>*, 3> from;     ///< u; may be to
    std::array<std::complex<double>*, 3> carried;
    std::array<std::complex<double>*, 3> to;     ///< the velocity, projected
    std::array<std::complex<double>*, 3> inputs; ///< and once more, for the next transform
};

/// Advances the modes of a row. \param kRow wave vector across it
void advancePlain(const PlainSubstep& modes, int dimensions, std::size_t first, std::size_t length,
                  const std::array<double, 2>& kRow);

/// value -= d (d . value)/L over two or three components; the quotient is left in multiplier where that is not null.
void project(const std::array<const double*, 3>& d, const double* inverse, int dimensions,
             const std::array<std::complex<double>*, 3>& value, std::complex<double>* multiplier, std::size_t length);

/// values *= first * ofRow.
void multiplyByPhase(std::complex<double>* values, const std::complex<double>* first, std::complex<double> ofRow,
                     std::size_t length);

/// values *= factors * ofRow.
void multiplyByFactors(std::complex<double>* values, const double* factors, double ofRow, std::size_t length);

} // namespace isph
