#pragma once

#include "case/Case.hpp"
#include "dictionary/Schema.hpp"
#include "flow/FlowSettings.hpp"
#include "lattice/Lattice.hpp"
#include "transport/GivenVelocity.hpp"
#include "transport/ScalarBoundary.hpp"

#include <memory>
#include <string>

namespace isph
{

/// What `type` may be in the boundaryField of T.
const Selection<ScalarCondition>& scalarConditions();

/// The keys of constant/transportProperties where a scalar is carried: DT is needed, nu is not.
const Schema& scalarPropertiesSchema();

/// DT [m2/s] of constant/transportProperties.
/// \throws Error(input) if it is missing or negative.
double readDiffusivity(const Case& theCase);

/// The choices of system/schemes that transport uses, diffusion explicit; system/solution is not looked at.
/// \throws Error(input) where the scene has no stable step, or the operators are not for it.
FlowSettings readTransportSettings(const Case& theCase, const Lattice& lattice, double diffusivity);

/// The velocity that a time folder gives, as a function of time if its expressions are.
/// \throws Error(input) with file and line.
std::unique_ptr<const GivenVelocity> readGivenVelocity(const Case& theCase, const std::string& time,
                                                       const Lattice& lattice);

/// What the dictionary of T says besides its values: kept to be written with every time.
struct ScalarFile
{
    Dictionary T;
    std::string unit;    ///< by its dimensions
    bool stored = false; ///< values come from fields.h5, not from a function
};
ScalarFile readScalarFile(const Case& theCase, const std::string& time, const Lattice& lattice);

/// The conditions in the boundaryField of T.
/// \throws Error(input) with all slips at once, each with file and line.
ScalarBoundary readScalarBoundary(const Case& theCase, const Dictionary& T, const Lattice& lattice);

} // namespace isph
