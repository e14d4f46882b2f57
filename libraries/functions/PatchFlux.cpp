#include "functions/PatchFlux.hpp"

#include <utility>

namespace isph
{

namespace
{

std::vector<CsvColumn> columnsOf(const std::vector<WallProfile::NamedFaces>& patches, int dimensions)
{
    std::vector<CsvColumn> columns{{"time", "s"}};
    for (const auto& patch : patches) { columns.push_back({patch.patch, dimensions == 2 ? "m2/s" : "m3/s"}); }
    return columns;
}

} // namespace

PatchFlux::PatchFlux(std::filesystem::path file, const Lattice& lattice, std::vector<WallProfile::NamedFaces> patches,
                     const FlowBoundary* boundary)
    : lattice_(lattice),
      patches_(std::move(patches)),
      boundary_(boundary),
      csv_(std::move(file), columnsOf(patches_, lattice.dimensions()))
{
}

double PatchFlux::fluxThrough(const LatticeFace& face, const RealField& U) const
{
    std::vector<double> normal;
    if (boundary_ != nullptr)
    {
        const auto given = boundary_->normalVelocity(face.direction(), face.outward() > 0 ? Side::high : Side::low);
        normal.assign(given.begin(), given.end());
    }
    for (int d = 0; normal.empty() && d < lattice_.dimensions(); ++d)
    {
        if (lattice_.direction(d) != face.direction()) { continue; }
        normal.resize(face.points());
        face.values(U[d], normal);
    }
    double flux = 0;
    for (std::size_t n = 0; n < normal.size(); ++n) { flux += face.weights()[n] * normal[n]; }
    return face.outward() * flux;
}

void PatchFlux::execute(const FlowAtTime& now)
{
    const RealField& U = now.flow.velocity();
    std::vector<double> row{now.time};
    for (const auto& patch : patches_)
    {
        double flux = 0;
        for (const LatticeFace& face : patch.faces) { flux += fluxThrough(face, U); }
        row.push_back(flux);
    }
    csv_.row(row);
}

} // namespace isph
