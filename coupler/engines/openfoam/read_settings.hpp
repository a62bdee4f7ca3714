// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fileName.H"
#include "settings/settings.hpp"

namespace interphase {

/// Reads and checks system/couplingDict of the case folder `root`. Throws a UserError.
Settings read_coupling_dict(const Foam::fileName& root);

}  // namespace interphase
