// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase::test {

/// What a test measures: a line of tests/VALIDATION.md.
struct Quantity {
    std::string name;    ///< what was measured, in which scene
    std::string unit;    ///< "": a pure number
    std::string source;  ///< of the right value: a paper, a closed solution, another program
};

/// Each of these expects, as EXPECT_NEAR, EXPECT_LT and EXPECT_GT do, and records the number and the limit that it
/// expects by where `tools/test --record` asks for it: a row in a file of the running test, by rank 0. Every rank has
/// to give the same value. tests/program/measured.py is the same for Python.
void expect_within(const Quantity& quantity, double value, double reference, double limit);
void expect_below(const Quantity& quantity, double value, double limit);
void expect_above(const Quantity& quantity, double value, double limit);

}  // namespace interphase::test
