// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/key_page.hpp"

#include <cctype>

namespace interphase {

namespace {

std::string sentence(std::string phrase)
{
    phrase[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(phrase[0])));
    return phrase + ".";
}

bool is_block(const KeyDescription& key) { return key.values.empty(); }

std::string keys_of(const std::string& block, const std::vector<KeyDescription>& keys)
{
    std::string page;
    for (const KeyDescription& key : keys)
        if (!is_block(key) && key.block == block)
            page += "- `" + key.name + "`: " + key.values + "; " +
                    (key.fallback.empty() ? "must be given" : "default: " + key.fallback) + ".\n  " +
                    sentence(key.meaning) + "\n";
    return page;
}

}  // namespace

std::string key_page(const std::vector<KeyDescription>& keys)
{
    std::string page =
        "# Keys of system/couplingDict\n\nAs `interphase -help keys` prints them. Units are in brackets; unknown keys "
        "are "
        "refused with the nearest valid name.\n\n" +
        keys_of("", keys);
    for (const KeyDescription& block : keys) {
        if (!is_block(block)) continue;
        const std::string path = (block.block.empty() ? "" : block.block + ".") + block.name;
        const std::string inside = keys_of(path, keys);
        page += "\n## " + path + " { }\n\n" + sentence(block.meaning) + "\n" + (inside.empty() ? "" : "\n" + inside);
    }
    return page;
}

}  // namespace interphase
