// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "support/mapped_spheres.hpp"

namespace interphase::test {

/// Above any solid fraction that a test has.
constexpr double no_limit = 1e9;

/// Sizes of spheres, in cells of about unit size, and the rules by which they are mapped.
struct Sizing {
    std::string name;
    std::function<double(std::size_t)> diameter;
    MappingRules rules;
};

inline std::vector<Sizing> sizings()
{
    const auto all = [](double diameter) { return [diameter](std::size_t) { return diameter; }; };
    MappingRules rules, given, cell_centre;
    rules.maximum_packing = given.maximum_packing = cell_centre.maximum_packing = no_limit;
    given.width = 2.5;
    cell_centre.type = MappingType::cell_centre;
    return {
        {"d = 0.05", all(0.05), rules},
        {"d = 0.5", all(0.5), rules},
        {"d = 1.5", all(1.5), rules},
        {"d = 5", all(5.0), rules},
        {"d = 0.2 to 2", [](std::size_t i) { return 0.2 * std::pow(10, 0.5 + 0.5 * noise(i)); }, rules},
        {"width 2.5", [](std::size_t i) { return i % 2 == 0 ? 0.3 : 3.0; }, given},
        {"cell centre", all(0.5), cell_centre},
    };
}

}  // namespace interphase::test
