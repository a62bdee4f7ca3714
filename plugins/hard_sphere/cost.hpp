// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <ctime>
#include <cstddef>

namespace interphase::hard_sphere {

enum class Part { outside, search, walls, contacts, integration, communication };

/// Wall-clock seconds of the parts of a step, on one rank.
class Cost {
public:
    void switch_to(Part part)
    {
        timespec t; clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t); const double now = t.tv_sec + 1e-9 * t.tv_nsec;
        seconds_[static_cast<std::size_t>(current_)] += now - since_;
        since_ = now;
        current_ = part;
    }
    double seconds(Part part) const { return seconds_[static_cast<std::size_t>(part)]; }

private:
    std::array<double, 6> seconds_{};
    Part current_ = Part::outside;
    double since_ = 0;
};

}  // namespace interphase::hard_sphere
