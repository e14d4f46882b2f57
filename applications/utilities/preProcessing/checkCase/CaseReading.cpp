#include "CaseReading.hpp"

#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/unitOf.hpp"
#include "fields/reductions.hpp"
#include "flow/readFlow.hpp"
#include "flow/readFlowSettings.hpp"
#include "flow/readFluid.hpp"
#include "functions/functionSelection.hpp"
#include "lattice/memoryEstimate.hpp"
#include "lattice/readLattice.hpp"
#include "sampling/readSampleSet.hpp"
#include "transport/readScalarFunctions.hpp"
#include "transport/TransportScene.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

namespace isph
{

namespace
{

class Reader
{
public:
    explicit Reader(CaseReading& reading) : reading_(reading) {}

    void readAll(const std::filesystem::path& directory)
    {
        attempt([&] { reading_.theCase.emplace(directory); });
        if (!reading_.theCase) { return; }
        requireWritable();
        readTimes();
        readPoints();
        const auto& control = reading_.controlDict;
        reading_.scalar =
            control && control->has("application") && control->text("application") == "scalarTransportFoam";
        if (reading_.scalar)
        {
            readScalar();
            readSamples();
            return;
        }
        readSchemes();
        readFluidOfCase();
        resolveSettings();
        readFields();
        readFunctions();
        readSamples();
    }

private:
    /// Does a part of the reading; what is wrong there is kept, each slip once.
    template<class Part>
    void attempt(const Part& part)
    {
        try
        {
            part();
        }
        catch (const Error& error)
        {
            for (const Complaint& complaint : error.complaints())
            {
                if (std::ranges::find(reading_.slips, complaint) == reading_.slips.end())
                {
                    reading_.slips.push_back(complaint);
                }
            }
        }
    }

    /// A program writes in every case it solves.
    void requireWritable();
    void readTimes();
    void readPoints();
    void compareWithLatticeDict();
    void readFluidOfCase();
    void readSchemes();
    void resolveSettings();
    void readFields();
    void readFunctions();
    void readSamples();
    void readScalar();
    void readScalarFields();

    const Case& theCase() const { return *reading_.theCase; }
    Dictionary file(const std::string& relative) const { return theCase().dictionary(relative); }

