#include "continuation/continuationSelection.hpp"
#include "flow/readFlowSettings.hpp"
#include "kernels/kernelSelection.hpp"

#include <algorithm>
#include <array>

namespace isph
{

namespace
{

/// Gaussian 4, h/dx 2, sampled with 4h, advective, morris, RK3, explicit, no dealiasing, eigenvalues exact; between
/// walls mirror particles (Fourtakas, Rogers & Nasar 2021).
constexpr std::string_view paper2021 = R"(
kernel { type gaussian; order 4; smoothingLength 2; symbol sampled; supportRadius 4; }
convection advective;
laplacian morris;
time RK3;
viscous explicit;
meanFlow none;
dealiasing none;
continuation { type mirror; }
walls paper;
)";

/// The same kernel; between walls polynomials of degree 5, blended by the quintic over a quarter of the interval (Lin,
/// Fourtakas & Rogers 2026).
constexpr std::string_view paper2026 = R"(
kernel { type gaussian; order 4; smoothingLength 2; symbol sampled; supportRadius 4; }
convection advective;
laplacian secondDerivative;
time RK3;
viscous explicit;
meanFlow none;
dealiasing none;
continuation { type polynomial; degree 5; smoothness 2; extension 0.25; }
walls paper;
)";

constexpr std::string_view solutionOfPapers = "p { solver fft; eigenvalues exact; } coupling { type nonIncremental; }";

/// What the kind of lattice decides.
struct Defaults
{
    std::string order = "10";
    std::string convection = "divergence";
    std::string laplacian = "morris";
    std::string meanFlow = "exact";
    std::string dealiasing = "twoThirds";
    std::string continuation = "smoothGram";
    std::string walls = "consistent";
};

Defaults defaultsOf(const Lattice& lattice)
{
    if (lattice.periodic()) { return {}; }
    Defaults defaults{.order = "20",
                      .convection = "advective",
                      .laplacian = "secondDerivative",
                      .meanFlow = "none",
                      .dealiasing = "none"};
    if (lattice.staggered())
    {
        defaults.continuation = "mirror";
        defaults.walls = "paper";
    }
    return defaults;
}

Key filterKey()
{
    using Type = Key::Type;
    Key key{.name = "filter", .type = Type::dictionary, .meaning = "low-pass filter, once a step"};
    key.keys = {
        {.name = "type",
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
         .positive = true},
    };
    return key;
}

Key continuationKey(const std::string& type)
{
    Key key = isph::continuationKey();
    std::ranges::find(key.keys, "type", &Key::name)->fallback = type;
    return key;
}

Schema schemesSchema(const Defaults& defaults)
{
    using Type = Key::Type;
    return {"schemes",
            {{.name = "preset",
              .type = Type::word,
              .meaning = "configuration of a paper; entries override it",
              .words = presets().names()},
             kernelKey(defaults.order),
             {.name = "operators",
              .type = Type::word,
              .fallback = "spectral",
              .meaning = "spectral | directSum (neighbour summation)",
              .words = {"spectral", "directSum"}},
             {.name = "convection",
              .type = Type::word,
              .fallback = defaults.convection,
              .meaning = "form of the convective term",
              .words = convectionForms().names()},
             {.name = "laplacian",
              .type = Type::word,
              .fallback = defaults.laplacian,
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
              .fallback = defaults.meanFlow,
              .meaning = "exact: a uniform mean velocity is carried exactly",
              .words = {"exact", "none"}},
             {.name = "dealiasing",
              .type = Type::word,
              .fallback = defaults.dealiasing,
              .meaning = "of quadratic products",
              .words = dealiasings().names()},
             filterKey(),
             continuationKey(defaults.continuation),
             {.name = "walls",
              .type = Type::word,
              .fallback = defaults.walls,
              .meaning = "bounded axes: how a step meets the conditions at walls",
              .words = wallTreatments().names()}}};
}

/// The dictionary laid over its preset, if it names one.
Dictionary withPreset(const Dictionary& written, const Dictionary& schemes, std::string_view Preset::*part)
{
    if (!schemes.has("preset")) { return written; }
    const Word name = schemes.word("preset");
    Dictionary merged = Dictionary::parse(presets()[name].*part, "preset " + name.text);
    for (const Entry& entry : written.entries()) { merged.set(entry); }
    return merged;
}

} // namespace

