#include "fields/threads.hpp"

#include <cstdlib>
#include <omp.h>

namespace isph
{

int useRequestedThreads()
{
    const char* asked = std::getenv("OMP_NUM_THREADS");
    if (asked == nullptr || *asked == '\0') { omp_set_num_threads(1); }
    return omp_get_max_threads();
}

} // namespace isph
