// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <array>

namespace interphase {

/// What signals ask of a run. SIGINT, SIGTERM, and SIGUSR2, which mpirun hands on to all ranks at once where it ends
/// them for the other two, ask it to end after the step in progress: the first one is noted, a second one ends the
/// process at once. SIGUSR1 asks for a checkpoint, each time. While an object lives; one object at a time.
class SignalRequests {
public:
    SignalRequests();
    ~SignalRequests();
    SignalRequests(const SignalRequests&) = delete;
    SignalRequests& operator=(const SignalRequests&) = delete;

    /// The signal that asked this rank to end; 0: none.
    int end() const;

    /// Whether this rank was asked for a checkpoint since the last call.
    bool take_checkpoint();

    /// E.g. "SIGINT".
    static const char* name_of(int signal);

private:
    static constexpr std::array<int, 4> signals{SIGINT, SIGTERM, SIGUSR2, SIGUSR1};

    std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace interphase
