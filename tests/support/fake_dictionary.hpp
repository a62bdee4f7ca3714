// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "settings/dictionary.hpp"

namespace interphase::test {

/// Entries as a test gives them, one a line: FakeDictionary({{"weight", 8.0}, {"gas", Block{{"model", "none"}}}}). An
/// entry's place is "dict, line N", in a block "dict.gas, line N".
class FakeDictionary : public Dictionary {
public:
    struct Entry;
    using Block = std::vector<Entry>;
    using Names = std::vector<std::string>;
    using Points = std::vector<Vector>;
    using Numbers = Scalars;
    struct Entry {
        Entry(std::string name, double number) : key(std::move(name)), value(number) {}
        Entry(std::string name, const char* text) : key(std::move(name)), value(std::string(text)) {}
        Entry(std::string name, Names names) : key(std::move(name)), value(std::move(names)) {}
        Entry(std::string name, Numbers numbers) : key(std::move(name)), value(std::move(numbers)) {}
        Entry(std::string name, Points points) : key(std::move(name)), value(std::move(points)) {}
        Entry(std::string name, Block block) : key(std::move(name)), value(std::move(block)) {}

        std::string key;
        std::variant<double, std::string, Names, Numbers, Points, Block> value;
    };

    FakeDictionary(Block entries, std::string path = "dict") : entries_(std::move(entries)), path_(std::move(path)) {}

    std::vector<std::string> keys() const override;
    bool has(const std::string& key) const override { return line_of(key) > 0; }
    std::optional<double> number(const std::string& key) const override { return as<double>(key); }
    std::optional<std::string> text(const std::string& key) const override { return as<std::string>(key); }
    std::optional<Names> names(const std::string& key) const override { return as<Names>(key); }
    std::optional<Names> texts(const std::string& key) const override { return as<Names>(key); }
    std::optional<Numbers> numbers(const std::string& key) const override { return as<Numbers>(key); }
    std::optional<Points> points(const std::string& key) const override { return as<Points>(key); }
    std::unique_ptr<Dictionary> block(const std::string& key) const override;
    std::string written(const std::string& key) const override;
    std::string place(const std::string& key) const override;

private:
    std::size_t line_of(const std::string& key) const;  ///< from 1 on; 0 where it is not there

    template <class Value>
    std::optional<Value> as(const std::string& key) const
    {
        const auto* value = std::get_if<Value>(&entries_.at(line_of(key) - 1).value);
        return value ? std::optional<Value>(*value) : std::nullopt;
    }

    Block entries_;
    std::string path_;
};

}  // namespace interphase::test
