#include "flow/readFluid.hpp"

#include "dictionary/SpaceTimeFunction.hpp"

#include <utility>
#include <vector>

namespace isph
{

namespace
{

constexpr std::array<int, 7> viscosityDimensions{0, 2, -1, 0, 0, 0, 0};
constexpr std::array<int, 7> densityDimensions{1, -3, 0, 0, 0, 0, 0};

/// A force that a dictionary gives, evaluated at the points of a lattice.
class FunctionForce : public BodyForce
{
public:
    FunctionForce(SpaceTimeFunction function, const Lattice& lattice)
        : function_(std::move(function)), lattice_(lattice)
    {
        if (!function_.isUniform()) { coordinates_ = lattice.coordinates(); }
    }

    void evaluate(double t, RealField& force) const override
    {
        const auto& [x, y, z] = coordinates_;
        for (int d = 0; d < lattice_.dimensions(); ++d)
        {
            function_.evaluate(lattice_.direction(d), x, y, z, t, force[d]);
        }
    }

    bool dependsOnTime() const override { return function_.dependsOnTime(); }

    std::optional<std::array<double, 3>> uniform() const override
    {
        if (!function_.isUniform()) { return std::nullopt; }
        std::array<double, 3> force{};
        for (int d = 0; d < lattice_.dimensions(); ++d)
        {
            force[static_cast<std::size_t>(d)] = function_(lattice_.direction(d), 0, 0, 0, 0);
        }
        return force;
    }

private:
    SpaceTimeFunction function_;
    Lattice lattice_;
    std::array<std::vector<double>, 3> coordinates_; // none where no value depends on them
};

} // namespace

const Schema& transportPropertiesSchema()
{
    using Type = Key::Type;
    static const Schema schema("transportProperties",
                               {{.name = "nu",
                                 .type = Type::dimensioned,
                                 .unit = "m2/s",
                                 .meaning = "kinematic viscosity; 0: inviscid",
                                 .required = true,
                                 .minimum = 0},
                                {.name = "rho",
                                 .type = Type::dimensioned,
                                 .unit = "kg/m3",
                                 .meaning = "density, for pressures in Pa",
                                 .positive = true},
                                {.name = "bodyForce",
                                 .type = Type::function,
                                 .unit = "m/s2",
                                 .meaning = "force per unit mass: uniform (..), expression (..) of x y z t"},
                                {.name = "DT",
                                 .type = Type::dimensioned,
                                 .unit = "m2/s",
                                 .meaning = "diffusivity of a scalar (scalarTransportFoam)",
                                 .minimum = 0},
                                {.name = "transportModel",
                                 .type = Type::word,
                                 .meaning = "OpenFOAM's; Newtonian is all there is",
                                 .words = {"Newtonian"}}});
    return schema;
}

Fluid readFluid(const Case& flowCase, const Lattice& lattice)
{
    const Dictionary dictionary =
        transportPropertiesSchema().complete(flowCase.dictionary("constant/transportProperties"));
    Fluid fluid;
    fluid.nu = dictionary.dimensionedNumber("nu", viscosityDimensions);
    std::vector<std::pair<std::string, double>> constants{{"nu", fluid.nu}};
    if (dictionary.has("rho"))
    {
        fluid.rho = dictionary.dimensionedNumber("rho", densityDimensions);
        constants.emplace_back("rho", *fluid.rho);
    }
    if (dictionary.has("bodyForce"))
    {
        fluid.bodyForce = std::make_unique<FunctionForce>(
            readFunction(dictionary, "bodyForce", 3, constants, flowCase.directory()), lattice);
    }
    return fluid;
}

} // namespace isph
