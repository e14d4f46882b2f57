#include "caseFields/FieldsOfTime.hpp"

#include "case/TimeDirectories.hpp"
#include "case/TimeState.hpp"
#include "caseFields/fluidConstants.hpp"
#include "caseFields/unitOf.hpp"
#include "core/Error.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/SpaceTimeFunction.hpp"
#include "fields/reductions.hpp"
#include "fieldStore/FieldReader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace isph
{

namespace
{

constexpr const char* storeName = "fields.h5";

/// Editors and programs leave other things in a time folder: backups, archives, hidden files.
bool isFieldFile(const std::filesystem::directory_entry& entry)
{
    const std::string name = entry.path().filename().string();
    return entry.is_regular_file() && name.find('.') == std::string::npos && name.back() != '~';
}

/// The HDF5 file that an internalField names, or empty if it holds no "hdf5".
std::string storeOf(const Dictionary& field)
{
    const Entry* entry = field.find("internalField");
    if (entry == nullptr || entry->tokens().empty() || entry->tokens()[0].text != "hdf5") { return ""; }
    if (entry->tokens().size() != 2)
    {
        throw field.error("internalField", "names no file behind hdf5", "write hdf5 \"fields.h5\";");
    }
    return entry->tokens()[1].text;
}

bool hasClass(const Dictionary& field)
{
    return field.hasDictionary("FoamFile") && field.dictionary("FoamFile").has("class");
}

/// 1 or 3, from the FoamFile class, else from the shape of "uniform (1 0 0)" or "expression ("a" "b" "c")".
int componentsOf(const Dictionary& field)
{
    if (hasClass(field))
    {
        const Word name = field.dictionary("FoamFile").word("class");
        if (name.text == "latticeScalarField") { return 1; }
        if (name.text == "latticeVectorField") { return 3; }
        throw Error(Fault::input, name.origin, fmt::format("'{}' is no class of fields", name.text),
                    "known are: latticeScalarField, latticeVectorField");
    }
    const Entry* entry = field.find("internalField");
    if (entry == nullptr) { throw field.error("internalField", "is missing", "write e.g. uniform 0;"); }
    const std::vector<Token>& tokens = entry->tokens();
    if (!tokens.empty() && tokens[0].text == "table")
    {
        throw field.error("internalField", "does not tell whether the field is a scalar or a vector",
                          "begin the file with FoamFile { class latticeScalarField; } or latticeVectorField");
    }
    return std::any_of(tokens.begin(), tokens.end(), [](const Token& token) { return token.text == "("; }) ? 3 : 1;
}

/// Whether both have the same points, up to rounding.
bool samePoints(const Lattice& a, const Lattice& b)
{
    const auto close = [](double x, double y, double scale) { return std::abs(x - y) <= 1e-12 * scale; };
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& one = a.axis(direction);
        const Axis& other = b.axis(direction);
        const double scale = std::max({std::abs(one.origin), std::abs(other.origin), one.extent});
        if (one.count != other.count || one.ends != other.ends || one.staggered != other.staggered ||
            !close(one.extent, other.extent, scale) || !close(one.origin, other.origin, scale))
        {
            return false;
        }
    }
    return true;
}

std::string countText(const Lattice& lattice)
{
    return fmt::format("({} {} {})", lattice.axis(0).count, lattice.axis(1).count, lattice.axis(2).count);
}

/// Evaluates plane by plane, so that no coordinates of the whole lattice are held.
void evaluate(const SpaceTimeFunction& function, int component, const Lattice& lattice, double time,
              std::span<double> values)
{
    const auto nx = static_cast<std::size_t>(lattice.axis(0).count);
    const auto ny = static_cast<std::size_t>(lattice.axis(1).count);
    std::vector<double> x(nx * ny);
    std::vector<double> y(nx * ny);
    std::vector<double> z(nx * ny);
    for (std::size_t n = 0; n < nx * ny; ++n)
    {
        x[n] = lattice.axis(0).coordinate(static_cast<int>(n % nx));
        y[n] = lattice.axis(1).coordinate(static_cast<int>(n / nx));
    }
    for (int iz = 0; iz < lattice.axis(2).count; ++iz)
    {
        std::fill(z.begin(), z.end(), lattice.axis(2).coordinate(iz));
        function.evaluate(component, x, y, z, time, values.subspan(static_cast<std::size_t>(iz) * nx * ny, nx * ny));
    }
}

RealField evaluated(const Dictionary& field, const SpaceTimeFunction& function, const Lattice& lattice, double time)
{
    if (function.components() == 1)
    {
        RealField values(1, lattice.points());
        evaluate(function, 0, lattice, time, values[0]);
        return values;
    }
    RealField values(lattice.dimensions(), lattice.points());
    int d = 0;
    for (int direction = 0; direction < 3; ++direction)
    {
        if (lattice.axis(direction).active())
        {
            evaluate(function, direction, lattice, time, values[d++]);
            continue;
        }
        RealField leftOut(1, lattice.points());
        evaluate(function, direction, lattice, time, leftOut[0]);
        if (largestMagnitude(leftOut[0]) != 0)
        {
            const char name = lattice.axis(direction).name;
            throw field.error("internalField",
                              fmt::format("has a component along {}, an axis that the lattice leaves out", name),
                              fmt::format("write 0 there, or give axis {} an extent in system/latticeDict", name));
        }
    }
    return values;
}

} // namespace

