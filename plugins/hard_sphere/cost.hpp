// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace interphase::hard_sphere {

enum class Part { outside, search, walls, contacts, integration, communication };

/// Wall-clock seconds of the parts of a step, on one rank.
class Cost {
public:
    void switch_to(Part part)
    {
        const auto now = std::chrono::steady_clock::now();
        seconds_[static_cast<std::size_t>(current_)] += std::chrono::duration<double>(now - since_).count();
        since_ = now;
        current_ = part;
    }
    double seconds(Part part) const { return seconds_[static_cast<std::size_t>(part)]; }

private:
    std::array<double, 6> seconds_{};
    Part current_ = Part::outside;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace interphase::hard_sphere
