// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stopwatch.hpp"

#include <chrono>
#include <ctime>

namespace interphase {

double wall_clock()
{
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

double Stopwatch::processor_now()
{
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace interphase
