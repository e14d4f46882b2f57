#include "boundary/readBoundary.hpp"

#include "boundary/conditionSelection.hpp"
#include "dictionary/SpaceTimeFunction.hpp"
#include "fields/reductions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace isph
{

namespace
{

/// A function of a dictionary on a face.
class FunctionOnFace : public FaceFunction
{
public:
    FunctionOnFace(SpaceTimeFunction function, double factor) : function_(std::move(function)), factor_(factor) {}

    void evaluate(int component, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  double t, std::span<double> values) const override
    {
        function_.evaluate(component, x, y, z, t, values);
        if (factor_ == 1) { return; }
        for (double& value : values) { value *= factor_; }
    }

    bool dependsOnTime() const override { return function_.dependsOnTime(); }

private:
    SpaceTimeFunction function_;
    double factor_;
};

/// Runs something and keeps what it complains about.
template<class Action>
void attempt(std::vector<Complaint>& slips, const Action& action)
{
    try
    {
        action();
    }
    catch (const Error& error)
    {
        slips.insert(slips.end(), error.complaints().begin(), error.complaints().end());
    }
}

/// A slip in a pattern is told once, however many patches it stands for.
void throwIfAny(const std::vector<Complaint>& slips)
{
    std::vector<Complaint> distinct;
    for (const Complaint& slip : slips)
    {
        if (std::ranges::find(distinct, slip) == distinct.end()) { distinct.push_back(slip); }
    }
    if (!distinct.empty()) { throw Error(Fault::input, std::move(distinct)); }
}

/// The condition that a field's dictionary chooses for a patch.
template<class Condition>
struct Choice
{
    Word type;
    ConditionWord<Condition> word;
    Dictionary dictionary;
};

/// By patch; those with slips are left out.
template<class Condition>
using Choices = std::map<std::string, Choice<Condition>>;

template<class Condition>
Choice<Condition> readChoice(const Dictionary& boundary, const Patch& patch, const Schema& schema,
                             const Selection<ConditionWord<Condition>>& words)
{
    const Entry* entry = boundary.find(patch.name);
    if (entry == nullptr || !entry->isDictionary())
    {
        throw Error(Fault::input, entry == nullptr ? boundary.origin() : entry->origin(),
                    fmt::format("patch {} has no boundary condition", patch.name),
                    fmt::format("write {} {{ type ...; }}", patch.name));
    }
    Dictionary dictionary = schema.complete(entry->dictionary());
    const Word type = dictionary.word("type");
    const ConditionWord<Condition> word = words[type];
    const bool periodic = word.condition == Condition::periodic;
    if (periodic != (patch.type == Patch::Type::periodic))
    {
        throw Error(Fault::input, type.origin,
                    periodic ? fmt::format("is periodic but patch {} is not", patch.name)
                             : fmt::format("is {} but patch {} is periodic", type.text, patch.name),
                    periodic ? "write another type or change the patch in system/latticeDict"
                             : "write type periodic; or change the patch in system/latticeDict");
    }
    if (!word.key.empty() && !dictionary.has(word.key))
    {
        throw dictionary.error(word.key, fmt::format("is missing, but type {} needs it", type.text),
                               fmt::format("write e.g. {} uniform {};", word.key,
                                           std::is_same_v<Condition, VelocityCondition> ? "(1 0 0)" : "0"));
    }
    return {type, word, std::move(dictionary)};
}

/// The conditions of all patches.
template<class Condition>
Choices<Condition> readChoices(const Dictionary& field, const Lattice& lattice, const Schema& schema,
                               const Selection<ConditionWord<Condition>>& words, std::vector<Complaint>& slips)
{
    if (!field.hasDictionary("boundaryField"))
    {
        throw field.error("boundaryField", "is not a dictionary",
                          "write boundaryField { ... } with an entry for each patch");
    }
    const Dictionary& boundary = field.dictionary("boundaryField");
    Choices<Condition> choices;
    for (const Patch& patch : lattice.patches())
    {
        attempt(slips, [&] { choices.emplace(patch.name, readChoice(boundary, patch, schema, words)); });
    }
    return choices;
}

Choices<VelocityCondition> velocityChoices(const Dictionary& U, const Lattice& lattice, std::vector<Complaint>& slips)
{
    auto choices = readChoices(U, lattice, velocityConditionSchema(), velocityConditions(), slips);
    for (const Patch& patch : lattice.patches())
    {
        const auto choice = choices.find(patch.name);
        if (choice == choices.end() || patch.type != Patch::Type::wall ||
            choice->second.word.condition != VelocityCondition::outflow)
        {
            continue;
        }
        slips.push_back({choice->second.type.origin, fmt::format("is outflow, but patch {} is a wall", patch.name),
                         "a wall lets nothing out: write type patch; for it in system/latticeDict"});
    }
    return choices;
}

Choices<PressureCondition> pressureChoices(const Dictionary& p, const Lattice& lattice, std::vector<Complaint>& slips)
{
    return readChoices(p, lattice, pressureConditionSchema(), pressureConditions(), slips);
}

/// Reads the conditions of both fields together and asks whether they make a flow.
class BoundaryReader
{
public:
    BoundaryReader(const Dictionary& U, const Dictionary& p, const Lattice& lattice, const BoundaryContext& context)
        : lattice_(lattice), context_(context), origin_(U.dictionary("boundaryField").origin())
    {
        attempt(slips_, [&] { velocity_ = velocityChoices(U, lattice, slips_); });
        attempt(slips_, [&] { pressure_ = pressureChoices(p, lattice, slips_); });
        for (const Patch& patch : lattice.patches())
        {
            if (velocity_.contains(patch.name) && pressure_.contains(patch.name)) { checkPair(patch.name); }
        }
        throwIfAny(slips_);
    }

    FlowBoundary read()
    {
        std::array<std::array<FaceCondition, 2>, 3> faces;
        for (const Patch& patch : lattice_.patches())
        {
            for (const std::string& face : patch.faces)
            {
                attempt(slips_,
                        [&] {
                            faces[static_cast<std::size_t>(face[0] - 'x')][face.ends_with("Max") ? 1 : 0] =
                                readFace(patch.name);
                        });
            }
        }
        throwIfAny(slips_);

        FlowBoundary boundary(lattice_, std::move(faces));
        update(boundary);
        checkLeftOutComponents(boundary);
        checkContradiction(boundary);
        checkFlux(boundary);
        throwIfAny(slips_);
        return boundary;
    }

private:
    void checkPair(const std::string& patch);
    FaceCondition readFace(const std::string& patch) const;
    void update(FlowBoundary& boundary) const;
    void checkLeftOutComponents(const FlowBoundary& boundary);
    void checkContradiction(const FlowBoundary& boundary);
    void checkFlux(const FlowBoundary& boundary);

    /// Where the velocity of a patch is prescribed.
    Origin velocityOrigin(const std::string& patch) const
    {
        const Choice<VelocityCondition>& choice = velocity_.at(patch);
        return choice.word.key.empty() ? choice.type.origin : choice.dictionary.find(choice.word.key)->origin();
    }

    const Lattice& lattice_;
    const BoundaryContext& context_;
    Origin origin_;
    Choices<VelocityCondition> velocity_;
    Choices<PressureCondition> pressure_;
    std::vector<Complaint> slips_;
};

void BoundaryReader::checkPair(const std::string& patch)
{
    const Choice<VelocityCondition>& U = velocity_.at(patch);
    const Choice<PressureCondition>& p = pressure_.at(patch);
    if (U.word.condition == VelocityCondition::periodic) { return; }
    const bool outflow = U.word.condition == VelocityCondition::outflow;
    const bool fixed = p.word.condition == PressureCondition::value;
    if (outflow && !fixed)
    {
        slips_.push_back({p.type.origin,
                          fmt::format("is {}, but U of patch {} is outflow: nothing holds the pressure that drives the "
                                      "flow out",
                                      p.type.text, patch),
                          "write type fixedValue; value uniform 0;"});
    }
    if (!outflow && fixed)
    {
        slips_.push_back({p.type.origin,
                          fmt::format("is {}, but U of patch {} is {}: velocity and pressure cannot both be prescribed",
                                      p.type.text, patch, U.type.text),
                          "write type zeroGradient; or make the patch an outlet: U outflow"});
    }
}

FaceCondition BoundaryReader::readFace(const std::string& patch) const
{
    const Choice<VelocityCondition>& U = velocity_.at(patch);
    const Choice<PressureCondition>& p = pressure_.at(patch);
    const auto function = [this](const Dictionary& dictionary, std::string_view key, int components, double factor)
    {
        std::unique_ptr<const FaceFunction> result;
        if (!key.empty())
        {
            result = std::make_unique<FunctionOnFace>(
                readFunction(dictionary, key, components, context_.constants, context_.folder), factor);
        }
        return result;
    };
    return {patch, U.word.condition, p.word.condition, function(U.dictionary, U.word.key, 3, 1),
            function(p.dictionary, p.word.key, 1, 1 / context_.pressureScale)};
}

void BoundaryReader::update(FlowBoundary& boundary) const
{
    try
    {
        boundary.update(context_.time);
    }
    catch (const Error& error)
    {
        std::vector<Complaint> complaints = error.complaints();
        for (Complaint& complaint : complaints)
        {
            if (complaint.origin.file.empty()) { complaint.origin = origin_; }
        }
        throw Error(error.fault(), std::move(complaints));
    }
}

void BoundaryReader::checkLeftOutComponents(const FlowBoundary& boundary)
{
    std::vector<std::string> told;
    for (int leftOut = 0; leftOut < 3; ++leftOut)
    {
        if (lattice_.axis(leftOut).active()) { continue; }
        for (int d = 0; d < lattice_.dimensions(); ++d)
        {
            for (const Side side : {Side::low, Side::high})
            {
                const FaceCondition& face = boundary.face(lattice_.direction(d), side);
                if (!face.U || std::ranges::find(told, face.patch) != told.end()) { continue; }
                const auto [x, y, z] = boundary.coordinates(lattice_.direction(d), side);
                std::vector<double> values(x.size());
                face.U->evaluate(leftOut, x, y, z, context_.time, values);
                if (largestMagnitude(values) == 0) { continue; }
                told.push_back(face.patch);
                const char name = lattice_.axis(leftOut).name;
                slips_.push_back({velocityOrigin(face.patch),
                                  fmt::format("has a component along {}, an axis that the lattice leaves out", name),
                                  fmt::format("write 0 there, or give axis {} an extent in system/latticeDict", name)});
            }
        }
    }
}

void BoundaryReader::checkContradiction(const FlowBoundary& boundary)
{
    const auto found = boundary.contradiction();
    if (!found) { return; }
    const auto text = [](const std::array<double, 3>& v) { return fmt::format("({:g} {:g} {:g})", v[0], v[1], v[2]); };
    slips_.push_back(
        {velocityOrigin(found->patches[0]),
         fmt::format("contradicts patch {} at their common point {}: {} here, {} m/s there", found->patches[1],
                     text(found->point), text(found->velocities[0]), text(found->velocities[1])),
         "where faces meet, their velocities must agree or all but one vanish"});
}

void BoundaryReader::checkFlux(const FlowBoundary& boundary)
{
    for (const auto& [patch, choice] : velocity_)
    {
        if (choice.word.condition == VelocityCondition::outflow) { return; }
    }
    const FlowBoundary::Flux plain = boundary.flux();
    const FlowBoundary::Flux flux = boundary.flux(FlowBoundary::Quadrature::endCorrected);
    const double net = flux.in - flux.out;
    // What two quadratures disagree about, the lattice cannot tell.
    const double unknown = std::abs(net - (plain.in - plain.out));
    if (std::abs(net) <= 1e-6 * std::max(flux.in, flux.out) + unknown) { return; }
    const std::string_view unit = lattice_.dimensions() == 2 ? "m2/s" : "m3/s";
    slips_.push_back(
        {origin_,
         fmt::format("prescribes {:.7g} {} of inflow but {:.7g} {} of outflow, and no patch is an outlet", flux.in,
                     unit, flux.out, unit),
         "what enters an incompressible flow must leave: make a patch an outlet (U outflow, p fixedValue), "
         "or let both agree"});
}

} // namespace

void checkVelocityConditions(const Dictionary& U, const Lattice& lattice)
{
    std::vector<Complaint> slips;
    velocityChoices(U, lattice, slips);
    throwIfAny(slips);
}

void checkPressureConditions(const Dictionary& p, const Lattice& lattice)
{
    std::vector<Complaint> slips;
    pressureChoices(p, lattice, slips);
    throwIfAny(slips);
}

FlowBoundary readBoundary(const Dictionary& U, const Dictionary& p, const Lattice& lattice,
                          const BoundaryContext& context)
{
    return BoundaryReader(U, p, lattice, context).read();
}

} // namespace isph
