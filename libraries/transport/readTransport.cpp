#include "transport/readTransport.hpp"

#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/fluidConstants.hpp"
#include "caseFields/readFieldFile.hpp"
#include "caseFields/unitOf.hpp"
#include "dictionary/SpaceTimeFunction.hpp"
#include "flow/readFlow.hpp"
#include "flow/readFlowSettings.hpp"
#include "flow/readFluid.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

/// The values of a field that does not change.
class StoredVelocity : public GivenVelocity
{
public:
    explicit StoredVelocity(RealField values) : values_(std::move(values)) {}

    void evaluate(double, RealField& U) const override
    {
        for (int d = 0; d < U.components(); ++d) { std::ranges::copy(values_[d], U[d].begin()); }
    }

    bool dependsOnTime() const override { return false; }

private:
    RealField values_;
};

class FunctionVelocity : public GivenVelocity
{
public:
    FunctionVelocity(SpaceTimeFunction function, const Lattice& lattice)
        : function_(std::move(function)), lattice_(lattice), coordinates_(lattice.coordinates())
    {
    }

    void evaluate(double t, RealField& U) const override
    {
        const auto& [x, y, z] = coordinates_;
        for (int d = 0; d < lattice_.dimensions(); ++d) { function_.evaluate(lattice_.direction(d), x, y, z, t, U[d]); }
    }

    bool dependsOnTime() const override { return true; }

private:
    SpaceTimeFunction function_;
    Lattice lattice_;
    std::array<std::vector<double>, 3> coordinates_;
};

class FunctionOnFace : public FaceFunction
{
public:
    explicit FunctionOnFace(SpaceTimeFunction function) : function_(std::move(function)) {}

    void evaluate(int component, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  double t, std::span<double> values) const override
    {
        function_.evaluate(component, x, y, z, t, values);
    }

    bool dependsOnTime() const override { return function_.dependsOnTime(); }

private:
    SpaceTimeFunction function_;
};

/// Whether the values of a field are in fields.h5.
bool isStored(const Dictionary& field)
{
    const std::vector<Token>& tokens = field.find("internalField")->tokens();
    return !tokens.empty() && tokens[0].text == "hdf5";
}

const Schema& conditionSchema()
{
    using Type = Key::Type;
    static const Schema schema(
        "scalarCondition",
        {{.name = "type",
          .type = Type::word,
          .meaning = "what the face does to the scalar",
          .required = true,
          .words = {"periodic", "fixedValue", "zeroGradient", "fixedGradient", "outflow"}},
         {.name = "value", .type = Type::function, .unit = "as T", .meaning = "of fixedValue, of x y z t"},
         {.name = "gradient",
          .type = Type::function,
          .unit = "as T, 1/m",
          .meaning = "outward derivative of fixedGradient, of x y z t"}});
    return schema;
}

ScalarFace readFace(const Case& theCase, const Dictionary& boundary, const Patch& patch)
{
    const Dictionary condition = conditionSchema().complete(boundary.dictionary(patch.name));
    const Word type = condition.word("type");
    ScalarFace face{patch.name, scalarConditions()[type], nullptr};
    if ((face.condition == ScalarCondition::periodic) != (patch.type == Patch::Type::periodic))
    {
        throw Error(Fault::input, type.origin, fmt::format("is {} but patch {} is not periodic", type.text, patch.name),
                    "write another type or change the patch in system/latticeDict");
    }
    if (face.condition == ScalarCondition::outflow && patch.type == Patch::Type::wall)
    {
        throw Error(Fault::input, type.origin, fmt::format("is outflow, but patch {} is a wall", patch.name),
                    "a wall lets nothing out: write type patch; for it in system/latticeDict, or zeroGradient here");
    }
    const char* key = type.text == "fixedValue" ? "value" : type.text == "fixedGradient" ? "gradient" : nullptr;
    if (key == nullptr) { return face; }
    if (!condition.has(key))
    {
        throw condition.error(key, fmt::format("is missing, but type {} needs it", type.text),
                              fmt::format("write e.g. {} uniform 0;", key));
    }
    face.data =
        std::make_unique<FunctionOnFace>(readFunction(condition, key, 1, fluidConstants(theCase), theCase.directory()));
    return face;
}

} // namespace

