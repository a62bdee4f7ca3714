// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "settings/key.hpp"

namespace interphase {

/// The keys as a page to be read in a terminal or as Markdown: those outside of blocks first, then block by block.
std::string key_page(const std::vector<KeyDescription>& keys);

}  // namespace interphase
