// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "settings/method.hpp"

namespace interphase {

/// The methods as a page to be read in a terminal or as Markdown. Our tools read its table, too.
std::string method_page(const Methods& methods);

}  // namespace interphase
