// fcExtend: continues fields over the bounded axes of the lattice, so that they are periodic, and says how smoothly.
//
//     fcExtend -case channel -latestTime                        <time>/extended.h5, jumps at both seams, spectra
//     fcExtend -case channel -fields '(T)' -derivatives         also gradient and Laplacian, in <time>/derivatives.h5
//     fcExtend -case channel -vtk                               also VTK/channel_extended.pvd, by toVTK
//
// Kernel and continuation are those of system/schemes. With exact derivatives in system/fcExtendDict it prints the
// errors of the operators:
//
//     exact { field T; gradient expression ("0" "cos(y)" "0"); laplacian expression "-sin(y)"; }

#include "case/Case.hpp"
#include "case/TimeDirectories.hpp"
#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/selectFields.hpp"
#include "continuation/continuationSelection.hpp"
#include "continuationFiles.hpp"
#include "core/runApplication.hpp"
#include "exactDerivatives.hpp"
#include "fieldStore/FieldWriter.hpp"
#include "kernels/kernelSelection.hpp"
#include "lattice/readLattice.hpp"
#include "operators/ContinuedOperators.hpp"
#include "operators/SpectralOperators.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace isph;
namespace fs = std::filesystem;

/// A file of fields that appears under its name only when it is complete.
class AtomicStore
{
public:
    AtomicStore(const fs::path& file, const Lattice& lattice)
        : file_(file),
          temporary_(file.parent_path() / fmt::format(".{}.tmp-{}", file.filename().string(), ::getpid())),
          writer_(temporary_, lattice)
    {
    }
    AtomicStore(const AtomicStore&) = delete;
    AtomicStore& operator=(const AtomicStore&) = delete;
    ~AtomicStore()
    {
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }

    void write(const std::string& name, const std::string& unit, const RealField& field)
    {
        writer_.write(name, unit, field);
    }

    void commit()
    {
        writer_.close();
        std::error_code refused;
        fs::rename(temporary_, file_, refused);
        if (refused) { throw Error(Fault::input, {file_.string(), 0, ""}, "cannot be written: " + refused.message()); }
    }

private:
    fs::path file_;
    fs::path temporary_;
    FieldWriter writer_;
};

/// What system/schemes says about kernel and continuation; the rest of it is not looked at.
static Dictionary readSchemes(const Case& theCase)
{
    static const Schema schema("schemes", {kernelKey("20"), continuationKey()});
    const Dictionary schemes = theCase.dictionary("system/schemes");
    Dictionary used(schemes.origin());
    for (const char* key : {"kernel", "continuation"})
    {
        if (const Entry* entry = schemes.find(key)) { used.set(*entry); }
    }
    return schema.complete(used);
}

/// Transforms the whole extended box for every derivative, as Lin, Fourtakas & Rogers 2026 do; the kernel is that of as
/// many dimensions as the box has.
class ExtendedBoxOperators
{
public:
    ExtendedBoxOperators(const Lattice& lattice, const Continuations& continuations, const KernelSettings& kernel)
        : lattice_(lattice), continuations_(continuations), extended_(extendedLattice(lattice, continuations))
    {
        std::unique_ptr<KernelSamples> samples;
        if (kernel.symbol == KernelSettings::Symbol::sampled)
        {
            samples = std::make_unique<KernelSamples>(extended_, kernel, LaplacianForm::secondDerivative);
        }
        operators_ = std::make_unique<SpectralOperators>(
            extended_, DerivativeSymbol(extended_, kernel, samples.get()),
            laplacianSymbol(extended_, kernel, LaplacianForm::secondDerivative, samples.get()));
    }

    void gradient(const RealField& f, int component, RealField& gradient)
    {
        const RealField continued = continuedField(f, lattice_, continuations_);
        RealField whole(lattice_.dimensions(), extended_.points());
        operators_->gradient(continued, component, whole);
        cut(whole, gradient);
    }

