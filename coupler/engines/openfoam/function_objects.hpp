// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "Time.H"

namespace interphase {

/// Time::run(), with its function objects; `goes_on`: where the run did not start at the case's start
/// (resumed_functions.hpp). A UserError where one of `functions` in system/controlDict would be wrong
/// for a gas among particles, or was not made, which OpenFOAM tells in its log only, or ends the process for.
bool run_with_function_objects(Foam::Time& time, bool goes_on);

/// Where the function object stands that fails with OpenFOAM's `message`; empty where it is none or cannot be known.
/// For messages that all ranks have.
std::string failing_function(const Foam::Time& time, const std::string& message);

}  // namespace interphase
