#include "flow/readFlowSettings.hpp"

#include "kernels/kernelSelection.hpp"

#include <array>

namespace isph
{

namespace
{

/// Gaussian 4, h/dx 2, sampled with 4h, advective, morris, RK3, explicit, no dealiasing, eigenvalues exact (Fourtakas,
/// Rogers & Nasar 2021). What the user writes beside it overrides it.
constexpr std::string_view paper2021 = R"(
kernel { type gaussian; order 4; smoothingLength 2; symbol sampled; supportRadius 4; }
convection advective;
laplacian morris;
time RK3;
viscous explicit;
meanFlow none;
dealiasing none;
)";
constexpr std::string_view paper2021Solution = "p { solver fft; eigenvalues exact; } coupling { type nonIncremental; }";
constexpr const char* presetOrigin = "preset paper2021";

bool wrote(const Dictionary& dictionary, std::string_view key)
{
    const Entry* entry = dictionary.find(key);
    return entry != nullptr && !entry->isDefault;
}

/// The dictionary laid over its preset, if it names one.
Dictionary withPreset(const Dictionary& written, std::string_view preset, const std::string& name)
{
    if (preset.empty()) { return written; }
    Dictionary merged = Dictionary::parse(preset, name);
    for (const Entry& entry : written.entries()) { merged.set(entry); }
    return merged;
}

} // namespace

const Selection<ViscousTreatment>& viscousTreatments()
{
    static constexpr std::array<Selection<ViscousTreatment>::Variant, 3> table{{
        {"auto", "integratingFactor with RK3, else explicit", ViscousTreatment::automatic},
        {"explicit", "part of the rate; limits the step", ViscousTreatment::explicitTerm},
        {"integratingFactor", "integrated exactly; limits nothing", ViscousTreatment::integratingFactor},
    }};
    static_assert(distinct(table));
    static constexpr Selection<ViscousTreatment> selection("viscous treatment", table);
    return selection;
}

const Selection<std::string_view>& presets()
{
    static constexpr std::array<Selection<std::string_view>::Variant, 1> table{{
        {"paper2021", "Fourtakas, Rogers & Nasar 2021, defects included", paper2021},
    }};
    static constexpr Selection<std::string_view> selection("preset", table);
    return selection;
}

const Schema& schemesSchema()
{
    using Type = Key::Type;
    static const Schema schema(
        "schemes",
        {{.name = "preset",
          .type = Type::word,
          .meaning = "configuration of a paper; entries override it",
          .words = presets().names()},
         kernelKey("10"),
         {.name = "operators",
          .type = Type::word,
          .fallback = "spectral",
          .meaning = "spectral | directSum (neighbour summation)",
          .words = {"spectral", "directSum"}},
         {.name = "convection",
          .type = Type::word,
          .fallback = "divergence",
          .meaning = "form of the convective term",
          .words = convectionForms().names()},
         {.name = "laplacian",
          .type = Type::word,
          .fallback = "morris",
          .meaning = "the viscous operator",
          .words = laplacians().names()},
         {.name = "time",
          .type = Type::word,
          .fallback = "RK3",
          .meaning = "time scheme",
          .words = timeSchemes().names()},
         {.name = "viscous",
          .type = Type::word,
          .fallback = "auto",
          .meaning = "how the viscous term is marched",
          .words = viscousTreatments().names()},
         {.name = "meanFlow",
          .type = Type::word,
          .fallback = "exact",
          .meaning = "exact: a uniform mean velocity is carried exactly",
          .words = {"exact", "none"}},
         {.name = "dealiasing",
          .type = Type::word,
          .fallback = "twoThirds",
          .meaning = "of quadratic products",
          .words = dealiasings().names()},
         {.name = "filter",
          .type = Type::dictionary,
          .meaning = "low-pass filter, once a step",
          .keys =
              {{.name = "type",
                .type = Type::word,
                .fallback = "none",
                .meaning = "none | exponential | cutoff",
                .words = filters().names()},
               {.name = "strength", .type = Type::number, .fallback = "36", .meaning = "exponential", .minimum = 0},
               {.name = "order", .type = Type::number, .fallback = "16", .meaning = "exponential", .positive = true},
               {.name = "fraction",
                .type = Type::number,
                .unit = "Nyquist",
                .fallback = "0.66",
                .meaning = "cutoff: highest wavenumber kept",
                .maximum = 1,
                .positive = true}}},
         {.name = "continuation", .type = Type::any, .meaning = "used on bounded axes only"},
         {.name = "walls", .type = Type::word, .meaning = "used on bounded axes only"}});
    return schema;
}

