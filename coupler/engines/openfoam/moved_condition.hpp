// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/archive.hpp"
#include "dictionary.H"

namespace interphase {

/// A boundary condition as one rank of an earlier run has written it, and which of its faces are which here.
struct ConditionPart {
    Foam::dictionary dict;
    int faces;  ///< that the patch had there
    const std::vector<Archive::Move>* moves;
};

/// The condition of a patch that has `faces` here, of `parts`, all that there were: fields with a value for each face
/// go with the faces, all else must be alike. Throws a std::runtime_error with the name of an entry that is not, or
/// whose values cannot be told apart by face; `where` names field and patch.
Foam::dictionary moved_condition(const std::vector<ConditionPart>& parts, int faces, const std::string& where);

}  // namespace interphase
