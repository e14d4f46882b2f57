#include "functions/flowListings.hpp"

#include "boundary/conditionSelection.hpp"
#include "continuation/continuationSelection.hpp"
#include "flow/readFlowSettings.hpp"
#include "functions/functionSelection.hpp"
#include "kernels/kernelSelection.hpp"

namespace isph
{

std::vector<Listing> flowListings()
{
    return {{"listKernels", [] { return kernels().words(); }},
            {"listConvections", [] { return convectionForms().words(); }},
            {"listLaplacians", [] { return laplacians().words(); }},
            {"listTimeSchemes", [] { return timeSchemes().words(); }},
            {"listContinuations", [] { return continuations().words(); }},
            {"listWallTreatments", [] { return wallTreatments().words(); }},
            {"listViscousTreatments", [] { return viscousTreatments().words(); }},
            {"listDealiasings", [] { return dealiasings().words(); }},
            {"listFilters", [] { return filters().words(); }},
            {"listEigenvalues", [] { return eigenvalueForms().words(); }},
            {"listPressureSolvers", [] { return pressureSolvers().words(); }},
            {"listPreconditioners", [] { return preconditioners().words(); }},
            {"listVelocityConditions", [] { return velocityConditions().words(); }},
            {"listPressureConditions", [] { return pressureConditions().words(); }},
            {"listPresets", [] { return presets().words(); }},
            {"listFunctions", [] { return functionTypes(); }}};
}

} // namespace isph
