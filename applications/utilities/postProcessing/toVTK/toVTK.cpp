// toVTK: what ParaView opens, VTK/<case>.pvd with one image (.vti) a time.
//
//     toVTK -case cavity                          every time, every field
//     toVTK -case cavity -latestTime -derived     also vorticity, divergence, Q and, in two dimensions, streamFunction
//     toVTK -case cavity -time 0.5:1 -fields '(U p)' -compress -float32
//     toVTK -case cavity -extended                what fcExtend wrote, in a collection of its own

#include "case/AtomicFolder.hpp"
#include "case/Case.hpp"
#include "case/TimeDirectories.hpp"
#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/selectFields.hpp"
#include "caseFields/StreamFunction.hpp"
#include "caseFields/VelocityDerivatives.hpp"
#include "core/FileDescriptor.hpp"
#include "core/runApplication.hpp"
#include "fieldStore/FieldReader.hpp"
#include "lattice/readLattice.hpp"
#include "vtkOutput/writePvd.hpp"
#include "vtkOutput/writeVti.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

using namespace isph;

/// The fields of one image: arrays look at values, which a deque never moves.
struct Image
{
    std::deque<RealField> values;
    std::vector<ImageArray> arrays;

    void add(const std::string& name, RealField field, const std::array<double, 3>& periodGain = {})
    {
        values.push_back(std::move(field));
        arrays.push_back({name, &values.back(), periodGain});
    }
};

static void addDerived(const RealField& U, const Lattice& lattice, Image& image)
{
    VelocityDerivatives derivatives(lattice);
    image.add("vorticity", derivatives.vorticity(U));
    image.add("divergence", derivatives.divergence(U));
    image.add("Q", derivatives.Q(U));
    if (lattice.dimensions() == 2)
    {
        StreamFunction psi = streamFunction(U, lattice);
        image.add("streamFunction", std::move(psi.values), psi.periodGain);
    }
}

static Image readImage(FieldsOfTime& fields, const std::vector<std::string>& names, bool derived,
                       const Lattice& lattice)
{
    Image image;
    for (const std::string& name : names) { image.add(name, fields.read(name, lattice)); }
    if (derived)
    {
        const auto U = std::find(names.begin(), names.end(), "U");
        if (U == names.end()) { addDerived(fields.read("U", lattice), lattice, image); }
        else { addDerived(image.values[static_cast<std::size_t>(U - names.begin())], lattice, image); }
    }
    return image;
}

/// Name of the collection: the fields that fcExtend continued have one of their own.
static std::string collectionName(const Case& theCase, bool extended)
{
    return theCase.name() + (extended ? "_extended" : "");
}

static std::string imageName(const std::string& collection, const TimeDirectory& time)
{
    return fmt::format("{}_{}.vti", collection, time.name);
}

static constexpr const char* extendedStore = "/extended.h5";

/// The fields of one time as fcExtend continued them.
static Image readExtended(const FieldReader& reader, const CommandLine& line)
{
    Image image;
    for (const std::string& name : selectFields(reader.fields(), line)) { image.add(name, reader.read(name)); }
    return image;
}

/// The collection of all images whose time the case still has: those of earlier calls stay in it.
static void writeCollection(const Case& theCase, const std::string& collection)
{
    std::vector<PvdEntry> entries;
    for (const TimeDirectory& time : timeDirectories(theCase.directory()))
    {
        const std::string file = imageName(collection, time);
        if (theCase.has("VTK/" + file)) { entries.push_back({FieldsOfTime(theCase, time.name).time(), file}); }
    }
    writePvd(theCase.path("VTK/" + collection + ".pvd"), entries);
}

static void run(const CommandLine& line, Log& log)
{
    const Case theCase(line.caseDirectory());
    const Lattice lattice = readLattice(theCase.dictionary("constant/lattice"));
    const VtiFormat format{line.has("compress"), line.has("float32")};
    const bool extended = line.has("extended");
    const std::string collection = collectionName(theCase, extended);
    if (extended && line.has("derived"))
    {
        throw Error(Fault::usage, "-derived and -extended exclude each other",
                    "fcExtend -derivatives writes derivatives of continued fields");
    }
    auto times = selectTimes(timeDirectories(theCase.directory()), line);
    if (extended)
    {
        std::erase_if(times, [&](const TimeDirectory& time) { return !theCase.has(time.name + extendedStore); });
    }
    if (times.empty())
    {
        throw Error(Fault::input, "there is no time to convert",
                    extended ? "run fcExtend first" : "run isphFoam, or leave out -noZero");
    }

    removeLeftovers(theCase.path("VTK"));
    for (const TimeDirectory& time : times)
    {
        FieldsOfTime fields(theCase, time.name);
        Lattice shown = lattice;
        Image image;
        if (extended)
        {
            const FieldReader reader(theCase.path(time.name + extendedStore), time.name + extendedStore);
            shown = reader.lattice();
            image = readExtended(reader, line);
        }
        else { image = readImage(fields, selectFields(fields.names(), line), line.has("derived"), lattice); }
        makeFolder(theCase.path("VTK"));
        writeVti(theCase.path("VTK/" + imageName(collection, time)), shown, fields.time(), image.arrays, format);
        writeCollection(theCase, collection);
        log.line(fmt::format("Time = {}: {} fields", time.name, image.arrays.size()));
    }
    log.line(fmt::format("Wrote VTK/{}.pvd", collection));
}

int main(int argc, char** argv)
{
    Application application{.name = "toVTK",
                            .summary = "writes VTK/<case>.pvd and one image a time, for ParaView",
                            .examples = "toVTK -case cavity\n"
                                        "toVTK -case cavity -latestTime -derived\n"
                                        "toVTK -case cavity -time 0.5:1 -fields '(U p)' -compress -float32"};
    application.options = {{"derived", "", "also vorticity, divergence, Q, and the stream function in two dimensions"},
                           {"extended", "", "the fields that fcExtend continued, as <case>_extended.pvd"},
                           {"compress", "", "zlib compression"},
                           {"float32", "", "single precision: half the size"}};
    application.options.insert(application.options.end(), timeOptions.begin(), timeOptions.end());
    application.options.insert(application.options.end(), fieldOptions.begin(), fieldOptions.end());
    return runApplication(application, argc, argv, run);
}
