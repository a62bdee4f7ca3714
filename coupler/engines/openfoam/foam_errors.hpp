// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace interphase {

/// Runs `body`; what OpenFOAM throws in it becomes a UserError with OpenFOAM's own words, and with a way out where it
/// is known. `place`, given OpenFOAM's message, says where in the case it comes from, or nothing.
void with_foam_errors(
    const std::function<void()>& body,
    const std::function<std::string(const std::string&)>& place = [](const std::string&) { return std::string(); });

/// What to do about OpenFOAM's `message`, where more is known than that it says.
std::string remedy_for(const std::string& message);

/// Whether OpenFOAM found something missing in the registry of the mesh, as it does on all ranks alike.
bool asks_for_what_is_not_there(const std::string& message);

/// Whether two messages of OpenFOAM's are the same but for what is in the registry beside, which comes and goes.
bool same_complaint(const std::string& one, const std::string& other);

}  // namespace interphase
