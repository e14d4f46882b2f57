#pragma once

#include "functions/CsvOutput.hpp"
#include "functions/FunctionObject.hpp"
#include "functions/PressureForm.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace isph
{

/// A field that is known exactly at the points of a lattice, at any time.
class ExactField
{
public:
    virtual ~ExactField() = default;

    /// Fills the values of a component (0 of a scalar; 0, 1, 2 of a vector, whatever axes are active).
    virtual void evaluate(int component, double t, std::span<double> values) const = 0;
};

/// What a flow is compared with; a field that is null is left out.
struct ExactFlow
{
    std::unique_ptr<const ExactField> U; ///< [m/s]
    std::unique_ptr<const ExactField> p; ///< in the unit of the pressure that is written
};

/// Norms of an error field.
struct FieldNorms
{
    double L1;    ///< mean over the points
    double L2;    ///< root mean square
    double Linf;  ///< largest
    double relL2; ///< L2 over the exact field's; L2 itself where the exact field vanishes
};

/// errors.csv: norms of the difference to an exact solution, over the points of the lattice.
///
/// The error of a velocity is the magnitude of the difference, what the exact one has along an axis left out included.
/// Pressures are compared, and the exact one measured, after taking out both means, unless the pressure is fixed
/// somewhere.
class ErrorNorms : public FunctionObject
{
public:
    ErrorNorms(std::filesystem::path file, const Lattice& lattice, ExactFlow exact, PressureForm pressure);

    void execute(const FlowAtTime& now) override;
    std::vector<ErrorNorm> errors() const override;

private:
    FieldNorms velocityNorms(const RealField& velocity, double t);
    FieldNorms pressureNorms(const RealField& pressure, double t);
    FieldNorms normsOfError(double exactL2) const;

    Lattice lattice_;
    ExactFlow exact_;
    PressureForm pressure_;
    CsvOutput csv_;
    RealField exactValues_; ///< scratch, from the first execution on
    RealField error_;       ///< magnitudes of the error
    std::vector<ErrorNorm> last_;
};

} // namespace isph
