// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase {

/// `file`-`words`, or with a number behind where there is a file or a folder of that name.
std::string free_name(const std::string& file, const std::string& words);

}  // namespace interphase
