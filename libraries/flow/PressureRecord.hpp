#pragma once

#include "linear/KrylovSolver.hpp"

#include <string>

namespace isph
{

/// What the iterations for the pressure took in steps so far.
struct PressureRecord
{
    std::string name; ///< of the solver
    long solves = 0;
    long iterations = 0;
    int mostIterations = 0;
    double largestResidual = 0; ///< of a solution
    long unconverged = 0;       ///< solves that stopped above the tolerance
    KrylovResult last;

    double meanIterations() const
    {
        return solves > 0 ? static_cast<double>(iterations) / static_cast<double>(solves) : 0;
    }

    /// "BiCGStab:  Solving for p, Initial residual = 0.01, Final residual = 8e-11, No Iterations 12", of the last one.
    std::string line() const;
};

} // namespace isph
