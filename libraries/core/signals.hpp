#pragma once

namespace isph
{

/// From now on SIGINT and SIGTERM only take note; a program with a time loop asks for them at each step's end.
/// A second signal ends the program at once.
void catchSignals();

/// The signal that came, or 0.
int caughtSignal();

/// Thrown by a time loop after it has written its state, so that runApplication returns 128 + signal.
struct StoppedBySignal
{
    int signal;
};

} // namespace isph
