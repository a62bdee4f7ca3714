// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/exit_code.hpp"

namespace interphase {

/// Something the user can put right: what is wrong (with the value), where, what to do, and where it matters when.
struct Problem {
    std::string what, where, remedy;
    std::string when = "";  ///< it went wrong, and for how long
    std::string step = "";  ///< in which it ended the run
    ExitCode kind = ExitCode::refused;

    /// As a user reads it: what, and a line for each of the others that says something.
    std::string message() const
    {
        std::string all = what;
        if (!where.empty()) all += "\n  where:  " + where;
        if (!when.empty()) all += "\n  when:   " + when;
        if (!remedy.empty()) all += "\n  remedy: " + remedy;
        if (!step.empty()) all += "\n  when:   " + step;
        return all;
    }
};

/// Two told at once, each with its lines.
inline Problem followed_by(const Problem& first, Problem second)
{
    second.what = first.message() + "\n" + second.what;
    return second;
}

}  // namespace interphase
