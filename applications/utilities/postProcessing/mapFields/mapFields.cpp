// mapFields: fields of another case and time become the start of this one, on its own lattice.
//
//     mapFields ../coarse -case fine                      every field that both have, of the latest time of coarse
//     mapFields ../coarse -case fine -sourceTime 0.5 -fields '(U)'
//
// Replaces internalField in 0/ and keeps the boundary conditions; the folder as it was becomes 0.orig.

#include "case/AtomicFolder.hpp"
#include "case/Case.hpp"
#include "case/TimeDirectories.hpp"
#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/selectFields.hpp"
#include "caseFields/storedFieldText.hpp"
#include "core/runApplication.hpp"
#include "core/writeTextFile.hpp"
#include "fieldStore/FieldWriter.hpp"
#include "lattice/readLattice.hpp"
#include "sampling/LatticeMap.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <string>
#include <vector>

using namespace isph;
namespace fs = std::filesystem;

static constexpr const char* storeName = "fields.h5";

/// A field of the target's start, as it will be.
struct StartField
{
    FieldHeader header;
    RealField values;
};
using StartFields = std::map<std::string, StartField>;

/// What read gives; an error in a file of the source says that it is the source's: paths are relative to a case.
template<class Read>
static auto ofSource(const fs::path& source, Read read)
{
    try
    {
        return read();
    }
    catch (const Error& error)
    {
        std::vector<Complaint> complaints = error.complaints();
        for (Complaint& complaint : complaints)
        {
            if (!complaint.origin.file.empty()) { complaint.origin.file = (source / complaint.origin.file).string(); }
        }
        throw Error(error.fault(), complaints);
    }
}

static std::string sourceTime(const CommandLine& line, const Case& source)
{
    const auto times = timeDirectories(source.directory());
    if (times.empty())
    {
        throw Error(Fault::input, fmt::format("{} has no time folder", source.directory().string()),
                    "run its solver, or name another case");
    }
    const std::string wanted = line.value("sourceTime").value_or("latestTime");
    return wanted == "latestTime" ? times.back().name : TimeRanges(wanted).select(times).front().name;
}

/// Fields that both cases have, or those of -fields.
static std::vector<std::string> fieldsToMap(const CommandLine& line, const std::vector<std::string>& available,
                                            const Case& target)
{
    const auto startsHere = [&target](const std::string& name) { return target.has("0/" + name); };
    if (line.has("fields"))
    {
        const std::vector<std::string> chosen = selectFields(available, line);
        const auto missing = std::ranges::find_if_not(chosen, startsHere);
        if (missing != chosen.end())
        {
            throw Error(Fault::input, {"0/" + *missing, 0, ""}, "is missing, and with it the boundary conditions",
                        "write that file first; its internalField does not matter");
        }
        return chosen;
    }
    std::vector<std::string> common;
    std::ranges::copy_if(available, std::back_inserter(common), startsHere);
    if (common.empty())
    {
        throw Error(Fault::input, {"0", 0, ""}, "has no field that the source has",
                    fmt::format("the source has: {}", fmt::join(available, ", ")));
    }
    return common;
}

static bool isStored(const Dictionary& field)
{
    const Entry* entry = field.find("internalField");
    return entry != nullptr && !entry->tokens().empty() && entry->tokens().front().text == "hdf5";
}

/// Fields of the start that are not mapped but lie in the file that will be replaced.
static void keepStored(const Case& target, const Lattice& lattice, StartFields& fields)
{
    FieldsOfTime start(target, "0");
    for (const std::string& name : start.names())
    {
        if (fields.contains(name) || !target.has("0/" + name)) { continue; }
        if (isStored(target.dictionary("0/" + name)))
        {
            fields.emplace(name, StartField{start.header(name), start.read(name, lattice)});
        }
    }
}

static void copyFolder(const fs::path& from, const fs::path& to)
{
    fs::copy(from, to,
             fs::copy_options::recursive | fs::copy_options::copy_symlinks | fs::copy_options::overwrite_existing);
}

/// Puts a folder in place of 0 when all of it is written; what was there stays as 0.orig unless there is one.
static void replaceStart(const Case& target, const Lattice& lattice, const StartFields& fields, Log& log)
{
    AtomicFolder start(target.path("0"));
    copyFolder(target.path("0"), start.path());
    FieldWriter writer(start.path() / storeName, lattice);
    for (const auto& [name, field] : fields)
    {
        writer.write(name, field.header.unit, field.values);
        writeTextFile(start.path() / name,
                      storedFieldText(target.dictionary("0/" + name), name, field.header.components));
    }
    writer.close();

    if (!target.has("0.orig"))
    {
        AtomicFolder original(target.path("0.orig"));
        copyFolder(target.path("0"), original.path());
        original.commit();
        log.line("Kept the start as it was in 0.orig");
    }
    start.commit();
}

static void run(const CommandLine& line, Log& log)
{
    if (line.positional().size() != 1)
    {
        throw Error(Fault::usage, "expects one case to map from", "e.g. mapFields ../coarse -case fine");
    }
    const Case source(line.positional().front());
    const Case target(line.caseDirectory());
    const fs::path& sourceFolder = source.directory();
    const Lattice sourceLattice =
        ofSource(sourceFolder, [&] { return readLattice(source.dictionary("constant/lattice")); });
    const Lattice lattice = readLattice(target.dictionary("constant/lattice"));
    const std::string time = sourceTime(line, source);
    FieldsOfTime sourceFields(source, time);
    const std::vector<std::string> names =
        fieldsToMap(line, ofSource(sourceFolder, [&] { return sourceFields.names(); }), target);

    LatticeMap map(sourceLattice, lattice);
    log.line(fmt::format("Source: {}, time {}", sourceFolder.string(), time));
    log.line(fmt::format("Method: {}", map.method()));
    StartFields fields;
    for (const std::string& name : names)
    {
        const FieldHeader header = ofSource(sourceFolder, [&] { return sourceFields.header(name); });
        const std::string unit = FieldsOfTime(target, "0").header(name).unit;
        if (unit != header.unit)
        {
            throw Error(Fault::input, {"0/" + name, 0, "dimensions"},
                        fmt::format("is in {}, but the source in {}", unit, header.unit),
                        "give both the same dimensions");
        }
        const RealField values = ofSource(sourceFolder, [&] { return sourceFields.read(name, sourceLattice); });
        fields.emplace(name, StartField{header, map(values)});
    }
    keepStored(target, lattice, fields);
    replaceStart(target, lattice, fields, log);
    log.line(fmt::format("Wrote 0 with {}", fmt::join(names, ", ")));
}

int main(int argc, char** argv)
{
    Application application{.name = "mapFields",
                            .summary = "fields of another case and time, as the start of this one on its own lattice",
                            .examples = "mapFields ../coarse -case fine\n"
                                        "mapFields ../coarse -case fine -sourceTime 0.5 -fields '(U)'",
                            .positional = "SOURCE"};
    application.options = {{"sourceTime", "TIME", "time of the source, or latestTime (default)"}};
    application.options.insert(application.options.end(), fieldOptions.begin(), fieldOptions.end());
    return runApplication(application, argc, argv, run);
}
