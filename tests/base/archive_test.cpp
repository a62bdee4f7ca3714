// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/archive.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace {

using interphase::Archive;

struct Inner {
    double number = 0;
    std::vector<int> list;

    void keep(Archive& archive)
    {
        archive.keep("number", number);
        archive.keep("list", list);
    }
};

struct Outer {
    std::optional<double> maybe;
    Inner first, second;
    std::vector<Inner> several;

    void keep(Archive& archive)
    {
        archive.keep("maybe", maybe);
        archive.keep("first", first);
        archive.keep("second", second);
        archive.keep("several", several);
    }
};

TEST(Archive, GivesBackWhatItTookIn)
{
    Outer before;
    before.maybe = 2.5;
    before.first = {1.0 / 3, {1, 2, 3}};
    before.second = {-1, {}};
    before.several = {{7, {8}}, {9, {10, 11}}};
    Archive saved;
    before.keep(saved);

    Outer after;
    after.second.list = {5};
    Archive loaded = saved.to_load();
    after.keep(loaded);
    EXPECT_EQ(after.maybe, before.maybe);
    EXPECT_EQ(after.first.number, before.first.number);
    EXPECT_EQ(after.first.list, before.first.list);
    EXPECT_TRUE(after.second.list.empty());
    ASSERT_EQ(after.several.size(), 2u);
    EXPECT_EQ(after.several[1].list, before.several[1].list);
}

TEST(Archive, NamesWhatIsMissing)
{
    Inner inner;
    Archive empty = Archive().to_load();
    try {
        empty.within("outer", [&] { inner.keep(empty); });
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("outer/number"), std::string::npos) << error.what();
    }
}

TEST(Archive, RefusesAnotherSize)
{
    Archive saved;
    int number = 1;
    saved.keep("number", number);
    Archive loaded = saved.to_load();
    double other = 0;
    EXPECT_THROW(loaded.keep("number", other), std::runtime_error);
}

}  // namespace
