#include "functions/readProbeLocations.hpp"

#include "sampling/Interpolation.hpp"

#include <array>
#include <cstddef>
#include <fmt/format.h>

namespace isph
{

namespace
{

/// ((x y z) (x y z) ...)
Points readLocations(const Dictionary& dictionary)
{
    const std::vector<Token>& tokens = dictionary.find("probeLocations")->tokens();
    const auto isBracket = [&](std::size_t i, std::string_view bracket)
    { return tokens[i].kind == Token::Kind::bracket && tokens[i].text == bracket; };
    Points points;
    bool good = tokens.size() >= 7 && (tokens.size() - 2) % 5 == 0; // the outer brackets, and five tokens a point
    for (std::size_t first = 1; good && first + 1 < tokens.size(); first += 5)
    {
        good = isBracket(first, "(") && isBracket(first + 4, ")");
        for (std::size_t d = 0; good && d < 3; ++d)
        {
            good = tokens[first + 1 + d].kind == Token::Kind::number;
            points[d].push_back(tokens[first + 1 + d].number);
        }
    }
    if (!good)
    {
        throw dictionary.error("probeLocations", "is no list of points",
                               "write e.g. probeLocations ((0.25 0.5 0) (0.75 0.5 0));");
    }
    return points;
}

} // namespace

std::vector<Key> probeKeys(const std::string& fields, const std::string& known)
{
    using enum Key::Type;
    return {{.name = "probeLocations",
             .type = list,
             .unit = "m",
             .meaning = "points, e.g. ((0.25 0.5 0) (0.75 0.5 0))",
             .required = true},
            {.name = "fields", .type = list, .fallback = fields, .meaning = known},
            {.name = "interpolation",
             .type = word,
             .fallback = "spectral",
             .meaning = "how values between lattice points are found",
             .words = interpolations().names()}};
}

Interpolator readProbeLocations(const Dictionary& dictionary, const Lattice& lattice)
{
    const Points points = readLocations(dictionary);
    for (std::size_t d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(static_cast<int>(d));
        for (std::size_t n = 0; n < points[d].size(); ++n)
        {
            if (inside(axis, points[d][n])) { continue; }
            throw dictionary.error(
                "probeLocations", fmt::format("point {} has {} = {}, outside of the box", n, axis.name, points[d][n]),
                fmt::format("{} reaches from {} to {}", axis.name, axis.origin, axis.origin + axis.extent));
        }
    }
    return {lattice, points, interpolations()[dictionary.word("interpolation")]};
}

} // namespace isph
