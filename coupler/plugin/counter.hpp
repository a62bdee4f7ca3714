// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace interphase {

/// How the numbers of ranks become one.
enum class OverRanks : std::uint32_t { sum, largest };

/// For Counter::worry_above.
constexpr double never_worry = std::numeric_limits<double>::infinity();

/// What fixes of a plug-in count or measure of themselves from the start of a run on: a range that was left, a clamp, a
/// step that was too long. It stands in the summary of a run, in /counters of results.h5 and on the page `interphase
/// -help counts`. Texts are not empty.
///
///     constexpr interphase::Counter counters[] = {{"hits", "hits", "", OverRanks::sum, ...}};
///     INTERPHASE_COUNTERS(counters)
struct Counter {
    const char* key;   ///< letters, digits and `_`
    const char* text;  ///< for the summary, at most 43 letters
    const char* unit;  ///< empty for a number of things
    OverRanks over_ranks;
    double worry_above;   ///< it is to be looked at where it is more; 0, or never_worry
    const char* meaning;  ///< what happened, in sentences
    const char* reason;   ///< why it may be let be, or not: with a measurement
    const char* remedy;   ///< what to do about it; may be empty
};

/// What a fix answers for extract_counters: the numbers of this rank, in the order of the plug-in's counters. Of a run
/// that goes on they are of all its parts where the fix keeps them (restart_global).
struct CounterValues {
    std::uint64_t count;
    const double* values;
};

}  // namespace interphase
