#include "workPrecisionSchema.hpp"

namespace isph
{

namespace
{

using Type = Key::Type;

std::vector<Key> sweepKeys()
{
    const Key fit{.name = "fit",
                  .type = Type::dictionary,
                  .meaning = "resolutions that slopes are fitted to; a variant may have its own",
                  .keys = {{.name = "from", .type = Type::number}, {.name = "to", .type = Type::number}}};
    const std::vector<Key> variant{
        fit,
        {.name = "title", .type = Type::text, .meaning = "in the key of the picture; the name if left out"},
        {.name = "set",
         .type = Type::dictionary,
         .meaning = "file -> entries, laid over those of the sweep",
         .keys = {{.name = "*", .type = Type::dictionary, .keys = {{.name = "*"}}}}},
        {.name = "replace",
         .type = Type::dictionary,
         .meaning = "file -> its whole content",
         .keys = {{.name = "*", .type = Type::dictionary, .keys = {{.name = "*"}}}}},
        {.name = "parameters",
         .type = Type::dictionary,
         .meaning = "other lists for this variant",
         .keys = {{.name = "*"}}},
    };
    return {
        {.name = "title", .type = Type::text, .meaning = "of the picture; the name of the case if left out"},
        {.name = "baseCase",
         .type = Type::text,
         .fallback = "\".\"",
         .meaning = "the case that the runs are copies of, relative to this one"},
        {.name = "commands",
         .type = Type::list,
         .fallback = "(\"makeLattice -overwrite\" isphFoam)",
         .meaning = "programs with arguments; the last one is the solver, whose time counts"},
        {.name = "after", .type = Type::list, .fallback = "()", .meaning = "programs that work on the results"},
        {.name = "threads", .type = Type::integer, .fallback = "1", .meaning = "of each program", .minimum = 1},
        {.name = "jobs", .type = Type::integer, .fallback = "1", .meaning = "runs at the same time", .minimum = 1},
        {.name = "repetitions",
         .type = Type::integer,
         .fallback = "1",
         .meaning = "of each run; the smallest times count",
         .minimum = 1},
        {.name = "timeLimit",
         .type = Type::number,
         .unit = "s",
         .fallback = "none",
         .meaning = "of the solver; a run that exceeds it is stopped and reported",
         .words = {"none"},
         .positive = true},
        {.name = "parameters",
         .type = Type::dictionary,
         .meaning = "lists: name (v1 v2 ...); or name { values (v1 v2 ...); entry file.entry; }",
         .required = true,
         .keys = {{.name = "*"}}},
        {.name = "resolution",
         .type = Type::word,
         .meaning = "the parameter along a line of the picture; needed if there are several"},
        {.name = "set",
         .type = Type::dictionary,
         .meaning = "file -> entries, in every run",
         .keys = {{.name = "*", .type = Type::dictionary, .keys = {{.name = "*"}}}}},
        {.name = "replace",
         .type = Type::dictionary,
         .meaning = "file -> its whole content, in every run",
         .keys = {{.name = "*", .type = Type::dictionary, .keys = {{.name = "*"}}}}},
        {.name = "variants",
         .type = Type::dictionary,
         .meaning = "a line of the picture each",
         .keys = {{.name = "*", .type = Type::dictionary, .keys = variant}}},
        {.name = "error",
         .meaning = "what is compared: a quantity, or a dictionary of named ones; may be left out where `plot` has "
                    "pictures of costs"},
        {.name = "collect",
         .type = Type::dictionary,
         .meaning = "further columns of the table, a quantity each",
         .keys = {{.name = "*", .type = Type::dictionary, .keys = quantitySchema().keys()}}},
        fit,
        {.name = "plot", .meaning = "a picture, or a dictionary of named ones; else cpuTime and each error"},
        {.name = "external",
         .type = Type::dictionary,
         .meaning = "results that were not made here",
         .keys = {{.name = "*",
                   .type = Type::dictionary,
                   .keys = {{.name = "file", .type = Type::text, .meaning = "CSV", .required = true},
                            {.name = "title", .type = Type::text},
                            {.name = "columns",
                             .type = Type::dictionary,
                             .meaning = "our name -> column of the file; those of the same names if left out",
                             .keys = {{.name = "*", .type = Type::text}}}}}}},
        {.name = "reduced", .meaning = "laid over all of this by -reduced"},
    };
}

} // namespace

const Schema& workPrecisionSchema()
{
    static const Schema schema("workPrecisionDict", sweepKeys());
    return schema;
}

const Schema& quantitySchema()
{
    static const Schema schema(
        "quantity",
        {
            {.name = "report", .type = Type::text, .meaning = "a number of report.json, e.g. errors.U.relL2"},
            {.name = "function", .type = Type::text, .meaning = "a function of controlDict, with its column"},
            {.name = "line", .type = Type::text, .meaning = "a line of sampleDict, with its column"},
            {.name = "command", .type = Type::text, .meaning = "of the shell, in the run's folder, printing a number"},
            {.name = "largestOf", .type = Type::list, .meaning = "other quantities, by name"},
            {.name = "column", .type = Type::text, .meaning = "without its unit"},
            {.name = "abscissa", .type = Type::text, .fallback = "distance", .meaning = "column of a line"},
            {.name = "reduce",
             .type = Type::word,
             .fallback = "last",
             .meaning = "a column to a number",
             .words = {"last", "first", "max", "min", "peak"}},
            {.name = "at", .type = Type::number, .unit = "s", .meaning = "the row of this time, instead"},
            {.name = "from", .type = Type::number, .unit = "s", .meaning = "rows that count"},
            {.name = "to", .type = Type::number, .unit = "s", .meaning = "rows that count"},
            {.name = "overFirst", .type = Type::flag, .fallback = "no", .meaning = "divide by the first row"},
            {.name = "reference",
             .meaning = "a number: the relative difference to it; of a line also \"file.csv:x:y\""},
            {.name = "norm",
             .type = Type::word,
             .fallback = "max",
             .meaning = "of the deviation of a line",
             .words = {"max", "rms"}},
            {.name = "per", .type = Type::text, .meaning = "divide by this number of report.json"},
            {.name = "title", .type = Type::text, .meaning = "at the axis of the picture"},
            {.name = "optional",
             .type = Type::flag,
             .fallback = "no",
             .meaning = "yes: left empty for a run that has no such number"},
        });
    return schema;
}

const Schema& pictureSchema()
{
    static const Schema schema("picture", {
                                              {.name = "x", .type = Type::text, .fallback = "cpuTime"},
                                              {.name = "y", .type = Type::text, .required = true},
                                              {.name = "title", .type = Type::text},
                                              {.name = "xLabel", .type = Type::text},
                                              {.name = "yLabel", .type = Type::text},
                                              {.name = "logX", .type = Type::flag, .fallback = "yes"},
                                              {.name = "logY", .type = Type::flag, .fallback = "yes"},
                                          });
    return schema;
}

} // namespace isph