const Selection<ScalarCondition>& scalarConditions()
{
    using enum ScalarCondition;
    static constexpr std::array<Selection<ScalarCondition>::Variant, 5> table{{
        {"periodic", "what leaves through one face of an axis enters through the other", periodic},
        {"fixedValue", "prescribed by 'value': inlets, walls of known value", value},
        {"zeroGradient", "no derivative across the face", gradient},
        {"fixedGradient", "outward derivative prescribed by 'gradient'", gradient},
        {"outflow", "nothing prescribed: the scalar leaves as it comes", outflow},
    }};
    static_assert(distinct(table));
    static constexpr Selection<ScalarCondition> selection("condition of a scalar", table);
    return selection;
}

const Schema& scalarPropertiesSchema()
{
    static const Schema schema = []
    {
        std::vector<Key> keys = transportPropertiesSchema().keys();
        for (Key& key : keys)
        {
            if (key.name == "nu") { key.required = false; }
            if (key.name == "DT") { key.required = true; }
        }
        return Schema("transportProperties", std::move(keys));
    }();
    return schema;
}

double readDiffusivity(const Case& theCase)
{
    return scalarPropertiesSchema()
        .complete(theCase.dictionary("constant/transportProperties"))
        .dimensionedNumber("DT", {0, 2, -1, 0, 0, 0, 0});
}

FlowSettings readTransportSettings(const Case& theCase, const Lattice& lattice, double diffusivity)
{
    const Dictionary written = theCase.dictionary("system/schemes");
    const Dictionary schemes = completedSchemes(written, lattice);
    if (schemes.word("operators").text == "directSum")
    {
        throw schemes.error("operators", "directSum is of flows: a scalar is carried line by line",
                            "write operators spectral;");
    }
    if (schemes.word("convection").text != "none" && diffusivity == 0 &&
        timeSchemes()[schemes.word("time")]->imaginaryLimit == 0)
    {
        throw schemes.error("time", "firstOrderProjection has no stable step where nothing diffuses",
                            "its step must stay below 2 DT/|U|^2, and DT is 0: write time RK3;");
    }
    Fluid fluid;
    fluid.nu = diffusivity;
    FlowSettings settings = readFlowSettings(written, {}, lattice, fluid);
    settings.integratingFactor = false;
    settings.exactMeanFlow = false;
    settings.crankNicolson = false;
    settings.automaticViscous = false;
    return settings;
}

std::unique_ptr<const GivenVelocity> readGivenVelocity(const Case& theCase, const std::string& time,
                                                       const Lattice& lattice)
{
    const Dictionary U = readVelocityFile(theCase, time, lattice);
    RealField values = FieldsOfTime(theCase, time).read("U", lattice);
    if (isStored(U)) { return std::make_unique<StoredVelocity>(std::move(values)); }
    SpaceTimeFunction function = readFunction(U, "internalField", 3, fluidConstants(theCase), theCase.directory());
    if (!function.dependsOnTime()) { return std::make_unique<StoredVelocity>(std::move(values)); }
    return std::make_unique<FunctionVelocity>(std::move(function), lattice);
}

ScalarFile readScalarFile(const Case& theCase, const std::string& time, const Lattice& lattice)
{
    ScalarFile file{readFieldFile(theCase, time, "T", lattice), ""};
    file.unit = unitOf(file.T.dimensions("dimensions"));
    file.stored = isStored(file.T);
    return file;
}

ScalarBoundary readScalarBoundary(const Case& theCase, const Dictionary& T, const Lattice& lattice)
{
    const Dictionary& boundary = T.dictionary("boundaryField");
    std::array<std::array<ScalarFace, 2>, 3> faces;
    std::vector<Complaint> slips;
    for (const Patch& patch : lattice.patches())
    {
        try
        {
            for (const std::string& name : patch.faces)
            {
                faces[static_cast<std::size_t>(name[0] - 'x')][name.ends_with("Max") ? 1 : 0] =
                    readFace(theCase, boundary, patch);
            }
        }
        catch (const Error& error)
        {
            slips.insert(slips.end(), error.complaints().begin(), error.complaints().end());
        }
    }
    if (!slips.empty()) { throw Error(Fault::input, std::move(slips)); }
    return {lattice, std::move(faces)};
}

} // namespace isph
