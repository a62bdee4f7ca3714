// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/stopwatch.hpp"

namespace interphase {

namespace {

constexpr double seconds_between_lines = 5;
constexpr double unknown_end = 1e30;  // [s]

std::string duration(double seconds)
{
    char text[32];
    const long s = std::lround(seconds);
    if (s >= 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld", s / 60, s % 60);
    return text;
}

std::string share_in_percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, share > 0 && share < 1e-5 ? "< 0.001 %%" : "%.3f %%", 100 * share);
    return text;
}

/// All of them, also those that are 0: it is good to know what did not happen.
void tell_counts(const Report::Summary& of)
{
    if (of.counts.empty()) return;
    std::printf("\n  counted                                             number      share\n");
    bool some = false;
    for (const Count& count : of.counts) {
        const std::optional<double> share = share_of(count, of.wholes);
        const bool any = count.value > 0;
        some = some || any;
        std::printf("    %-43s %12s", count.kind->text, amount(count).c_str());
        if (any)
            std::printf(" %10s   %s", share ? share_in_percent(*share).c_str() : "", verdict(count, of.wholes).c_str());
        std::printf("\n");
    }
    if (some) std::printf("    what they are, and when to worry: interphase -help counts\n");
}

}  // namespace

Report::Report(bool prints, double start_time, double end_time)
    : prints_(prints), start_time_(start_time), part_start_(start_time), end_time_(end_time), wall_start_(wall_clock())
{}

void Report::end_at(double end_time)
{
    if (prints_ && end_time < unknown_end) {
        std::printf("the end is now at t = %.6g s, no longer at %.6g s\n", end_time, end_time_);
        std::fflush(stdout);
    }
    end_time_ = end_time;
}

double Report::wall_seconds() const { return wall_clock() - wall_start_; }

void Report::head(const std::vector<std::pair<std::string, std::string>>& facts) const
{
    if (!prints_) return;
    for (const auto& [name, value] : facts)
        std::printf("  %-12s %s\n", name.c_str(), value.c_str());
    std::printf("\n");
    std::fflush(stdout);
}

bool Report::progress_due() const { return wall_clock() - last_line_ > seconds_between_lines; }

void Report::progress(double time, const Observation& seen)
{
    last_line_ = wall_clock();
    if (!prints_) return;
    const double done = time - start_time_, done_here = time - part_start_, wall = wall_seconds();
    const bool known = end_time_ < unknown_end;
    const double left = std::max(0.0, end_time_ - time);
    const std::string eta = known ? duration(done_here > 0 ? wall * left / done_here : 0) : "?";
    std::printf("t = %-9.4g s  %3.0f %%  %9.3g s/s  ETA %-8s ", time,
                done > 0 && known ? 100 * done / (done + left) : 0.0, done_here > 0 ? done_here / wall : 0.0,
                eta.c_str());
    if (seen.gas)
        std::printf("voidage %.3f..%.3f  Co %.2f  ", seen.gas->lowest_voidage, seen.gas->highest_voidage,
                    seen.gas->courant_number);
    std::printf("particles %ld\n", seen.particles);
    std::fflush(stdout);
}

void Report::note(const std::string& message) const
{
    if (prints_) std::printf("%s\n", message.c_str());
}

void Report::warn(const std::string& message) const
{
    if (!prints_) return;
    std::fflush(stdout);
    std::fprintf(stderr, "interphase: warning: %s\n", message.c_str());
    std::fflush(stderr);
}

void Report::summary(const Summary& of) const
{
    if (!prints_) return;
    const double wall = of.spent.wall, before = wall - wall_seconds();
    constexpr double shown = 0.5;  // [s]
    const std::string taken = duration(wall) + " of wall time" +
                              (before > shown ? ", " + duration(before) + " of them before it went on here" : "");
    if (of.stopped_by.empty())
        std::printf("\nReached t = %.6g s in %s.\n", of.simulated_time, taken.c_str());
    else
        std::printf("\nStopped by %s at t = %.6g s of %.6g s, after %s.\n", of.stopped_by.c_str(), of.simulated_time,
                    end_time_, taken.c_str());
    std::printf("\n  wall-clock time [s], the slowest rank's\n");
    for (std::size_t phase = 0; phase < phase_names.size(); ++phase)
        std::printf("    %-10s %10.2f  %5.1f %%\n", std::string(phase_names[phase]).c_str(), of.spent.seconds[phase],
                    100 * of.spent.seconds[phase] / wall);
    if (!of.balances.empty()) std::printf("\n  balances\n");
    for (const Account* account : of.balances)
        std::printf("    %s  %.1e %s\n", account->sides().c_str(), account->residual(), account->relative_to().c_str());

    bool titled = false;
    visit_passages(of.population, [&titled](const char*, const char* words, const Passage& passage) {
        if (passage.particles == 0 && passage.volume == 0) return;
        if (!titled)
            std::printf(
                "\n  came and went                                       particles  volume [m3]   momentum [kg m/s]\n");
        titled = true;
        const double(&p)[3] = passage.momentum;
        std::printf("    %-50s %8.0f  %11.4g   (%.3g %.3g %.3g)\n", words, passage.particles, passage.volume, p[0],
                    p[1], p[2]);
    });

    tell_counts(of);
    if (!of.way_to_go_on.empty()) std::printf("\n%s\n", of.way_to_go_on.c_str());
    std::fflush(stdout);
}

}  // namespace interphase
