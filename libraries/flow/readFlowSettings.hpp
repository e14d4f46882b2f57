#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"

#include <string>
#include <vector>

namespace isph
{

/// How the viscous term is marched, as the dictionary says it.
enum class ViscousTreatment
{
    automatic,
    explicitTerm,
    integratingFactor
};
const Selection<ViscousTreatment>& viscousTreatments();

/// Configurations of papers, defects included: what `preset` may name.
const Selection<std::string_view>& presets();

const Schema& schemesSchema();  ///< of system/schemes, with the defaults of a periodic box
const Schema& solutionSchema(); ///< of system/solution

/// system/schemes with its preset and every default filled in. An entry of a preset has "preset <name>" as its file, a
/// default is marked as such.
/// \throws Error(input) with all slips at once.
Dictionary completedSchemes(const Dictionary& schemes);

/// system/solution in the same way; the preset is the one that system/schemes names.
Dictionary completedSolution(const Dictionary& solution, const Dictionary& schemes);

/// Every choice of system/schemes and system/solution for this lattice and fluid.
/// \throws Error(input) where choices contradict each other, or the scene has no stable step at all.
FlowSettings readFlowSettings(const Dictionary& schemes, const Dictionary& solution, const Lattice& lattice,
                              const Fluid& fluid);

} // namespace isph
