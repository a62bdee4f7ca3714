// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/fake_dictionary.hpp"

#include "base/text.hpp"

namespace interphase::test {

std::size_t FakeDictionary::line_of(const std::string& key) const
{
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].key == key) return i + 1;
    return 0;
}

std::vector<std::string> FakeDictionary::keys() const
{
    std::vector<std::string> all;
    for (const Entry& entry : entries_)
        all.push_back(entry.key);
    return all;
}

std::unique_ptr<Dictionary> FakeDictionary::block(const std::string& key) const
{
    const auto entries = as<Block>(key);
    return entries ? std::unique_ptr<Dictionary>(new FakeDictionary(*entries, path_ + "." + key)) : nullptr;
}

std::string FakeDictionary::written(const std::string& key) const
{
    if (const auto value = number(key)) return interphase::text(*value);
    if (const auto value = text(key)) return *value;
    return as<Block>(key) ? "{...}" : "(...)";
}

std::string FakeDictionary::place(const std::string& key) const
{
    return has(key) ? path_ + ", line " + std::to_string(line_of(key)) : path_;
}

}  // namespace interphase::test