const Selection<ViscousTreatment>& viscousTreatments()
{
    static constexpr std::array<Selection<ViscousTreatment>::Variant, 4> table{{
        {"auto", "periodic: integratingFactor with RK3, else explicit; bounded: the one with the larger stable step",
         ViscousTreatment::automatic},
        {"explicit", "part of the rate; limits the step", ViscousTreatment::explicitTerm},
        {"integratingFactor", "periodic boxes: integrated exactly; limits nothing",
         ViscousTreatment::integratingFactor},
        {"CrankNicolson", "bounded axes: implicit, second order; limits nothing", ViscousTreatment::crankNicolson},
    }};
    static_assert(distinct(table));
    static constexpr Selection<ViscousTreatment> selection("viscous treatment", table);
    return selection;
}

const Selection<WallTreatment>& wallTreatments()
{
    static constexpr std::array<Selection<WallTreatment>::Variant, 6> table{{
        {"consistent", "the step also moves wall points; the pressure's slope restores the normal velocity",
         WallTreatment::consistent},
        {"paper", "walls reset before the projection, dp/dn = 0 (Lin, Fourtakas & Rogers 2026)", WallTreatment::paper},
        {"incremental", "the predictor knows the old pressure, whose change has no slope", WallTreatment::incremental},
        {"rotational", "the same, the pressure without nu div(U) (Guermond, Minev & Shen 2006)",
         WallTreatment::rotational},
        {"slip", "tangential wall velocity preset with the old pressure (Fontana et al. 2020)", WallTreatment::slip},
        {"pressurePoisson", "pressure from the momentum equation (Johnston & Liu 2004)",
         WallTreatment::pressurePoisson},
    }};
    static_assert(distinct(table));
    static constexpr Selection<WallTreatment> selection("wall treatment", table);
    return selection;
}

const Selection<Preset>& presets()
{
    static constexpr std::array<Selection<Preset>::Variant, 2> table{{
        {"paper2021", "Fourtakas, Rogers & Nasar 2021, defects included", {paper2021, solutionOfPapers}},
        {"paper2026", "Lin, Fourtakas & Rogers 2026, defects included", {paper2026, solutionOfPapers}},
    }};
    static_assert(distinct(table));
    static constexpr Selection<Preset> selection("preset", table);
    return selection;
}

const Schema& schemesSchema()
{
    static const Schema schema = schemesSchema(Defaults());
    return schema;
}

Schema schemesSchema(const Lattice& lattice) { return schemesSchema(defaultsOf(lattice)); }

const Schema& solutionSchema()
{
    using Type = Key::Type;
    static const Schema schema(
        "solution", {{.name = "p",
                      .type = Type::dictionary,
                      .meaning = "pressure equation",
                      .keys = {{.name = "solver",
                                .type = Type::word,
                                .fallback = "fft",
                                .meaning = "by transforms, or by the matrix of classical ISPH for comparison",
                                .words = pressureSolvers().names()},
                               {.name = "eigenvalues",
                                .type = Type::word,
                                .fallback = "consistent",
                                .meaning = "which Laplacian is inverted",
                                .words = eigenvalueForms().names()},
                               {.name = "preconditioner",
                                .type = Type::word,
                                .fallback = "jacobi",
                                .meaning = "iterative solvers",
                                .words = preconditioners().names()},
                               {.name = "tolerance",
                                .type = Type::number,
                                .fallback = "1e-10",
                                .meaning = "iterative solvers: of the residual, relative to the source",
                                .maximum = 1,
                                .positive = true},
                               {.name = "maxIter",
                                .type = Type::integer,
                                .fallback = "1000",
                                .meaning = "iterative solvers: a solve stops there",
                                .minimum = 1}}},
                     {.name = "coupling",
                      .type = Type::dictionary,
                      .meaning = "pressure in the predictor of periodic boxes",
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

Dictionary completedSchemes(const Dictionary& schemes, const Lattice& lattice)
{
    return schemesSchema(lattice).complete(withPreset(schemes, schemes, &Preset::schemes));
}

Dictionary completedSchemes(const Dictionary& schemes)
{
    return schemesSchema().complete(withPreset(schemes, schemes, &Preset::schemes));
}

Dictionary completedSolution(const Dictionary& solution, const Dictionary& schemes)
{
    return solutionSchema().complete(withPreset(solution, schemes, &Preset::solution));
}

} // namespace isph
