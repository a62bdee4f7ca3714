// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/vector.hpp"

namespace interphase {

/// A number as a person writes it: up to six significant digits, no trailing zeros.
std::string text(double value);

/// "(x y z)", as OpenFOAM writes a vector.
std::string text(const Vector& value);

/// The member of `names` that takes the fewest edits (Levenshtein distance) to become `word`; empty where none is
/// nearer than half the word's length.
std::string nearest_name(const std::string& word, const std::vector<std::string>& names);

bool is_among(const std::string& name, const std::vector<std::string>& names);

/// "a, b, c".
std::string listed(const std::vector<std::string>& names);

}  // namespace interphase
