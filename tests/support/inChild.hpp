#pragma once

#include <sys/wait.h>
#include <unistd.h>

namespace isph
{

/// Runs work in a child process (one that may be killed, limited, or hold locks) and returns its wait status.
/// The child ends with the code that work returns.
inline int inChild(auto&& work)
{
    const pid_t child = fork();
    if (child == 0) { _exit(work()); }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

} // namespace isph
