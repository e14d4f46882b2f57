#pragma once

#include "case/Case.hpp"
#include "case/TimeState.hpp"
#include "transport/TransportScene.hpp"

#include <string>

namespace isph
{

/// Writes <timeName>/T, fields.h5 and uniform/time; the folder appears when it is complete. The values of T are the
/// marching state, bit by bit.
/// \throws Error(input) if it cannot be written; folders of that name stay as they are.
void writeTransport(const Case& theCase, const std::string& timeName, const TimeState& state,
                    const TransportScene& scene, const ScalarTransport& transport);

} // namespace isph
