// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace interphase {

/// What a count is a part of.
enum class Whole { particle_steps, cell_steps, gas_steps, particles, nothing };

/// How many there were: of particles in each gas step and of cells in each, of gas steps, of particles at the start and
/// inserted.
struct Wholes {
    double particle_steps = 0, cell_steps = 0, gas_steps = 0, particles = 0;
    double of(Whole whole) const;  ///< 0 where there is none
};

/// When a count is to be looked at.
enum class Worry {
    share,  ///< above `tolerable_share`, weighed with how far off each is
    any,    ///< as soon as there is one
    above,  ///< the `limit` of its kind
    never
};

/// What is off in a hundredth of all places and steps, and there by no more than its own size, moves a mean over all of
/// them by at most 1 %. The drop of sscp1, the best known mean of our own, has a standard error of 0.4 %, and drag laws
/// that claim the same range differ by more (tests/forces/drag).
constexpr double tolerable_share = 0.01;

/// What is counted, and when to worry; it stands beside the code that counts. The summary of a run and the page
/// `interphase -help counts` take their words from here.
struct CountKind {
    const char* key;   ///< as records name it
    const char* text;  ///< as the summary does
    Whole whole;
    const char* meaning;  ///< what happened, in sentences
    Worry worry;
    const char* reason;     ///< why it may be let be, or not: with a measurement
    const char* remedy;     ///< what to do about it; empty where there is nothing
    double limit = 0;       ///< for Worry::above
    const char* unit = "";  ///< of something that is measured, not counted
};

/// Something that was counted since the start, and is told: a range that was left, a clamp, a step that was too long.
struct Count {
    Count(const CountKind& of, long how_many, double how_far_off) : kind(&of), number(how_many), off(how_far_off) {}
    Count(const CountKind& of, long how_many) : Count(of, how_many, static_cast<double>(how_many)) {}

    /// Of something that is measured, or counted in broken numbers.
    static Count measured(const CountKind& of, double value)
    {
        Count count(of, static_cast<long>(value));
        count.value = value;
        return count;
    }

    const CountKind* kind;
    long number;
    double value = static_cast<double>(number);  ///< the same
    double off;  ///< how far each of them is off, relative to itself, summed up; where nobody knows, 1 each
};

/// The number over its whole; none where there is no whole.
std::optional<double> share_of(const Count& count, const Wholes& wholes);

/// What the share comes to in a mean of all; none where there is no whole.
std::optional<double> weighed_share(const Count& count, const Wholes& wholes);

/// Whether it is one to worry about.
bool to_be_looked_at(const Count& count, const Wholes& wholes);

/// "ordinary", "look at it: ..."; empty where there is none.
std::string verdict(const Count& count, const Wholes& wholes);

/// "of the particles, step by step".
std::string name_of(Whole whole);

/// "0.37 %".
std::string percent(double share);

/// "241,021".
std::string with_separators(long number);

/// The same of a count, or "0.031 d" of what has a unit.
std::string amount(const Count& count);

}  // namespace interphase
