#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace isph
{

/// Writes <time>/fields.h5 (contract, section 1): scalars [nz][ny][nx], vectors [nz][ny][nx][3] with zeros for axes
/// left out, lattice, units and format version as attributes, every dataset checksummed (Fletcher-32); besides them the
/// state in the form the solver marches, in group "state".
class FieldWriter
{
public:
    /// \throws Error(input) naming the file if it cannot be created.
    FieldWriter(const std::filesystem::path& file, const Lattice& lattice);
    ~FieldWriter();
    FieldWriter(const FieldWriter&) = delete;
    FieldWriter& operator=(const FieldWriter&) = delete;

    /// A field with one component, or with lattice.dimensions() components (written with three).
    void write(const std::string& name, const std::string& unit, const RealField& field);

    /// The marching state: "state/<name>", all components, bit for bit.
    void writeState(const std::string& name, const SpectralField& field);
    void writeState(const std::string& name, const RealField& field);

    /// Writes the whole file and returns when it is on the disk; until then it is gathered in memory. Without it the
    /// file stays empty, which no reader accepts. The same data give the same bytes. \throws Error(input) naming the
    /// file and the reason, e.g. when the disk is full.
    void close();

private:
    struct File;
    std::unique_ptr<File> file_;
    const Lattice lattice_;
};

} // namespace isph