    CaseReading& reading_;
};

void Reader::requireWritable()
{
    if (access(theCase().directory().c_str(), W_OK) == 0) { return; }
    reading_.slips.push_back({{theCase().directory().string(), 0, ""},
                              "the solver may not write here",
                              "change the permissions, or copy the case with cloneCase"});
}

void Reader::readTimes()
{
    std::optional<TimeSettings> settings;
    attempt(
        [&]
        {
            reading_.controlDict = controlDictSchema().complete(file("system/controlDict"));
            settings = readTimeSettings(*reading_.controlDict);
        });
    attempt([&] { reading_.start = findStart(theCase(), settings.value_or(TimeSettings{})); });
    if (settings && reading_.start)
    {
        attempt([&] { reading_.control = readTimeControl(theCase()); });
    }
}

void Reader::readPoints()
{
    if (theCase().has("constant/lattice"))
    {
        attempt([&] { reading_.lattice = readLattice(file("constant/lattice")); });
        compareWithLatticeDict();
    }
    else
    {
        attempt([&] { file("constant/lattice"); }); // says what to do about it
        if (theCase().has("system/latticeDict"))
        {
            attempt([&] { reading_.lattice = makeLattice(file("system/latticeDict")); });
        }
    }
    if (!reading_.lattice) { return; }
    const bool made = theCase().has("constant/lattice");
    attempt(
        [&]
        {
            requireMemory(solverMemory(*reading_.lattice), machineMemory(),
                          {made ? "constant/lattice" : "system/latticeDict", 0, "count"});
        });
    if (solverMemory(*reading_.lattice) > machineMemory()) { reading_.lattice.reset(); }
}

void Reader::compareWithLatticeDict()
{
    if (!reading_.lattice || !theCase().has("system/latticeDict")) { return; }
    try
    {
        if (makeLattice(file("system/latticeDict")) == *reading_.lattice) { return; }
        reading_.warnings.emplace_back("system/latticeDict asks for another lattice than constant/lattice, which the "
                                       "solver takes: makeLattice -overwrite makes it anew");
    }
    catch (const Error& error)
    {
        const Complaint& first = error.complaints().front();
        reading_.warnings.push_back(fmt::format("{}: {} (the solver takes constant/lattice, which is there)",
                                                toString(first.origin), first.what));
    }
}

void Reader::readFluidOfCase()
{
    attempt(
        [&]
        {
            reading_.transportProperties = transportPropertiesSchema().complete(file("constant/transportProperties"));
            if (reading_.lattice) { reading_.fluid = readFluid(theCase(), *reading_.lattice); }
        });
}

void Reader::readSchemes()
{
    std::optional<Dictionary> written;
    attempt([&] { written = file("system/schemes"); });
    if (written)
    {
        attempt(
            [&] {
                reading_.schemes =
                    reading_.lattice ? completedSchemes(*written, *reading_.lattice) : completedSchemes(*written);
            });
    }
    attempt([&] { reading_.solution = completedSolution(file("system/solution"), written.value_or(Dictionary())); });
}

void Reader::resolveSettings()
{
    if (!reading_.schemes || !reading_.solution) { return; }
    if (!reading_.lattice || !reading_.fluid)
    {
        reading_.unread.emplace_back("whether the schemes fit together");
        return;
    }
    attempt(
        [&]
        {
            reading_.settings =
                readFlowSettings(file("system/schemes"), file("system/solution"), *reading_.lattice, *reading_.fluid);
        });
}

void Reader::readFields()
{
    if (!reading_.start) { return; }
    const std::string time = reading_.start->folder.name;
    if (!reading_.lattice || !reading_.fluid)
    {
        reading_.unread.push_back("fields of time " + time);
        return;
    }
    const Lattice& lattice = *reading_.lattice;
    attempt([&] { reading_.U = readVelocityFile(theCase(), time, lattice); });
    attempt([&] { reading_.p = readPressureFile(theCase(), time, lattice, *reading_.fluid); });
    if (reading_.U && reading_.p)
    {
        attempt(
            [&]
            {
                const FlowFiles files = readFlowFiles(theCase(), time, lattice, *reading_.fluid);
                reading_.boundary.emplace(readFlowBoundary(theCase(), time, lattice, *reading_.fluid, files));
            });
    }

    std::optional<FieldsOfTime> fields;
    attempt([&] { fields.emplace(theCase(), time); });
    if (!fields) { return; }
    const auto finite = [&](const std::string& name, const RealField& field)
    {
        for (int c = 0; c < field.components(); ++c)
        {
            if (allFinite(field[c])) { continue; }
            throw Error(Fault::input, {time + "/" + name, 0, "internalField"}, "is not finite everywhere in the box",
                        "look for a division by zero, or a root or logarithm of a negative number");
        }
    };
    if (reading_.U)
    {
        attempt(
            [&]
            {
                RealField velocity = fields->read("U", lattice);
                finite("U", velocity);
                if (reading_.boundary) { reading_.boundary->impose(velocity); }
                reading_.velocity = std::move(velocity);
            });
    }
    if (reading_.p)
    {
        attempt([&] { fields->read("p", lattice); });
    }
}

void Reader::readFunctions()
{
    if (!reading_.controlDict || !reading_.controlDict->hasDictionary("functions")) { return; }
    if (!reading_.lattice || !reading_.fluid)
    {
        reading_.unread.emplace_back("functions of system/controlDict");
        return;
    }
    const bool inPascal = reading_.p && unitOf(reading_.p->dimensions("dimensions")) == "Pa";
    attempt(
        [&]
        {
            Functions(reading_.controlDict->dictionary("functions"),
                      {.theCase = theCase(),
                       .lattice = *reading_.lattice,
                       .fluid = *reading_.fluid,
                       .startTime = reading_.start ? reading_.start->folder.name : "0",
                       .pressureScale = inPascal ? reading_.fluid->rho.value_or(1) : 1,
                       .pressureUnit = inPascal ? "Pa" : "m2/s2",
                       .pressureFixed = reading_.boundary && reading_.boundary->fixesPressure()});
        });
}

void Reader::readSamples()
{
    if (!theCase().has("system/sampleDict")) { return; }
    if (!reading_.lattice)
    {
        reading_.unread.emplace_back("system/sampleDict");
        return;
    }
    attempt([&] { readSampleSet(file("system/sampleDict"), *reading_.lattice); });
}

void Reader::readScalar()
{
    attempt(
        [&]
        {
            const double DT = readDiffusivity(theCase());
            reading_.fluid.emplace().nu = DT;
        });
    attempt([&] { file("system/schemes"); });
    if (!reading_.lattice || !reading_.fluid)
    {
        reading_.unread.emplace_back("schemes, fields and functions");
        return;
    }
    const Lattice& lattice = *reading_.lattice;
    attempt([&] { reading_.schemes = completedSchemes(file("system/schemes"), lattice); });
    if (reading_.schemes)
    {
        attempt([&] { reading_.settings = readTransportSettings(theCase(), lattice, reading_.fluid->nu); });
    }
    if (reading_.start) { readScalarFields(); }
}

void Reader::readScalarFields()
{
    const std::string time = reading_.start->folder.name;
    const Lattice& lattice = *reading_.lattice;
    const std::size_t slips = reading_.slips.size();
    std::string unit = "1";
    attempt(
        [&]
        {
            const ScalarFile T = readScalarFile(theCase(), time, lattice);
            unit = T.unit;
            readScalarBoundary(theCase(), T.T, lattice).update(reading_.start->state.time);
        });
    attempt([&] { readGivenVelocity(theCase(), carrierFolder, lattice); });
    attempt([&] { readScalarFunctions(theCase(), lattice, time, unit); });
    if (!reading_.settings || reading_.slips.size() > slips) { return; }

    attempt(
        [&]
        {
            TransportScene scene(theCase(), time);
            Timings timings;
            ScalarTransport transport(scene.lattice, scene.diffusivity, scene.settings, *scene.velocity, scene.boundary,
                                      timings);
            startTransport(theCase(), time, reading_.start->restart, reading_.start->state.time, scene, transport);
            if (!transport.sound(unlimited))
            {
                throw Error(Fault::input, {time + "/T", 0, "internalField"}, "is not finite everywhere in the box",
                            "look for a division by zero, or a root or logarithm of a negative number");
            }
            transport.rates(reading_.start->state.time);
            reading_.velocity = copyOf(transport.velocity());
            reading_.transport = describeTransport(scene, transport);
            reading_.memory = transportMemory(scene);
            if (!transport.dealiases()) { reading_.settings->dealiasing = Dealiasing::none; }
        });
}

} // namespace

CaseReading readWholeCase(const std::filesystem::path& directory)
{
    CaseReading reading;
    Reader(reading).readAll(directory);
    return reading;
}

} // namespace isph
