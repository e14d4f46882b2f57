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
    integratingFactor,
    crankNicolson
};
const Selection<ViscousTreatment>& viscousTreatments();

/// The treatment that settings have come to; automatic where steps choose it.
ViscousTreatment viscousTreatment(const FlowSettings& settings);

const Selection<WallTreatment>& wallTreatments();

/// The text of system/schemes and of system/solution that stands for a paper, defects included.
struct Preset
{
    std::string_view schemes;
    std::string_view solution;
};
const Selection<Preset>& presets();

const Schema& schemesSchema();                ///< of system/schemes, with the defaults of a periodic box
Schema schemesSchema(const Lattice& lattice); ///< with those of this lattice: others where an axis is bounded
const Schema& solutionSchema();               ///< of system/solution

/// system/schemes with its preset and every default filled in: those of a lattice, or of a periodic box. An entry of a
/// preset has "preset <name>" as its file, a default is marked as such.
/// \throws Error(input) with all slips at once.
Dictionary completedSchemes(const Dictionary& schemes, const Lattice& lattice);
Dictionary completedSchemes(const Dictionary& schemes);

/// system/solution in the same way; the preset is the one that system/schemes names.
Dictionary completedSolution(const Dictionary& solution, const Dictionary& schemes);

/// Every choice of system/schemes and system/solution for this lattice and fluid.
/// \throws Error(input) where choices contradict each other, or the scene has no stable step at all.
FlowSettings readFlowSettings(const Dictionary& schemes, const Dictionary& solution, const Lattice& lattice,
                              const Fluid& fluid);

} // namespace isph
