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

/// Its bytes could be copied, and with them the place of what it refers to.
struct Referring {
    const int& of_the_run;
    int number;
    void keep(Archive& archive) { archive.keep("number", number); }
};
static_assert(std::is_trivially_copyable_v<Referring>);

TEST(Archive, AsksAnObjectThatKeepsItself)
{
    const int first = 1, second = 2;
    Referring before{first, 10}, after{second, 20};
    Archive saved;
    saved.keep("object", before);
    Archive loaded = saved.to_load();
    loaded.keep("object", after);
    EXPECT_EQ(after.number, 10);
    EXPECT_EQ(&after.of_the_run, &second);
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
