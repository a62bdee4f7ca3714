// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace interphase {

enum class Phase { solids, gas, mapping, exchange, output, waiting, setup };

constexpr std::array<std::string_view, 7> phase_names{"solids", "gas",     "mapping", "exchange",
                                                      "output", "waiting", "setup"};

/// Of the wall clock, from some moment on [s].
double wall_clock();

/// Shares a rank's time out among the phases of the run, by the wall clock and by what its processor gave it: at any
/// moment exactly one phase runs.
class Stopwatch {
public:
    explicit Stopwatch(Phase first) : phase_(first), since_(wall_clock()), processor_since_(processor_now()) {}

    void switch_to(Phase phase)
    {
        const double time = wall_clock(), processor = processor_now();
        seconds_[static_cast<std::size_t>(phase_)] += time - since_;
        processor_[static_cast<std::size_t>(phase_)] += processor - processor_since_;
        since_ = time;
        processor_since_ = processor;
        phase_ = phase;
    }

    Phase current() const { return phase_; }

    /// By the wall clock, up to the last switch.
    double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

    /// Of the processor, up to the last switch. Waiting for other ranks is work to it.
    double processor_seconds(Phase phase) const { return processor_[static_cast<std::size_t>(phase)]; }

private:
    static double processor_now();

    Phase phase_;
    double since_, processor_since_;
    std::array<double, phase_names.size()> seconds_{}, processor_{};
};

}  // namespace interphase
