// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace interphase {

enum class Phase { solids, gas, mapping, exchange, output, waiting, setup };

constexpr std::array<std::string_view, 7> phase_names{"solids", "gas",     "mapping", "exchange",
                                                      "output", "waiting", "setup"};

/// Shares a rank's wall-clock time out among the phases of the run: at any moment exactly one phase runs.
class Stopwatch {
public:
    explicit Stopwatch(Phase first) : phase_(first), since_(now()) {}

    void switch_to(Phase phase)
    {
        const double time = now();
        seconds_[static_cast<std::size_t>(phase_)] += time - since_;
        since_ = time;
        phase_ = phase;
    }

    Phase current() const { return phase_; }

    /// Up to the last switch.
    double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

private:
    static double now();

    Phase phase_;
    double since_;
    std::array<double, phase_names.size()> seconds_{};
};

}  // namespace interphase
