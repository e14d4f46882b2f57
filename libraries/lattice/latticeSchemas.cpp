#include "lattice/readLattice.hpp"

namespace isph
{

namespace
{

Key originKey(bool required)
{
    Key key{.name = "origin", .type = Key::Type::vector, .unit = "m", .meaning = "lower corner of the box"};
    key.required = required;
    if (!required) { key.fallback = "(0 0 0)"; }
    return key;
}

Key extentKey()
{
    return {.name = "extent",
            .type = Key::Type::vector,
            .unit = "m",
            .meaning = "size of the box; an axis with extent 0 and count 1 is left out of the problem",
            .required = true};
}

Key arrangementKey(bool required)
{
    Key key{.name = "arrangement",
            .type = Key::Type::word,
            .meaning = "bounded axes: points on both ends, or half a spacing inside",
            .words = {"collocated", "staggered"}};
    key.required = required;
    if (!required) { key.fallback = "collocated"; }
    return key;
}

Key patchesKey()
{
    return {
        .name = "patches",
        .type = Key::Type::dictionary,
        .meaning = "every face of an axis with an extent belongs to exactly one",
        .required = true,
        .keys = {
            {.name = "*",
             .type = Key::Type::dictionary,
             .meaning = "a patch, by its name",
             .keys = {{.name = "type",
                       .type = Key::Type::word,
                       .meaning = "what happens there",
                       .required = true,
                       .words = {"periodic", "wall", "patch"}},
                      {.name = "axis",
                       .type = Key::Type::word,
                       .meaning = "both faces of this axis",
                       .words = {"x", "y", "z"}},
                      {.name = "face",
                       .type = Key::Type::word,
                       .meaning = "one face",
                       .words = {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"}},
                      {.name = "faces", .type = Key::Type::list, .meaning = "any of xMin xMax yMin yMax zMin zMax"}}}}};
}

} // namespace

const Schema& latticeDictSchema()
{
    static const Schema schema(
        "latticeDict",
        {originKey(false),
         extentKey(),
         {.name = "count", .type = Key::Type::vector, .meaning = "points per axis; or intervals, or spacing"},
         {.name = "intervals",
          .type = Key::Type::vector,
          .meaning = "periodic and staggered axes: points; points on both ends: one less"},
         {.name = "spacing",
          .type = Key::Type::any,
          .unit = "m",
          .meaning = "one for all axes, or one for each; must fit"},
         patchesKey(),
         arrangementKey(false)});
    return schema;
}

const Schema& latticeSchema()
{
    static const Schema schema(
        "lattice",
        {originKey(true),
         extentKey(),
         {.name = "count", .type = Key::Type::vector, .meaning = "points per axis", .required = true},
         {.name = "spacing",
          .type = Key::Type::vector,
          .unit = "m",
          .meaning = "0 for an axis left out",
          .required = true},
         {.name = "axes", .type = Key::Type::list, .meaning = "periodic | bounded | leftOut", .required = true},
         arrangementKey(true),
         patchesKey()});
    return schema;
}

} // namespace isph
