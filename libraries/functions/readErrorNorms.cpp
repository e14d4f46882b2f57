#include "functions/ErrorNorms.hpp"
#include "functions/readExactField.hpp"
#include "functions/readFunctions.hpp"

#include <utility>

namespace isph
{

namespace
{

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
        return readExactField(given, field, components, constants, surroundings.theCase.directory(),
                              surroundings.lattice);
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
