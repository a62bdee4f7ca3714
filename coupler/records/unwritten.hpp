// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <string>

#include "base/disk_room.hpp"
#include "base/user_error.hpp"

namespace interphase {

/// `what` of the records could not be made or written, at `where`.
inline UserError unwritten(const std::string& what, const std::string& where)
{
    const bool full = disk_is_full(static_cast<int>(getpid()));
    Problem problem{full ? "the disk is full: " + what : what, where,
                    full ? "make room, or record less"
                         : "check that the folder can be written, and that no other program holds the file"};
    problem.kind = ExitCode::disk;
    return UserError(problem);
}

}  // namespace interphase
