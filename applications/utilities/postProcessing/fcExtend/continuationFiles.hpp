#pragma once

#include "case/Case.hpp"
#include "continuation/continuedField.hpp"
#include "continuation/smoothness.hpp"
#include "core/Log.hpp"
#include "kernels/KernelSettings.hpp"

#include <string>

namespace isph
{

/// Where the files of a field at a time go, and what they call it.
struct FieldFiles
{
    const Case& theCase;
    std::string time;
    std::string name; ///< of the component, "T" or "U.x"
    std::string unit;
};

/// Smoothness of a component of a continued field along each bounded axis, the worst of its lines: printed, and as
/// smoothness_<name>_<axis>.csv; beside it the line through the middle of the box and its spectrum.
void reportSmoothness(const FieldFiles& files, const Lattice& lattice, const Lattice& extended,
                      const Continuations& continuations, std::span<const double> continued, Log& log);

/// symbol_<axis>.csv: what the kernel does to each mode of an axis, W, and the symbols of both derivatives.
void writeSymbol(const Case& theCase, const std::string& time, const Axis& extendedAxis, const KernelSettings& kernel);

} // namespace isph
