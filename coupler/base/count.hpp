// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase {

/// Something that was counted since the start, and is told: a range that was left, a clamp, a step that was too long.
struct Count {
    std::string key;   ///< as records name it
    std::string text;  ///< as the summary does
    long number = 0;
};

}  // namespace interphase
