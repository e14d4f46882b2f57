#include "flow/startVelocity.hpp"

#include "poisson/eigenvalues.hpp"

#include <cmath>

namespace isph
{

StartReport startVelocity(const Lattice& lattice, const DerivativeSymbol& derivative, const RetainedModes& retained,
                          const RealField& velocity, bool project, SpectralField& coefficients)
{
    const ModeRows& rows = derivative.rows();
    const int dimensions = lattice.dimensions();
    FourierTransform(lattice, dimensions).forward(velocity, coefficients);
    const AlignedVector<double> inverse =
        invertedEigenvalues(rows, poissonEigenvalues(lattice, Eigenvalues::consistent, derivative, {}));

    std::array<std::vector<double>, 3> d;
    for (auto& row : d) { row.assign(rows.length(), 0.0); }
    const double scale = 1.0 / static_cast<double>(lattice.points());
    double total = 0;
    double projected = 0;
    double dealiased = 0;
    double nyquist = 0;
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        derivative.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
        const bool rowKept = retained.index(1, rows.index(row, 1)) && retained.index(2, rows.index(row, 2));
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            const std::size_t mode = rows.offset(row) + i;
            double magnitude2 = 0;
            std::complex<double> along = 0; // d . u
            for (int c = 0; c < dimensions; ++c)
            {
                std::complex<double>& u = coefficients[c][mode];
                u *= scale;
                magnitude2 += std::norm(u);
                along += d[static_cast<std::size_t>(c)][i] * u;
            }
            total += rows.multiplicity(i) * magnitude2;

            const auto clear = [&](double& account)
            {
                account += rows.multiplicity(i) * magnitude2;
                for (int c = 0; c < dimensions; ++c) { coefficients[c][mode] = 0; }
            };
            if (!rowKept || i >= retained.length()) { clear(dealiased); }
            else if (rows.checkerboard(row, i)) { clear(nyquist); }
            else if (project)
            {
                for (int c = 0; c < dimensions; ++c)
                {
                    const std::complex<double> change = (d[static_cast<std::size_t>(c)][i] * inverse[mode]) * along;
                    coefficients[c][mode] -= change;
                    projected += rows.multiplicity(i) * std::norm(change);
                }
            }
        }
    }
    // A mean at round-off is none: it would cost phase factors in every step.
    double mean2 = 0;
    for (int c = 0; c < dimensions; ++c) { mean2 += std::norm(coefficients[c][0]); }
    if (mean2 <= 1e-28 * total)
    {
        for (int c = 0; c < dimensions; ++c) { coefficients[c][0] = 0; }
    }
    const auto relative = [total](double part) { return total > 0 ? std::sqrt(part / total) : 0; };
    return {relative(projected), relative(dealiased), relative(nyquist)};
}

} // namespace isph
