// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user reads: numbers and vectors as people write them, lists, and the name that was probably meant.
#include "base/text.hpp"

#include <gtest/gtest.h>

namespace {

using namespace interphase;

const std::vector<std::string> laws{"BVK", "WenYu", "Ergun", "Gidaspow", "DiFelice"};

TEST(Text, NumbersHaveNoTrailingZeros)
{
    EXPECT_EQ(text(0.05), "0.05");
    EXPECT_EQ(text(95000.0), "95000");
    EXPECT_EQ(text(1.7e-5), "1.7e-05");
    EXPECT_EQ(text(1.0 / 3.0), "0.333333");
}

TEST(Text, VectorsReadAsInOpenFoam) { EXPECT_EQ(text(Vector(0.1, 0, -9.81)), "(0.1 0 -9.81)"); }

TEST(Text, ListsAreCommaSeparated)
{
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a"}), "a");
    EXPECT_EQ(listed({"a", "b", "c"}), "a, b, c");
}

TEST(NearestName, FindsSlipsOfThePen)
{
    EXPECT_EQ(nearest_name("Gidaspov", laws), "Gidaspow");  // substituted
    EXPECT_EQ(nearest_name("Ergunn", laws), "Ergun");       // one too many
    EXPECT_EQ(nearest_name("WnYu", laws), "WenYu");         // one missing
    EXPECT_EQ(nearest_name("DiFelcie", laws), "DiFelice");  // swapped
    EXPECT_EQ(nearest_name("bvk", {"BVK"}), "");            // no letter in common: three edits of three
    EXPECT_EQ(nearest_name("BVK", laws), "BVK");
}

TEST(NearestName, OfTwoTheNearer)
{
    EXPECT_EQ(nearest_name("endTim", {"startTime", "endTime", "end"}), "endTime");
    EXPECT_EQ(nearest_name("interval", {"intervals", "snapshotInterval"}), "intervals");
}

TEST(NearestName, SuggestsNothingForSomethingElse)
{
    EXPECT_EQ(nearest_name("turbulence", laws), "");
    EXPECT_EQ(nearest_name("anything", {}), "");
}

TEST(Box, GrowsAroundPointsAndKnowsWhatItHolds)
{
    Box box = empty_box();
    EXPECT_FALSE(contains(box, Vector::Zero()));
    extend(box, {1, 2, 3});
    extend(box, {-1, 0, 5});
    EXPECT_TRUE(contains(box, {0, 1, 4}));
    EXPECT_TRUE(contains(box, {1, 2, 3}));  // its rim belongs to it
    EXPECT_FALSE(contains(box, {0, 1, 5.001}));

    Box other = empty_box();
    extend(other, {1, 2, 5});
    extend(other, {7, 7, 7});
    EXPECT_TRUE(overlap(box, other));  // they share a corner
    extend(other = empty_box(), {1.001, 2, 5});
    EXPECT_FALSE(overlap(box, other));
    EXPECT_FALSE(overlap(box, empty_box()));
}

}  // namespace
