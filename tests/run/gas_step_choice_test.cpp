// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/gas_step_choice.hpp"

#include <gtest/gtest.h>

namespace {

using interphase::adjusted_gas_step;

constexpr double solid = 1e-5, last = 1e-3, no_limit = 1e300;

TEST(AdjustedGasStep, ShrinksAtOnceWhereTheCourantNumberIsTooLarge)
{
    EXPECT_DOUBLE_EQ(adjusted_gas_step({last, solid, 2.0, 0.5, no_limit}), last / 4);
}

TEST(AdjustedGasStep, GrowsByAFifthAtMost)
{
    EXPECT_DOUBLE_EQ(adjusted_gas_step({last, solid, 0.1, 1.0, no_limit}), 1.2 * last);
    EXPECT_DOUBLE_EQ(adjusted_gas_step({last, solid, 0.9, 0.99, no_limit}), 1.1 * last);
}

TEST(AdjustedGasStep, GrowsByAWholeSolidStepOrItNeverWould)
{
    EXPECT_DOUBLE_EQ(adjusted_gas_step({2 * solid, solid, 0.1, 1.0, no_limit}), 3 * solid);
}

TEST(AdjustedGasStep, StaysWhereNothingMoves)
{
    EXPECT_DOUBLE_EQ(adjusted_gas_step({last, solid, 0, 1.0, no_limit}), last);
}

TEST(AdjustedGasStep, ObeysWhatIsAllowed)
{
    EXPECT_DOUBLE_EQ(adjusted_gas_step({last, solid, 0.1, 1.0, 0.7 * last}), 0.7 * last);
    EXPECT_DOUBLE_EQ(adjusted_gas_step({last, solid, 0, 1.0, 0.7 * last}), 0.7 * last);
}

}  // namespace
