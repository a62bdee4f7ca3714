// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <array>

namespace interphase {

/// Signals that ask a run to end after the step in progress: SIGINT, SIGTERM, and SIGUSR2, which mpirun hands on to all
/// ranks at once, where it ends them for the other two. While an object lives, the first one is noted and a second one
/// ends the process at once. One object at a time. SIGUSR1 is left free: it will ask for a checkpoint.
class StopRequest {
public:
    StopRequest();
    ~StopRequest();
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;

    /// The signal that came to this rank; 0: none.
    int signal() const;

    /// E.g. "SIGINT".
    static const char* name_of(int signal);

private:
    static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGUSR2};

    std::array<struct sigaction, 3> before_{};
};

}  // namespace interphase
