// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stopwatch.hpp"

#include <chrono>

namespace interphase {

double Stopwatch::now()
{
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace interphase
