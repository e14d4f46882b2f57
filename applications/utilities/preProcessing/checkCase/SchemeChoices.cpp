#include "SchemeChoices.hpp"

#include "caseFields/unitOf.hpp"
#include "continuation/continuationSelection.hpp"
#include "flow/readFlowSettings.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace isph
{

namespace
{

std::string placeOf(const Entry& entry)
{
    if (entry.isDefault) { return "default"; }
    const Origin& origin = entry.origin();
    return origin.file.starts_with("preset ") ? origin.file : fmt::format("{}:{}", origin.file, origin.line);
}

/// Goes through the keys of a dictionary: each either acts, or is idle for a reason.
class Sorter
{
public:
    Sorter(std::vector<Choice>& choices, std::vector<Idle>& idle) : choices_(choices), idle_(idle) {}

    /// \param value what the key came to; empty: as written
    /// \param why it has no effect; empty: it has
    void sort(const Dictionary& dictionary, std::string_view key, const std::string& value, const std::string& why = "",
              const std::string& unit = "")
    {
        const Entry* entry = dictionary.find(key);
        if (entry == nullptr) { return; }
        if (why.empty())
        {
            choices_.push_back({.key = dictionary.scopedName(key),
                                .value = value.empty() ? shownValue(*entry) : value,
                                .unit = unit,
                                .from = placeOf(*entry),
                                .isDefault = entry->isDefault});
        }
        else { idle(dictionary, key, why); }
    }

    /// Notes a key that has no effect where a user has written it.
    void idle(const Dictionary& dictionary, std::string_view key, const std::string& why)
    {
        const Entry* entry = dictionary.find(key);
        const bool written = entry != nullptr && !entry->isDefault && entry->origin().line > 0 &&
                             !entry->origin().file.starts_with("preset ") && !entry->usedByMacro;
        if (!written) { return; }
        Origin origin = entry->origin();
        origin.entry = dictionary.scopedName(key);
        idle_.push_back({std::move(origin), why});
    }

private:
    std::vector<Choice>& choices_;
    std::vector<Idle>& idle_;
};

void sortKernel(const Dictionary& kernel, const KernelSettings& settings, Sorter& sorter)
{
    const bool sampled = settings.symbol == KernelSettings::Symbol::sampled;
    const bool spline = !settings.exact() && !settings.kernel->closed();
    const std::string exact = settings.exact() ? "the exact derivative has no kernel" : "";
    const std::string notSampled = !exact.empty() ? exact : sampled ? "" : "only sampled kernels are cut off";
    sorter.sort(kernel, "type", "");
    sorter.sort(kernel, "order", "", spline ? "the quintic spline has order 2" : exact);
    sorter.sort(kernel, "smoothingLength", fmt::format("{}", settings.smoothingLength), exact, "dx");
    const bool overruled = spline && kernel.word("symbol").text == "closed" && !kernel.find("symbol")->isDefault;
    sorter.sort(kernel, "symbol", sampled ? "sampled" : "closed",
                overruled ? "the quintic spline is always sampled" : exact);
    sorter.sort(kernel, "supportRadius", fmt::format("{}", settings.supportRadius), notSampled, "h");
    sorter.sort(kernel, "renormalise", "", notSampled);
}

void sortFilter(const Dictionary& filter, const FilterSettings& settings, Sorter& sorter)
{
    const auto belongsTo = [&settings](FilterSettings::Type type) {
        return settings.type == type ? std::string() : fmt::format("the filter is {}", filters().nameOf(settings.type));
    };
    sorter.sort(filter, "type", "");
    sorter.sort(filter, "strength", "", belongsTo(FilterSettings::Type::exponential));
    sorter.sort(filter, "order", "", belongsTo(FilterSettings::Type::exponential));
    sorter.sort(filter, "fraction", "", belongsTo(FilterSettings::Type::cutoff));
}

bool isAuto(const Dictionary& dictionary, std::string_view key)
{
    return dictionary.find(key)->tokens().front().kind != Token::Kind::number;
}

/// "25" or, where bounded axes differ, "25 along x, 31 along y".
std::string byAxis(const Lattice& lattice, const Continuations& continuations, int (*number)(const Continuation&))
{
    std::vector<int> numbers;
    std::string text;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const auto& continuation = continuations[static_cast<std::size_t>(lattice.direction(d))];
        if (!continuation) { continue; }
        numbers.push_back(number(*continuation));
        text += fmt::format("{}{} along {}", text.empty() ? "" : ", ", numbers.back(), lattice.activeAxis(d).name);
    }
    const bool alike = std::ranges::all_of(numbers, [&](int value) { return value == numbers.front(); });
    return alike ? std::to_string(numbers.front()) : text;
}

void sortContinuation(const Dictionary& continuation, const Lattice& lattice, const Continuations& made, Sorter& sorter)
{
    const std::string type = continuation.word("type").text;
    const bool mirror = type == "mirror";
    const bool gram = type == "gram";
    const bool polynomial = type == "polynomial";
    sorter.sort(continuation, "type", "");
    sorter.sort(continuation, "degree",
                isAuto(continuation, "degree") ? std::to_string(automaticDegree(type)) : std::string(),
                mirror ? "mirror has no polynomial" : "");
    sorter.sort(continuation, "smoothness",
                isAuto(continuation, "smoothness") ? std::to_string(automaticSmoothness(type)) : std::string(),
                gram ? "gram is not blended" : "");
    sorter.sort(continuation, "extension", byAxis(lattice, made, [](const Continuation& of) { return of.newPoints(); }),
                "", "points");
    sorter.sort(continuation, "points", byAxis(lattice, made, [](const Continuation& of) { return of.points(); }),
                polynomial ? "" : "only polynomial fits more points than its degree needs");
    sorter.sort(continuation, "extended", "");
}

/// Besides the kernel.
void sortScalarSchemes(const Dictionary& schemes, const CaseReading& reading, Sorter& sorter)
{
    const FlowSettings& settings = *reading.settings;
    const bool convects = settings.convection != ConvectionForm::none;
    const std::string still = reading.fluid->nu > 0 ? "" : "DT is 0: nothing diffuses";
    sorter.sort(schemes, "convection", convects ? "advective" : "none");
    sorter.sort(schemes, "laplacian", "", still);
    sorter.sort(schemes, "time", "");
    sorter.sort(schemes, "viscous", "explicit", still);
    sorter.sort(schemes, "dealiasing", std::string(dealiasings().nameOf(settings.dealiasing)));
    sortFilter(schemes.dictionary("filter"), settings.filter, sorter);
    for (const char* key : {"meanFlow", "walls"}) { sorter.idle(schemes, key, "it is about flows, and U is given"); }
    if (!reading.lattice->periodic())
    {
        sortContinuation(schemes.dictionary("continuation"), *reading.lattice, settings.continuations, sorter);
    }
    else { sorter.idle(schemes, "continuation", "every axis is periodic"); }
}

void sortSchemes(const Dictionary& schemes, const CaseReading& reading, Sorter& sorter)
{
    const FlowSettings& settings = *reading.settings;
    const bool convects = settings.convection != ConvectionForm::none;
    const bool bounded = !reading.lattice->periodic();
    const std::string inviscid = reading.fluid->nu > 0 ? "" : "nu is 0: there is no viscous term";
    sorter.sort(schemes, "preset", "");
    sortKernel(schemes.dictionary("kernel"), settings.kernel, sorter);
    if (reading.scalar)
    {
        sortScalarSchemes(schemes, reading, sorter);
        return;
    }
    sorter.sort(schemes, "operators", "");
    sorter.sort(schemes, "convection", "");
    sorter.sort(schemes, "laplacian", "", inviscid);
    sorter.sort(schemes, "time", "");
    sorter.sort(schemes, "viscous", std::string(viscousTreatments().nameOf(viscousTreatment(settings))), inviscid);
    sorter.sort(schemes, "meanFlow", settings.exactMeanFlow ? "exact" : "none", convects ? "" : "nothing is convected");
    sorter.sort(schemes, "dealiasing", std::string(dealiasings().nameOf(settings.dealiasing)));
    sortFilter(schemes.dictionary("filter"), settings.filter, sorter);
    if (bounded)
    {
        sortContinuation(schemes.dictionary("continuation"), *reading.lattice, settings.continuations, sorter);
        sorter.sort(schemes, "walls", "");
        return;
    }
    for (const char* key : {"continuation", "walls"}) { sorter.idle(schemes, key, "every axis is periodic"); }
}

void sortSolution(const Dictionary& solution, const CaseReading& reading, Sorter& sorter)
{
    const bool restart = reading.start && reading.start->restart;
    const bool bounded = !reading.lattice->periodic();
    const bool direct = reading.settings->directPressure;
    const Dictionary& p = solution.dictionary("p");
    sorter.sort(p, "solver", "");
    const bool iterates = reading.settings->iteration.has_value();
    const std::string solver = p.word("solver").text;
    const std::string ownEigenvalues = direct || iterates ? fmt::format("the solver {} has its own", solver) : "";
    const bool morris = reading.settings->eigenvalues == Eigenvalues::morris && iterates;
    sorter.sort(p, "eigenvalues", "", morris && p.word("eigenvalues").text == "morris" ? "" : ownEigenvalues);
    const std::string idle = iterates ? "" : fmt::format("the solver {} does not iterate", solver);
    for (const char* key : {"preconditioner", "tolerance", "maxIter"}) { sorter.sort(p, key, "", idle); }
    sorter.sort(solution.dictionary("coupling"), "type", "", bounded ? "between walls the word walls decides" : "");
    sorter.sort(solution, "initialProjection", "", restart ? "a run that goes on is not projected again" : "");
}

void sortFunctions(const Dictionary& functions, Sorter& sorter)
{
    for (const Entry& entry : functions.entries())
    {
        if (!entry.isDictionary()) { continue; }
        const Dictionary& function = entry.dictionary();
        if (function.has("enabled") && !function.flag("enabled"))
        {
            sorter.idle(functions, entry.keyword(), "it is switched off (enabled no)");
            continue;
        }
        sorter.idle(function, "libs", "every function is part of the solver");
    }
}

void sortControlDict(const Dictionary& control, const TimeSettings& settings, bool explicitViscosity, Sorter& sorter)
{
    const bool automatic = !settings.deltaT;
    if (settings.startFrom != StartFrom::startTime)
    {
        sorter.idle(control, "startTime", "startFrom does not ask for it");
    }
    if (automatic) { sorter.idle(control, "adjustTimeStep", "deltaT auto changes the step anyway"); }
    else { sorter.idle(control, "safetyFactor", "only deltaT auto has use for it"); }
    const std::string limit = !automatic && !settings.adjustTimeStep
                                  ? "the step is fixed: write adjustTimeStep yes; or deltaT auto; to limit it"
                                  : "";
    for (const char* key : {"maxCo", "maxDeltaT", "maxViscousNumber"})
    {
        if (!limit.empty()) { sorter.idle(control, key, limit); }
    }
    if (limit.empty() && !explicitViscosity)
    {
        sorter.idle(control, "maxViscousNumber", "no viscous term is explicit");
    }
    for (const char* key : {"writeFormat", "writePrecision", "writeCompression"})
    {
        sorter.idle(control, key, "fields are written exactly, as HDF5");
    }
    if (control.hasDictionary("functions")) { sortFunctions(control.dictionary("functions"), sorter); }
}

/// Whether an expression inside of a dictionary names a constant.
bool uses(const Dictionary& dictionary, std::string_view name)
{
    const auto isNameCharacter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const auto mentions = [&](const Token& token)
    {
        if (token.kind != Token::Kind::string) { return false; }
        const std::string& text = token.text;
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
        {
            const std::size_t end = at + name.size();
            const bool begins = at == 0 || !isNameCharacter(text[at - 1]);
            if (begins && (end == text.size() || !isNameCharacter(text[end]))) { return true; }
        }
        return false;
    };
    return std::ranges::any_of(dictionary.entries(),
                               [&](const Entry& entry) {
                                   return entry.isDictionary() ? uses(entry.dictionary(), name)
                                                               : std::ranges::any_of(entry.tokens(), mentions);
                               });
}

void sortTransport(const CaseReading& reading, Sorter& sorter)
{
    const Dictionary& transport = *reading.transportProperties;
    sorter.idle(transport, "DT", "isphFoam carries no scalar");
    const bool kinematic = reading.p && unitOf(reading.p->dimensions("dimensions")) != "Pa";
    const bool used = !kinematic || !reading.U || uses(*reading.U, "rho") || uses(*reading.p, "rho") ||
                      uses(transport, "rho") || !reading.controlDict || uses(*reading.controlDict, "rho");
    if (!used) { sorter.idle(transport, "rho", "the pressure is kinematic, and no expression uses it"); }
}

} // namespace

SchemeChoices schemeChoices(const CaseReading& reading)
{
    SchemeChoices choices;
    std::vector<Choice> unlisted;
    if (reading.settings)
    {
        Sorter ofSchemes(choices.schemes, choices.idle);
        sortSchemes(*reading.schemes, reading, ofSchemes);
        Sorter ofSolution(choices.solution, choices.idle);
        if (reading.solution) { sortSolution(*reading.solution, reading, ofSolution); }
    }
    Sorter others(unlisted, choices.idle);
    if (reading.control && reading.settings)
    {
        const bool explicitViscosity =
            reading.fluid->nu > 0 && !reading.settings->integratingFactor && !reading.settings->crankNicolson;
        sortControlDict(*reading.controlDict, reading.control->settings(), explicitViscosity, others);
    }
    if (reading.transportProperties) { sortTransport(reading, others); }
    return choices;
}

} // namespace isph