struct FieldsOfTime::Store
{
    std::string file;
    FieldReader reader;
};

FieldsOfTime::FieldsOfTime(const Case& theCase, std::string time) : case_(theCase), time_(std::move(time))
{
    if (!std::filesystem::is_directory(case_.path(time_)))
    {
        throw Error(Fault::input, {time_, 0, ""}, "is no time folder of this case");
    }
}

FieldsOfTime::~FieldsOfTime() = default;

double FieldsOfTime::time() const
{
    const std::optional<TimeState> state = readTimeState(case_.directory(), time_);
    return state ? state->time : timeOfName(time_).value_or(0);
}

bool FieldsOfTime::hasDictionary(const std::string& name) const { return case_.has(shownAs(name)); }

FieldsOfTime::Store& FieldsOfTime::store(const std::string& file)
{
    if (!store_ || store_->file != file)
    {
        store_.reset(new Store{file, FieldReader(case_.path(shownAs(file)), shownAs(file))});
    }
    return *store_;
}

std::vector<std::string> FieldsOfTime::names()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(case_.path(time_)))
    {
        if (isFieldFile(entry)) { names.push_back(entry.path().filename().string()); }
    }
    std::sort(names.begin(), names.end());
    if (case_.has(shownAs(storeName)))
    {
        std::vector<std::string> stored = store(storeName).reader.fields();
        std::sort(stored.begin(), stored.end());
        for (const std::string& name : stored)
        {
            if (!hasDictionary(name)) { names.push_back(name); }
        }
    }
    return names;
}

void FieldsOfTime::requireStored(const std::string& name)
{
    if (!case_.has(shownAs(storeName)) || !store(storeName).reader.has(name))
    {
        throw Error(Fault::input, {shownAs(name), 0, ""}, "is missing",
                    fmt::format("fields of this time are: {}", fmt::join(names(), ", ")));
    }
}

RealField FieldsOfTime::readStored(const std::string& file, const std::string& name, const Lattice& lattice)
{
    const FieldReader& reader = store(file).reader;
    const Lattice stored = reader.lattice();
    if (!samePoints(stored, lattice))
    {
        throw Error(Fault::input, {shownAs(file), 0, name},
                    fmt::format("lies on another lattice: {} points there, {} in constant/lattice", countText(stored),
                                countText(lattice)),
                    "mapFields brings fields of one lattice onto another");
    }
    return reader.read(name);
}

FieldHeader FieldsOfTime::header(const std::string& name)
{
    const auto storedComponents = [&](const std::string& file)
    { return store(file).reader.read(name).components() == 1 ? 1 : 3; };

    if (!hasDictionary(name))
    {
        requireStored(name);
        return {storedComponents(storeName), store(storeName).reader.unit(name)};
    }
    const Dictionary field = case_.dictionary(shownAs(name));
    const std::string file = storeOf(field);
    return {file.empty() || hasClass(field) ? componentsOf(field) : storedComponents(file),
            unitOf(field.dimensions("dimensions"))};
}

RealField FieldsOfTime::read(const std::string& name, const Lattice& lattice)
{
    if (!hasDictionary(name))
    {
        requireStored(name);
        return readStored(storeName, name, lattice);
    }
    const Dictionary field = case_.dictionary(shownAs(name));
    const std::string file = storeOf(field);
    if (!file.empty()) { return readStored(file, name, lattice); }

    const SpaceTimeFunction function =
        readFunction(field, "internalField", componentsOf(field), fluidConstants(case_), case_.directory());
    return evaluated(field, function, lattice, time());
}

RealField readField(const Case& theCase, const std::string& time, const std::string& name, const Lattice& lattice)
{
    return FieldsOfTime(theCase, time).read(name, lattice);
}

std::vector<std::string> fieldNames(const Case& theCase, const std::string& time)
{
    return FieldsOfTime(theCase, time).names();
}

} // namespace isph
