// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/method.hpp"

namespace interphase {

/// Those that LIGGGHTS has without a plug-in, and the one for plug-ins that bring none of their own.
Methods own_methods();

}  // namespace interphase