    void laplacian(const RealField& f, RealField& laplacian)
    {
        const RealField continued = continuedField(f, lattice_, continuations_);
        RealField whole(f.components(), extended_.points());
        operators_->laplacian(continued, whole);
        cut(whole, laplacian);
    }

private:
    /// The points of the lattice, without the new ones.
    void cut(const RealField& whole, RealField& part) const
    {
        const auto count = [](const Lattice& of, int d) { return static_cast<std::size_t>(of.axis(d).count); };
        for (int component = 0; component < part.components(); ++component)
        {
            auto to = part[component].begin();
            for (std::size_t iz = 0; iz < count(lattice_, 2); ++iz)
            {
                for (std::size_t iy = 0; iy < count(lattice_, 1); ++iy)
                {
                    const std::size_t start = count(extended_, 0) * (iy + count(extended_, 1) * iz);
                    to = std::ranges::copy(whole[component].subspan(start, count(lattice_, 0)), to).out;
                }
            }
        }
    }

    const Lattice& lattice_;
    const Continuations& continuations_;
    Lattice extended_;
    std::unique_ptr<SpectralOperators> operators_;
};

/// Name of a component: "T", "U.x".
static std::string componentName(const std::string& field, int components, int component, const Lattice& lattice)
{
    return components == 1 ? field : fmt::format("{}.{}", field, lattice.activeAxis(component).name);
}

/// The fields of one time, read once.
struct FieldAtTime
{
    std::string name;
    FieldHeader header;
    RealField values;
};

/// Writes <time>/derivatives.h5, and the errors of the field that has exact derivatives.
template<class Gradients>
static void writeDerivatives(const Case& theCase, const std::string& time, double exactTime, const Lattice& lattice,
                             const std::vector<FieldAtTime>& fields, const Dictionary& fcExtendDict,
                             const std::string& compared, Gradients& operators, Log& log)
{
    AtomicStore store(theCase.path(time + "/derivatives.h5"), lattice);
    for (const auto& [name, header, values] : fields)
    {
        RealField laplacian(values.components(), values.size());
        operators.laplacian(values, laplacian);
        for (int component = 0; component < values.components(); ++component)
        {
            RealField gradient(lattice.dimensions(), values.size());
            operators.gradient(values, component, gradient);
            store.write(fmt::format("gradient({})", componentName(name, values.components(), component, lattice)),
                        header.unit + "/m", gradient);
            if (name == compared)
            {
                reportErrors(theCase, time, exactTime, fcExtendDict, lattice, gradient, laplacian, header.unit, log);
            }
        }
        store.write(fmt::format("laplacian({})", name), header.unit + "/m2", laplacian);
    }
    store.commit();
    log.line(fmt::format("    Wrote {}/derivatives.h5", time));
}

/// The toVTK beside this program.
/// \throws Error(input) if the suite was built without it.
static fs::path toVTK()
{
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "toVTK";
    if (!fs::exists(program))
    {
        throw Error(Fault::input, "-vtk needs toVTK, which was not built",
                    "install VTK (Debian: libvtk9-dev) and build again, or leave out -vtk");
    }
    return program;
}

/// Runs toVTK -extended for the given times; what it says stands in our report.
static void convert(const fs::path& program, const Case& theCase, const std::vector<std::string>& times, Log& log)
{
    std::vector<std::string> arguments{program.string(),
                                       "-case",
                                       theCase.directory().string(),
                                       "-extended",
                                       "-quiet",
                                       "-time",
                                       fmt::format("{}", fmt::join(times, ","))};
    std::vector<char*> pointers;
    for (std::string& argument : arguments) { pointers.push_back(argument.data()); }
    pointers.push_back(nullptr);
    pid_t child = 0;
    int status = 0;
    const int refused = ::posix_spawn(&child, program.c_str(), nullptr, nullptr, pointers.data(), environ);
    if (refused != 0 || ::waitpid(child, &status, 0) != child || status != 0)
    {
        throw Error(Fault::input, "toVTK failed; its message is above");
    }
    log.line(fmt::format("Wrote VTK/{}_extended.pvd", theCase.name()));
}

