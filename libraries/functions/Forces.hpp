#pragma once

#include "functions/CsvOutput.hpp"
#include "functions/FaceGradients.hpp"
#include "functions/FunctionObject.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace isph
{

/// forces.csv: force and moment of the fluid on patches, a row an execution: "time [s]", "step", "pressureForce.x",
/// ..., "viscousForce.x", ..., "pressureMoment.x", ..., "viscousMoment.x", ...
///
///     F = oint p n - nu (grad U + grad U^T) n,   n out of the fluid, into what is behind the patch,
///     M = oint (x - CofR) x dF,
///
/// in N and N m where there is a density, else divided by it. In two dimensions per metre of depth.
class Forces : public FunctionObject
{
public:
    /// \param rho density [kg/m3], or null for kinematic forces
    /// \param centre of moments [m]
    Forces(std::filesystem::path file, const Lattice& lattice, std::vector<LatticeFace> faces, double nu,
           const double* rho, std::array<double, 3> centre);

    void execute(const FlowAtTime& now) override;

private:
    Lattice lattice_;
    FaceGradients gradients_;
    double nu_;
    double rho_;
    std::array<double, 3> centre_;
    CsvOutput csv_;
};

} // namespace isph
