#pragma once

#include "functions/FaceGradients.hpp"
#include "functions/FunctionObject.hpp"
#include "functions/PressureForm.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph
{

/// Vorticity, shear stress and pressure at the points of patches: <folder>/<time>/<patch>.csv with the columns "x [m]",
/// "y [m]", "z [m]", "vorticity [1/s]" (in three dimensions its components), "shearStress.x", ... and "p".
///
/// The shear stress is what the fluid pulls the wall along with, the part of the viscous stress in its plane: nu dU/dy
/// on a floor. It has the unit of the pressure that is written, m2/s2 or Pa.
class WallProfile : public FunctionObject
{
public:
    /// Some faces of the box under the name of their patch.
    struct NamedFaces
    {
        std::string patch;
        std::vector<LatticeFace> faces;
    };

    /// \param folder <case>/postProcessing/<name>
    /// \param nu kinematic viscosity [m2/s]
    WallProfile(std::filesystem::path folder, const Lattice& lattice, double nu, std::vector<NamedFaces> patches,
                PressureForm pressure);

    void execute(const FlowAtTime& now) override;

private:
    struct Profile
    {
        std::string patch;
        FaceGradients gradients;
    };

    std::filesystem::path folder_;
    Lattice lattice_;
    double nu_;
    PressureForm pressure_;
    std::vector<Profile> profiles_;
};

} // namespace isph