static void run(const CommandLine& line, Log& log)
{
    const fs::path converter = line.has("vtk") ? toVTK() : fs::path();
    const Case theCase(line.caseDirectory());
    const Lattice lattice = readLattice(theCase.dictionary("constant/lattice"));
    if (lattice.periodic())
    {
        throw Error(Fault::input, {"constant/lattice", 0, ""}, "has no bounded axis: there is nothing to continue",
                    "make a face a wall or a patch in system/latticeDict");
    }
    const Dictionary schemes = readSchemes(theCase);
    const KernelSettings kernel = selectKernel(schemes.dictionary("kernel"));
    const Dictionary& chosen = schemes.dictionary("continuation");
    const Continuations continuations = selectContinuations(chosen, lattice);
    const Dictionary fcExtendDict = readFcExtendDict(theCase);
    const Lattice extended = extendedLattice(lattice, continuations);
    const bool derivatives = line.has("derivatives");
    log.line(fmt::format("Continuation: {}", chosen.word("type").text));

    std::vector<std::string> done;
    for (const TimeDirectory& time : selectedTimes(line))
    {
        FieldsOfTime stored(theCase, time.name);
        const std::vector<std::string> names = selectFields(stored.names(), line);
        const std::string compared = derivatives ? fieldOfExact(fcExtendDict, names) : "";
        std::vector<FieldAtTime> fields;
        for (const std::string& name : names)
        {
            fields.push_back({name, stored.header(name), stored.read(name, lattice)});
        }
        if (!compared.empty() && stored.header(compared).components != 1)
        {
            throw fcExtendDict.error("exact", fmt::format("is for scalars, but {} is a vector", compared));
        }

        log.line(fmt::format("Time = {}", time.name));
        AtomicStore store(theCase.path(time.name + "/extended.h5"), extended);
        for (const auto& [name, header, values] : fields)
        {
            const RealField continued = continuedField(values, lattice, continuations);
            store.write(name, header.unit, continued);
            for (int component = 0; component < values.components(); ++component)
            {
                const std::string shown = componentName(name, values.components(), component, lattice);
                reportSmoothness({theCase, time.name, shown, header.unit}, lattice, extended, continuations,
                                 continued[component], log);
            }
        }
        store.commit();
        log.line(fmt::format("    Wrote {}/extended.h5", time.name));
        done.push_back(time.name);
        if (!derivatives) { continue; }

        for (int direction = 0; direction < 3; ++direction)
        {
            if (continuations[static_cast<std::size_t>(direction)])
            {
                writeSymbol(theCase, time.name, extended.axis(direction), kernel);
            }
        }
        if (chosen.flag("extended"))
        {
            ExtendedBoxOperators operators(lattice, continuations, kernel);
            writeDerivatives(theCase, time.name, stored.time(), lattice, fields, fcExtendDict, compared, operators,
                             log);
        }
        else
        {
            ContinuedOperators operators(lattice, continuations, kernel);
            writeDerivatives(theCase, time.name, stored.time(), lattice, fields, fcExtendDict, compared, operators,
                             log);
        }
    }
    if (line.has("vtk")) { convert(converter, theCase, done, log); }
}

int main(int argc, char** argv)
{
    Application application{.name = "fcExtend",
                            .summary = "continues fields over bounded axes, so that they are periodic",
                            .examples = "fcExtend -case channel -latestTime\n"
                                        "fcExtend -case channel -fields '(T)' -derivatives"};
    application.options = {
        {"derivatives", "", "also gradient and Laplacian, and their errors against system/fcExtendDict"},
        {"vtk", "", "also VTK/<case>_extended.pvd, by toVTK"}};
    application.options.insert(application.options.end(), timeOptions.begin(), timeOptions.end());
    application.options.insert(application.options.end(), fieldOptions.begin(), fieldOptions.end());
    application.listings = {{"listContinuations", [] { return continuations().words(); }},
                            {"listKernels", [] { return kernels().words(); }}};
    return runApplication(application, argc, argv, run);
}
