#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace isph
{

/// Reads what FieldWriter wrote. Opening verifies the checksum of the whole file, reading those of the datasets.
class FieldReader
{
public:
    /// \throws Error(input) naming the file if it is missing, no HDF5, damaged, or of a newer format version.
    explicit FieldReader(const std::filesystem::path& file, const std::string& shownAs = "");
    ~FieldReader();
    FieldReader(const FieldReader&) = delete;
    FieldReader& operator=(const FieldReader&) = delete;

    /// The lattice the fields live on (axes only, no patches).
    Lattice lattice() const;

    /// Names of the fields, without the state.
    std::vector<std::string> fields() const;
    bool has(const std::string& name) const;
    std::string unit(const std::string& name) const;

    /// One component, or lattice().dimensions() components of a vector.
    /// \throws Error(input) naming the file and the dataset if it is missing, damaged or of another shape.
    RealField read(const std::string& name) const;

    bool hasState(const std::string& name) const;
    void readState(const std::string& name, SpectralField& field) const;
    void readState(const std::string& name, RealField& field) const;

private:
    void require(const std::string& name) const;

    struct File;
    std::unique_ptr<File> file_;
};

} // namespace isph
