// sampleLines: fields along the lines and on the planes of system/sampleDict, as CSV.
//
//     sampleLines -case cavity                            postProcessing/sampleLines/<time>/<line>.csv, every time
//     sampleLines -case cavity -latestTime -fields '(U vorticity)'
//     sampleLines -case cavity -latestTime -stdout        the data to standard output, the report to standard error
//     sampleLines -case cavity -latestTime -plane 'z 0.5' a plane without a dictionary; auto: a plane of the box

#include "case/Case.hpp"
#include "case/TimeDirectories.hpp"
#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/selectFields.hpp"
#include "caseFields/VelocityDerivatives.hpp"
#include "core/runApplication.hpp"
#include "lattice/readLattice.hpp"
#include "sampling/readSampleSet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <fmt/format.h>
#include <iostream>
#include <string>
#include <vector>

using namespace isph;

/// What can be sampled besides the fields of a case.
static const std::vector<std::string> derivedFields{"vorticity", "divergence", "Q"};

/// Fields with their values: a deque never moves what NamedField refers to.
struct Fields
{
    std::deque<RealField> values;
    std::vector<NamedField> named;

    void add(const std::string& name, const std::string& unit, RealField field)
    {
        values.push_back(std::move(field));
        named.push_back({name, unit, values.back()});
    }
};

static std::vector<std::string> knownFields(FieldsOfTime& ofTime)
{
    std::vector<std::string> names = ofTime.names();
    for (const std::string& derived : derivedFields)
    {
        if (std::ranges::find(names, derived) == names.end()) { names.push_back(derived); }
    }
    return names;
}

static void addDerived(const std::string& name, FieldsOfTime& ofTime, const Lattice& lattice, Fields& fields)
{
    VelocityDerivatives derivatives(lattice);
    const RealField U = ofTime.read("U", lattice);
    if (name == "vorticity") { fields.add(name, "1/s", derivatives.vorticity(U)); }
    else if (name == "divergence") { fields.add(name, "1/s", derivatives.divergence(U)); }
    else { fields.add(name, "1/s2", derivatives.Q(U)); }
}

static Fields readFields(FieldsOfTime& ofTime, const std::vector<Word>& words, const Lattice& lattice)
{
    const std::vector<std::string> ofCase = ofTime.names();
    const std::vector<std::string> known = knownFields(ofTime);
    Fields fields;
    for (const Word& word : words)
    {
        if (std::ranges::find(known, word.text) == known.end()) { throwUnknownWord("field", word, known); }
        if (std::ranges::find(ofCase, word.text) == ofCase.end()) { addDerived(word.text, ofTime, lattice, fields); }
        else { fields.add(word.text, ofTime.header(word.text).unit, ofTime.read(word.text, lattice)); }
    }
    return fields;
}

/// Points for a picture: count along the longer side of the plane, and as dense, but at least 100, along the other.
static std::array<int, 2> rasterOf(const Plane& plane, const Lattice& lattice, const std::string& count)
{
    char* end = nullptr;
    const long points = std::strtol(count.c_str(), &end, 10);
    if (*end != '\0' || points < 2 || points > 10000)
    {
        throw Error(Fault::usage, fmt::format("-raster '{}' is no whole number from 2 to 10000", count));
    }
    std::vector<double> extents;
    for (int d = 0; d < 3; ++d)
    {
        if (d != plane.normal) { extents.push_back(lattice.axis(d).extent); }
    }
    const double longest = std::max(extents[0], extents[1]);
    const auto along = [&](double extent)
    {
        return std::max(std::min(100, static_cast<int>(points)),
                        static_cast<int>(std::lround(static_cast<double>(points) * extent / longest)));
    };
    return {along(extents[0]), along(extents[1])};
}

