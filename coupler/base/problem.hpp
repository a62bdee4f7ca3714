// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase {

/// Something the user can put right: what is wrong (with the value), where, what to do, and where it matters when.
struct Problem {
    std::string what, where, remedy;
    std::string when = "";

    /// As a user reads it: what, and a line for each of the others that says something.
    std::string message() const
    {
        std::string all = what;
        if (!where.empty()) all += "\n  where:  " + where;
        if (!when.empty()) all += "\n  when:   " + when;
        if (!remedy.empty()) all += "\n  remedy: " + remedy;
        return all;
    }
};

/// Adds a time to the ones that the problem tells already.
inline Problem at_time(Problem problem, const std::string& when)
{
    problem.when += (problem.when.empty() ? "" : ", ") + when;
    return problem;
}

/// Two told at once, each with its lines.
inline Problem followed_by(const Problem& first, Problem second)
{
    second.what = first.message() + "\n" + second.what;
    return second;
}

}  // namespace interphase
