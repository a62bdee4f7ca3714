// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/user_error.hpp"

namespace interphase {

/// `what` of the records could not be made or written, at `where`.
inline UserError unwritten(const std::string& what, const std::string& where)
{
    Problem problem{what, where,
                    "check that the folder can be written, that the disk is not full, and that no other program "
                    "holds the file"};
    problem.kind = ExitCode::disk;
    return UserError(problem);
}

}  // namespace interphase
