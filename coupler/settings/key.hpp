// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace interphase {

/// A key as the one who reads it gives it. The meaning is a phrase without capital and full stop, as it stands in
/// brackets of a complaint and, made a sentence, in the documentation.
struct Key {
    std::string name, meaning;
    std::string unit = "";      ///< SI; empty: none
    std::string fallback = "";  ///< the default in words, where it is no single value
    std::string values = "";    ///< a number's range in words, where that depends on other keys
};

/// The numbers that are allowed, in words and as a check.
struct Range {
    std::string words;
    std::function<bool(double)> holds;
};

Range any_number();
Range above(double limit);
Range at_least(double limit);
Range between(double low, double high);  ///< without the two
Range from_to(double low, double high);  ///< with them

/// What a user may want to know of a key.
struct KeyDescription {
    std::string block;  ///< "" outside of all
    std::string name;
    std::string values;    ///< kind, unit and range, or the choices; empty for a block
    std::string fallback;  ///< the default; empty where the key must be given
    std::string meaning;
};

}  // namespace interphase
