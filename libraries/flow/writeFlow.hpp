#pragma once

#include "case/Case.hpp"
#include "case/TimeState.hpp"
#include "flow/Scene.hpp"

namespace isph
{

/// Writes a time folder: U and p (boundary conditions as at the start, values in fields.h5), fields.h5 with the values
/// and the marching state, uniform/time. It appears under its name only when complete. \throws Error(input) when the
/// machine refuses; earlier folders are untouched.
void writeFlow(const Case& flowCase, const std::string& timeName, const TimeState& state, const Scene& scene,
               IncompressibleFlow& flow);

} // namespace isph
