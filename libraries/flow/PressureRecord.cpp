#include "flow/PressureRecord.hpp"

#include <fmt/format.h>

namespace isph
{

std::string PressureRecord::line() const
{
    return fmt::format("{}:  Solving for p, Initial residual = {:.6g}, Final residual = {:.6g}, No Iterations {}", name,
                       last.initialResidual, last.finalResidual, last.iterations);
}

} // namespace isph
