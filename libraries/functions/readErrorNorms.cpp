#include "dictionary/SpaceTimeFunction.hpp"
#include "functions/ErrorNorms.hpp"
#include "functions/readFunctions.hpp"

#include <algorithm>
#include <utility>

namespace isph
{

namespace
{

/// A formula or table at the points of a lattice, found row by row: coordinates of all points would take as much memory
/// as a velocity.
class FunctionOnLattice : public ExactField
{
public:
    FunctionOnLattice(SpaceTimeFunction function, const Lattice& lattice)
        : function_(std::move(function)), lattice_(lattice)
    {
        for (int i = 0; i < lattice.axis(0).count; ++i) { x_.push_back(lattice.axis(0).coordinate(i)); }
    }

    void evaluate(int component, double t, std::span<double> values) const override
    {
        std::vector<double> y(x_.size());
        std::vector<double> z(x_.size());
        std::size_t n = 0;
        for (int iz = 0; iz < lattice_.axis(2).count; ++iz)
        {
            std::ranges::fill(z, lattice_.axis(2).coordinate(iz));
            for (int iy = 0; iy < lattice_.axis(1).count; ++iy)
            {
                std::ranges::fill(y, lattice_.axis(1).coordinate(iy));
                function_.evaluate(component, x_, y, z, t, values.subspan(n, x_.size()));
                n += x_.size();
            }
        }
    }

private:
    SpaceTimeFunction function_;
    Lattice lattice_;
    std::vector<double> x_;
};

std::vector<Key> keys()
{
    using enum Key::Type;
    return {{.name = "exact",
             .type = dictionary,
             .meaning = "the solution to compare with; a field without an entry is left out",
             .required = true,
             .keys = {{.name = "U", .type = function, .unit = "m/s", .meaning = "of x y z t, nu and rho"},
                      {.name = "p", .type = function, .unit = "as 0/p", .meaning = "of x y z t, nu and rho"}}}};
}

std::unique_ptr<FunctionObject> make(const std::string& name, const Dictionary& dictionary,
                                     const FunctionSurroundings& surroundings)
{
    const Dictionary& given = dictionary.dictionary("exact");
    std::vector<std::pair<std::string, double>> constants{{"nu", surroundings.fluid.nu}};
    if (surroundings.fluid.rho) { constants.emplace_back("rho", *surroundings.fluid.rho); }
    const auto read = [&](const char* field, int components) -> std::unique_ptr<const ExactField>
    {
        if (!given.has(field)) { return nullptr; }
        return std::make_unique<FunctionOnLattice>(
            readFunction(given, field, components, constants, surroundings.theCase.directory()), surroundings.lattice);
    };
    ExactFlow exact{read("U", 3), read("p", 1)};
    if (!exact.U && !exact.p)
    {
        throw dictionary.error("exact", "names no field to compare with",
                               "write e.g. exact { U expression (\"sin(y)*exp(-nu*t)\" \"0\" \"0\"); }");
    }
    return std::make_unique<ErrorNorms>(outputFile(name, "errors.csv", surroundings), surroundings.lattice,
                                        std::move(exact), pressureForm(surroundings));
}

} // namespace

const FunctionType errorNormsType{keys, make};

} // namespace isph
