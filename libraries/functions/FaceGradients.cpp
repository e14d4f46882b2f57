#include "functions/FaceGradients.hpp"

#include <utility>

namespace isph
{

FaceGradients::FaceGradients(const Lattice& lattice, std::vector<LatticeFace> faces)
    : lattice_(lattice), faces_(std::move(faces)), derivatives_(lattice), scratch_(1, lattice.points())
{
    const int dimensions = lattice.dimensions();
    for (const LatticeFace& face : faces_) { gradients_.emplace_back(dimensions * dimensions, face.points()); }
}

void FaceGradients::differentiate(const RealField& U)
{
    for (int component = 0; component < lattice_.dimensions(); ++component)
    {
        for (int along = 0; along < lattice_.dimensions(); ++along)
        {
            derivatives_.derivative(U, component, along, scratch_[0]);
            for (std::size_t face = 0; face < faces_.size(); ++face)
            {
                faces_[face].values(scratch_[0], gradients_[face][component * lattice_.dimensions() + along]);
            }
        }
    }
}

RealField FaceGradients::vorticity(std::size_t face) const
{
    const bool plane = lattice_.dimensions() == 2;
    RealField result(derivatives_.vorticityComponents(), faces_[face].points());
    for (int c = 0; c < result.components(); ++c)
    {
        const int a = plane ? 0 : (c + 1) % 3;
        const int b = plane ? 1 : (c + 2) % 3;
        const double sign = plane ? normalSign(lattice_) : 1;
        const auto dUbda = gradient(face, b, a);
        const auto dUadb = gradient(face, a, b);
        for (std::size_t n = 0; n < result.size(); ++n) { result[c][n] = sign * (dUbda[n] - dUadb[n]); }
    }
    return result;
}

RealField FaceGradients::tractionRate(std::size_t face) const
{
    int normal = 0;
    while (lattice_.direction(normal) != faces_[face].direction()) { ++normal; }
    RealField result(lattice_.dimensions(), faces_[face].points());
    for (int c = 0; c < result.components(); ++c)
    {
        const auto across = gradient(face, c, normal);
        const auto along = gradient(face, normal, c);
        for (std::size_t n = 0; n < result.size(); ++n)
        {
            result[c][n] = faces_[face].outward() * (across[n] + along[n]);
        }
    }
    return result;
}

} // namespace isph
