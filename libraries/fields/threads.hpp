#pragma once

namespace isph
{

/// Takes as many threads as OMP_NUM_THREADS says, one if it says nothing: on a busy machine more are no gift. To be
/// called before anything is planned. \return the number of threads that loops and transforms use from now on
int useRequestedThreads();

} // namespace isph
