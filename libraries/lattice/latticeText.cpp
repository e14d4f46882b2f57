#include "lattice/readLattice.hpp"

#include <array>
#include <fmt/format.h>

namespace isph
{

namespace
{

/// "(a b c)" of something of each axis; fmt writes the shortest digits that read back exactly.
template<class Function>
std::string list(const Lattice& lattice, Function function)
{
    return fmt::format("({} {} {})", function(lattice.axis(0)), function(lattice.axis(1)), function(lattice.axis(2)));
}

} // namespace

std::string latticeText(const Lattice& lattice)
{
    bool staggered = false;
    for (int d = 0; d < 3; ++d) { staggered = staggered || lattice.axis(d).staggered; }

    std::string text = "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
                       "    object      lattice;\n}\n\n"
                       "// Written by makeLattice from system/latticeDict: change that instead.\n\n";
    text += fmt::format("origin      {};\n", list(lattice, [](const Axis& axis) { return axis.origin; }));
    text += fmt::format("extent      {};\n", list(lattice, [](const Axis& axis) { return axis.extent; }));
    text += fmt::format("count       {};\n", list(lattice, [](const Axis& axis) { return axis.count; }));
    text += fmt::format("spacing     {};\n",
                        list(lattice, [](const Axis& axis) { return axis.active() ? axis.spacing() : 0.0; }));
    text += fmt::format("axes        {};\n", list(lattice, [](const Axis& axis) { return toString(axis); }));
    text += fmt::format("arrangement {};\n\n", staggered ? "staggered" : "collocated");
    text += "patches\n{\n";
    for (const Patch& patch : lattice.patches())
    {
        text += fmt::format("    {}\n    {{\n        type    {};\n        faces   ({});\n    }}\n", patch.name,
                            toString(patch.type), fmt::join(patch.faces, " "));
    }
    return text + "}\n";
}

} // namespace isph
