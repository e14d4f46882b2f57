#pragma once

#include "case/Case.hpp"
#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <memory>
#include <string>
#include <vector>

namespace isph
{

/// What a field is, without its values.
struct FieldHeader
{
    int components = 1;     ///< as dictionaries write it: 1 for a scalar, 3 for a vector
    std::string unit = "1"; ///< "m/s"
};

/// The fields of one time folder, wherever their values come from: dictionaries (0/U) or fields.h5, which is opened
/// once.
class FieldsOfTime
{
public:
    /// \param time name of the folder, e.g. "0" or "0.25"
    /// \throws Error(input) if there is no such folder.
    FieldsOfTime(const Case& theCase, std::string time);
    ~FieldsOfTime();
    FieldsOfTime(const FieldsOfTime&) = delete;
    FieldsOfTime& operator=(const FieldsOfTime&) = delete;

    /// The exact time [s]: what uniform/time says, else what the name of the folder reads.
    double time() const;

    /// One per dictionary, then those that only fields.h5 has, each group in alphabetical order.
    std::vector<std::string> names();

    /// Kind and unit of a field, from its dictionary (FoamFile class, else the shape of the value) or from fields.h5.
    /// \throws Error(input) if the time has no such field.
    FieldHeader header(const std::string& name);

    /// A field at the points of a lattice: internalField uniform | expression | table | hdf5 "fields.h5" (contract,
    /// section 3), or a field that only fields.h5 has. Expressions know nu and rho; t is the time of the folder.
    /// \return one component, or lattice.dimensions() components of a vector
    /// \throws Error(input) if the field is missing, lies on another lattice, or is not zero along an axis left out.
    RealField read(const std::string& name, const Lattice& lattice);

private:
    struct Store;

    /// The opened HDF5 file of this folder.
    Store& store(const std::string& file);
    bool hasDictionary(const std::string& name) const;
    std::string shownAs(const std::string& file) const { return time_ + "/" + file; }
    RealField readStored(const std::string& file, const std::string& name, const Lattice& lattice);
    void requireStored(const std::string& name);

    const Case case_;
    std::string time_;
    std::unique_ptr<Store> store_;
};

/// One field of one time folder.
RealField readField(const Case& theCase, const std::string& time, const std::string& name, const Lattice& lattice);

/// The fields of a time folder, see FieldsOfTime::names.
std::vector<std::string> fieldNames(const Case& theCase, const std::string& time);

} // namespace isph