static SampleSet readSamples(const CommandLine& line, const Case& theCase, const Lattice& lattice, FieldsOfTime& first)
{
    std::vector<Word> fields;
    for (const std::string& name : line.has("fields") ? selectFields(knownFields(first), line) : first.names())
    {
        fields.push_back({name, {"", 0, "-fields"}});
    }
    SampleChoices choices;
    if (line.has("fields")) { choices.fields = fields; }
    if (line.has("interpolation"))
    {
        choices.interpolation = {*line.value("interpolation"), {"", 0, "-interpolation"}};
    }
    if (line.has("only")) { choices.only = {*line.value("only"), {"", 0, "-only"}}; }
    if (!line.has("plane")) { return readSampleSet(theCase.dictionary("system/sampleDict"), lattice, choices); }

    Plane plane = planeOfText(*line.value("plane"), lattice);
    if (line.has("raster")) { plane.nPoints = rasterOf(plane, lattice, *line.value("raster")); }
    const Word interpolation = choices.interpolation.value_or(Word{"spectral", {}});
    return {lattice, {}, {plane}, fields, interpolations()[interpolation]};
}

/// Tables follow each other behind a comment each; one alone has none, and is plain CSV.
static void print(const SampleSet& set, const Fields& fields, const std::string& time, bool alone)
{
    for (std::size_t place = 0; place < set.size(); ++place)
    {
        if (!alone) { std::cout << fmt::format("# time {}, {}\n", time, set.name(place)); }
        std::cout << csvText(set.sample(place, fields.named)) << (alone ? "" : "\n");
    }
    if (!std::cout.flush()) { throw Error(Fault::input, "standard output takes no more"); }
}

/// "U, p along vertical, mid"
static std::string summary(const SampleSet& set, const Fields& fields)
{
    std::vector<std::string> fieldNames;
    std::vector<std::string> placeNames;
    for (const NamedField& field : fields.named) { fieldNames.push_back(field.name); }
    for (std::size_t place = 0; place < set.size(); ++place) { placeNames.push_back(set.name(place)); }
    return fmt::format("{} at {}", fmt::join(fieldNames, ", "), fmt::join(placeNames, ", "));
}

static void run(const CommandLine& line, Log& log)
{
    const Case theCase(line.caseDirectory());
    const Lattice lattice = readLattice(theCase.dictionary("constant/lattice"));
    const auto times = selectTimes(timeDirectories(theCase.directory()), line);
    if (times.empty())
    {
        throw Error(Fault::input, "there is no time to sample", "run isphFoam, or leave out -noZero");
    }
    FieldsOfTime first(theCase, times.front().name);
    const SampleSet set = readSamples(line, theCase, lattice, first);

    for (const TimeDirectory& time : times)
    {
        FieldsOfTime ofTime(theCase, time.name);
        const Fields fields = readFields(ofTime, set.fields(), lattice);
        if (line.has("stdout")) { print(set, fields, time.name, times.size() * set.size() == 1); }
        else { writeSamples(set, fields.named, theCase.path("postProcessing/sampleLines/" + time.name)); }
        log.line(fmt::format("Time = {}: {}", time.name, summary(set, fields)));
    }
    if (!line.has("stdout")) { log.line("Wrote postProcessing/sampleLines"); }
}

int main(int argc, char** argv)
{
    Application application{.name = "sampleLines",
                            .summary = "samples fields along lines and on planes (system/sampleDict), as CSV",
                            .examples = "sampleLines -case cavity\n"
                                        "sampleLines -case cavity -latestTime -fields '(U vorticity)'\n"
                                        "sampleLines -case cavity -latestTime -plane 'z 0.5' -stdout",
                            .listings = {{"listInterpolations", [] { return interpolations().words(); }}}};
    application.options = {{"stdout", "", "data to standard output, the report to standard error"},
                           {"interpolation", "WORD", "in place of the dictionary's"},
                           {"only", "NAME", "one line or plane of the dictionary"},
                           {"plane", "PLANE", "instead of the dictionary: 'z 0.5', z for the middle, or auto"},
                           {"raster", "N", "with -plane: N points along its longer side instead of lattice points"}};
    application.options.insert(application.options.end(), timeOptions.begin(), timeOptions.end());
    application.options.insert(application.options.end(), fieldOptions.begin(), fieldOptions.end());
    return runApplication(application, argc, argv, run);
}
