#include "spectral/FftwPlan.hpp"

#include "core/Error.hpp"

#include <mutex>

namespace isph
{

void withPlanner(int threads, const std::function<void()>& planner)
{
    static std::mutex one;
    const std::lock_guard guard(one);
    // The threads of FFTW are initialised once per process.
    static const bool initialised = fftw_init_threads() != 0;
    if (!initialised) { throw Error(Fault::input, "the threads of FFTW could not be started"); }
    fftw_plan_with_nthreads(threads);
    planner();
}

} // namespace isph