const Schema& solutionSchema()
{
    using Type = Key::Type;
    static const Schema schema(
        "solution",
        {{.name = "p",
          .type = Type::dictionary,
          .meaning = "pressure equation",
          .keys = {{.name = "solver",
                    .type = Type::word,
                    .fallback = "fft",
                    .meaning = "fft: by transforms",
                    .words = {"fft"}},
                   {.name = "eigenvalues",
                    .type = Type::word,
                    .fallback = "consistent",
                    .meaning = "which Laplacian is inverted",
                    .words = eigenvalueForms().names()},
                   {.name = "preconditioner", .type = Type::word, .meaning = "iterative solvers only"},
                   {.name = "tolerance", .type = Type::number, .meaning = "iterative solvers only", .positive = true},
                   {.name = "maxIter", .type = Type::integer, .meaning = "iterative solvers only", .minimum = 1}}},
         {.name = "coupling",
          .type = Type::dictionary,
          .meaning = "pressure in the predictor",
          .keys = {{.name = "type",
                    .type = Type::word,
                    .fallback = "nonIncremental",
                    .meaning = "incremental: the predictor knows the old pressure",
                    .words = {"nonIncremental", "incremental"}}}},
         {.name = "initialProjection",
          .type = Type::flag,
          .fallback = "yes",
          .meaning = "project the velocity that a run starts from"}});
    return schema;
}

Dictionary completedSchemes(const Dictionary& schemes)
{
    if (schemes.has("preset")) { presets()[schemes.word("preset")]; }
    return schemesSchema().complete(withPreset(schemes, schemes.has("preset") ? paper2021 : "", presetOrigin));
}

Dictionary completedSolution(const Dictionary& solution, const Dictionary& schemes)
{
    return solutionSchema().complete(
        withPreset(solution, schemes.has("preset") ? paper2021Solution : "", presetOrigin));
}

FlowSettings readFlowSettings(const Dictionary& writtenSchemes, const Dictionary& writtenSolution,
                              const Lattice& lattice, const Fluid& fluid)
{
    if (!lattice.periodic())
    {
        throw Error(Fault::input, "constant/lattice has a bounded axis, but this solver knows periodic boxes only",
                    "make every pair of faces a patch of type periodic in system/latticeDict");
    }
    const Dictionary schemes = completedSchemes(writtenSchemes);
    const Dictionary solution = completedSolution(writtenSolution, writtenSchemes);

    FlowSettings settings;
    settings.kernel = selectKernel(schemes.dictionary("kernel"));
    settings.directSum = schemes.word("operators").text == "directSum";
    settings.convection = convectionForms()[schemes.word("convection")];
    settings.laplacian = laplacians()[schemes.word("laplacian")];
    settings.time = timeSchemes()[schemes.word("time")];
    settings.eigenvalues = eigenvalueForms()[solution.dictionary("p").word("eigenvalues")];
    settings.incremental = solution.dictionary("coupling").word("type").text == "incremental";
    settings.initialProjection = solution.flag("initialProjection");

    // Neighbour summation knows nothing of modes: what acts on them is off unless it was asked for, and then refused.
    const ViscousTreatment viscous = viscousTreatments()[schemes.word("viscous")];
    const bool thirdOrder = settings.time->order == 3;
    settings.integratingFactor = viscous == ViscousTreatment::integratingFactor ||
                                 (viscous == ViscousTreatment::automatic && thirdOrder && !settings.directSum);
    const bool spectralDefault = !settings.directSum;
    settings.exactMeanFlow =
        schemes.word("meanFlow").text == "exact" && (spectralDefault || wrote(schemes, "meanFlow"));
    settings.dealiasing =
        spectralDefault || wrote(schemes, "dealiasing") ? dealiasings()[schemes.word("dealiasing")] : Dealiasing::none;
    const Dictionary& filter = schemes.dictionary("filter");
    settings.filter = {filters()[filter.word("type")], filter.number("strength"), filter.number("order"),
                       filter.number("fraction")};
    if (settings.directSum && settings.kernel.symbol != KernelSettings::Symbol::sampled)
    {
        throw schemes.error("operators", "directSum needs a kernel that is sampled",
                            "write symbol sampled; in kernel, or operators spectral;");
    }
    if (settings.directSum && settings.laplacian == LaplacianForm::exact && fluid.nu > 0)
    {
        throw schemes.error("laplacian", "exact is no sum over neighbours", "choose morris or secondDerivative");
    }
    if (settings.directSum && settings.integratingFactor)
    {
        throw schemes.error("viscous", "integratingFactor acts on modes, operators directSum has none",
                            "write viscous explicit;");
    }
    if (settings.directSum && settings.exactMeanFlow)
    {
        throw schemes.error("meanFlow", "exact acts on modes, operators directSum has none", "write meanFlow none;");
    }
    if (settings.directSum &&
        (settings.dealiasing != Dealiasing::none || settings.filter.type != FilterSettings::Type::none))
    {
        throw schemes.error(settings.dealiasing != Dealiasing::none ? "dealiasing" : "filter",
                            "acts on modes, operators directSum has none", "write none");
    }
    if (settings.time->imaginaryLimit == 0 && fluid.nu == 0 && settings.convection != ConvectionForm::none)
    {
        throw schemes.error("time", "firstOrderProjection has no stable step for an inviscid flow",
                            "its step must stay below 2 nu/|u|^2, which is 0 here: write time RK3;");
    }
    return settings;
}

} // namespace isph
