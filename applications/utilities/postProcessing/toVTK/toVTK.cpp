// toVTK: what ParaView opens, VTK/<case>.pvd with one image (.vti) a time.
//
//     toVTK -case cavity                          every time, every field
//     toVTK -case cavity -latestTime -derived     also vorticity, divergence, Q and, in two dimensions, streamFunction
//     toVTK -case cavity -time 0.5:1 -fields '(U p)' -compress -float32

#include "case/AtomicFolder.hpp"
#include "case/Case.hpp"
#include "case/TimeDirectories.hpp"
#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/selectFields.hpp"
#include "caseFields/VelocityDerivatives.hpp"
#include "core/FileDescriptor.hpp"
#include "core/runApplication.hpp"
#include "lattice/readLattice.hpp"
#include "vtkOutput/writePvd.hpp"
#include "vtkOutput/writeVti.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <string>
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
    VelocityDerivatives derivatives(U, lattice);
    image.add("vorticity", derivatives.vorticity());
    image.add("divergence", derivatives.divergence());
    image.add("Q", derivatives.Q());
    if (lattice.dimensions() == 2)
    {
        image.add("streamFunction", derivatives.streamFunction(), derivatives.streamFunctionGain());
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

static std::string imageName(const Case& theCase, const TimeDirectory& time)
{
    return fmt::format("{}_{}.vti", theCase.name(), time.name);
}

/// The collection of all images whose time the case still has: those of earlier calls stay in it.
static void writeCollection(const Case& theCase)
{
    std::vector<PvdEntry> entries;
    for (const TimeDirectory& time : timeDirectories(theCase.directory()))
    {
        const std::string file = imageName(theCase, time);
        if (theCase.has("VTK/" + file)) { entries.push_back({FieldsOfTime(theCase, time.name).time(), file}); }
    }
    writePvd(theCase.path("VTK/" + theCase.name() + ".pvd"), entries);
}

static void run(const CommandLine& line, Log& log)
{
    const Case theCase(line.caseDirectory());
    const Lattice lattice = readLattice(theCase.dictionary("constant/lattice"));
    const VtiFormat format{line.has("compress"), line.has("float32")};
    const auto times = selectTimes(timeDirectories(theCase.directory()), line);
    if (times.empty())
    {
        throw Error(Fault::input, "there is no time to convert", "run isphFoam, or leave out -noZero");
    }

    removeLeftovers(theCase.path("VTK"));
    for (const TimeDirectory& time : times)
    {
        FieldsOfTime fields(theCase, time.name);
        const Image image = readImage(fields, selectFields(fields.names(), line), line.has("derived"), lattice);
        makeFolder(theCase.path("VTK"));
        writeVti(theCase.path("VTK/" + imageName(theCase, time)), lattice, fields.time(), image.arrays, format);
        writeCollection(theCase);
        log.line(fmt::format("Time = {}: {} fields", time.name, image.arrays.size()));
    }
    log.line(fmt::format("Wrote VTK/{}.pvd", theCase.name()));
}

int main(int argc, char** argv)
{
    Application application{.name = "toVTK",
                            .summary = "writes VTK/<case>.pvd and one image a time, for ParaView",
                            .examples = "toVTK -case cavity\n"
                                        "toVTK -case cavity -latestTime -derived\n"
                                        "toVTK -case cavity -time 0.5:1 -fields '(U p)' -compress -float32"};
    application.options = {{"derived", "", "also vorticity, divergence, Q, and the stream function in two dimensions"},
                           {"compress", "", "zlib compression"},
                           {"float32", "", "single precision: half the size"}};
    application.options.insert(application.options.end(), timeOptions.begin(), timeOptions.end());
    application.options.insert(application.options.end(), fieldOptions.begin(), fieldOptions.end());
    return runApplication(application, argc, argv, run);
}
