#pragma once

#include <fftw3.h>
#include <functional>
#include <memory>

namespace isph
{

struct FftwPlanDeleter
{
    void operator()(fftw_plan_s* plan) const { fftw_destroy_plan(plan); }
};

/// A plan of FFTW. Internal to spectral.
using FftwPlan = std::unique_ptr<fftw_plan_s, FftwPlanDeleter>;

/// Runs a planner: FFTW's is not thread-safe, so one at a time. Its plans will use this many threads.
/// \throws Error(input) if the threads of FFTW cannot be started.
void withPlanner(int threads, const std::function<void()>& planner);

} // namespace isph
