#pragma once

#include "boundary/FlowBoundary.hpp"
#include "functions/CsvOutput.hpp"
#include "functions/FunctionObject.hpp"
#include "functions/WallProfile.hpp"

#include <filesystem>
#include <vector>

namespace isph
{

/// flux.csv: the volume that leaves through patches per second, a row an execution: "time [s]" and a column for each
/// patch, positive outwards, in m3/s (in two dimensions m2/s).
///
/// A face counts with what it prescribes along its normal, where it does: an inlet up to its corners with walls, a wall
/// with nothing beside a lid.
class PatchFlux : public FunctionObject
{
public:
    /// \param boundary which must outlive this, or null: then everything is taken from the flow
    PatchFlux(std::filesystem::path file, const Lattice& lattice, std::vector<WallProfile::NamedFaces> patches,
              const FlowBoundary* boundary);

    void execute(const FlowAtTime& now) override;

private:
    double fluxThrough(const LatticeFace& face, const RealField& U) const;

    Lattice lattice_;
    std::vector<WallProfile::NamedFaces> patches_;
    const FlowBoundary* boundary_;
    CsvOutput csv_;
};

} // namespace isph
