// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/count.hpp"

namespace interphase {

using CountKinds = std::vector<const CountKind*>;

/// What every run may count: the coupling step, drag, and the optional terms.
CountKinds counts_of_the_step();

/// All of them, and those of the engines and of plug-ins, as a page to be read in a terminal or as Markdown.
std::string count_page(const CountKinds& of_engines, const std::vector<CountKind>& of_plugins);

}  // namespace interphase
