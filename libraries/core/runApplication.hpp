#pragma once

#include "core/CommandLine.hpp"
#include "core/Log.hpp"

namespace isph
{

/// Runs a program: parses the command line, answers -help, -version and -list..., prints header and "End" (unless the
/// application wants no banner), and holds the one catch of the suite.
///
/// \return the exit code of the contract: 0 done, 1 bad input, 2 wrong command line, 3 diverged, 130/143 stopped by a
///         signal (signals.hpp). An std::exception that is not an Error is reported as a bug of ours with version and
///         command line, std::bad_alloc as memory refused; both return 1.
int runApplication(const Application& application, int argc, char** argv, void (*run)(const CommandLine&, Log&));

} // namespace isph
