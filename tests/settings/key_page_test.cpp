// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of keys: those outside of blocks first, then each block with its own.
#include "settings/key_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "settings/read_settings.hpp"
#include "support/methods.hpp"

namespace {

using namespace interphase;

TEST(KeyPage, GroupsKeysByBlock)
{
    const std::string page = key_page({{"", "first", "number [s], above 0", "2", "how long it takes"},
                                       {"", "box", "", "", "what it is in"},
                                       {"box", "width", "number [m], above 0", "", "how wide the box is"},
                                       {"box", "own", "", "", "whatever you like"},
                                       {"", "last", "yes | no", "no", "whether it ends"}});
    EXPECT_NE(page.find("\n- `first`: number [s], above 0; default: 2.\n  How long it takes.\n"
                        "- `last`: yes | no; default: no.\n  Whether it ends.\n"
                        "\n## box { }\n\nWhat it is in.\n\n"
                        "- `width`: number [m], above 0; must be given.\n  How wide the box is.\n"
                        "\n## box.own { }\n\nWhatever you like.\n"),
              std::string::npos)
        << page;
}

TEST(KeyPage, HasEveryKeyOnce)
{
    const std::vector<KeyDescription> keys = setting_keys(test::FakeMethods());
    ASSERT_FALSE(keys.empty());
    for (const KeyDescription& key : keys) {
        const auto same = [&](const KeyDescription& k) { return k.name == key.name && k.block == key.block; };
        EXPECT_EQ(std::count_if(keys.begin(), keys.end(), same), 1) << key.block << '.' << key.name;
        EXPECT_FALSE(key.meaning.empty()) << key.name;
        EXPECT_NE(key_page(keys).find(key.name), std::string::npos) << key.name;
    }
}

}  // namespace
