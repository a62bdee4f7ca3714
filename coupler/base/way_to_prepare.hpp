// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase {

/// How a case that lacks what is made before a run, such as its mesh, comes by it: the current folder is the case's.
std::string way_to_prepare();

}  // namespace interphase
