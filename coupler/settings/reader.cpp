// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/reader.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

namespace interphase {

namespace {

std::string alternatives(const std::vector<std::string>& names)
{
    std::string all;
    for (const std::string& name : names)
        all += (all.empty() ? "" : " | ") + name;
    return all;
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& names)
{
    const std::string near = nearest_name(name, names);
    return near.empty() ? "" : "did you mean `" + near + "`? ";
}

}  // namespace

void Reader::ask(const Key& key, const std::string& values, const std::string& fallback)
{
    if (!is_among(key.name, known_)) known_.push_back(key.name);
    if (descriptions_)
        descriptions_->push_back(
            {block_, key.name, values, key.fallback.empty() ? fallback : key.fallback, key.meaning});
}

void Reader::number(const Key& key, double& value, const Range& range)
{
    const std::string unit = key.unit.empty() ? "" : " [" + key.unit + "]";
    ask(key, "number" + unit + ", " + (key.values.empty() ? range.words : key.values), text(value));
    if (!has(key.name)) return;
    const auto given = dictionary_->number(key.name);
    if (!given || !range.holds(*given))
        throw complaint(key.name,
                        "`" + key.name + " " + (given ? text(*given) : dictionary_->written(key.name)) +
                            ";` is not accepted: it must be a number" + unit + ", " + range.words + " (" + key.meaning +
                            ")",
                        "correct the value (SI units)");
    value = *given;
}

void Reader::number(const Key& key, std::optional<double>& value, const Range& range)
{
    double given = value.value_or(0);
    number(key, given, range);
    if (has(key.name)) value = given;
}

void Reader::whole_number(const Key& key, double& value)
{
    number(key, value, {"a whole number above 0", [](double given) {
                            return given >= 1 && given <= 1e6 && given == std::floor(given);
                        }});
}

void Reader::numbers(const Key& key, Scalars& value, const Range& range, Order order)
{
    std::string fallback;
    for (const double number : value)
        fallback += (fallback.empty() ? "" : " ") + text(number);
    const std::string unit = key.unit.empty() ? "" : " [" + key.unit + "]";
    const std::string demand =
        "list of numbers" + unit + ", " + range.words + (order == Order::ascending ? ", ascending" : "");
    ask(key, demand, "(" + fallback + ")");
    if (!has(key.name)) return;
    const auto given = dictionary_->numbers(key.name);
    bool good = given && !given->empty();
    for (std::size_t n = 0; good && n < given->size(); ++n)
        good = range.holds((*given)[n]) && (order == Order::any || n == 0 || (*given)[n] > (*given)[n - 1]);
    if (!good)
        throw complaint(key.name,
                        "`" + key.name + " " + dictionary_->written(key.name) + ";` is not accepted: it must be a " +
                            demand + " (" + key.meaning + ")",
                        "write `" + key.name + " (a b c);` with such numbers");
    value = *given;
}

void Reader::vector(const Key& key, std::optional<Vector>& value)
{
    ask(key, "(x y z) [" + key.unit + "]", "none");
    if (!has(key.name)) return;
    const auto given = dictionary_->numbers(key.name);
    if (!given || given->size() != 3)
        throw complaint(
            key.name, "`" + key.name + " " + dictionary_->written(key.name) + ";` is not accepted: it must be a point",
            "write `" + key.name + " (x y z);`");
    value = to_vector(given->data());
}

UserError Reader::nothing_there(const Key& key, const std::string& name, const std::string& shown,
                                const std::vector<std::string>& choices) const
{
    return complaint(key.name, "`" + key.name + " " + shown + ";` names nothing that is there",
                     did_you_mean(name, choices) + "choose one of " + listed(choices));
}

std::string Reader::word(const std::string& key) const
{
    return has(key) ? dictionary_->text(key).value_or(dictionary_->written(key)) : "";
}

std::size_t Reader::choose(const Key& key, std::size_t fallback, const std::vector<std::string>& choices)
{
    ask(key, alternatives(choices), choices[fallback]);
    if (!has(key.name)) return fallback;
    const std::string name = word(key.name);
    const auto found = std::find(choices.begin(), choices.end(), name);
    if (found == choices.end()) throw nothing_there(key, name, name, choices);
    return static_cast<std::size_t>(found - choices.begin());
}

void Reader::choice(const Key& key, std::string& value, const std::vector<std::string>& choices)
{
    Choices<std::string> by_name;
    for (const std::string& name : choices)
        by_name.emplace_back(name, name);
    choice(key, value, by_name);
}

void Reader::required_text(const Key& key, std::string& value, const std::string& remedy)
{
    ask(key, "text", "");
    if (!dictionary_) return;
    if (!has(key.name)) throw complaint(key.name, "the entry `" + key.name + "` is missing", remedy);
    const auto given = dictionary_->text(key.name);
    if (!given)
        throw complaint(key.name,
                        "`" + key.name + " " + dictionary_->written(key.name) + ";` is not accepted: it must be a text",
                        "write it in quotes");
    value = *given;
}

void Reader::names(const Key& key, std::vector<std::string>& value, const std::vector<std::string>& choices)
{
    ask(key, choices.empty() ? "list of names" : "list of " + alternatives(choices), "()");
    if (!has(key.name)) return;
    const std::string written = dictionary_->written(key.name);
    const auto given = dictionary_->names(key.name);
    if (!given)
        throw complaint(key.name, "`" + key.name + " " + written + ";` is no list of names",
                        "write `" + key.name + " (one \"another/one\");`");
    for (const std::string& name : *given)
        if (!choices.empty() && !is_among(name, choices)) throw nothing_there(key, name, "(" + name + ")", choices);
    value = *given;
}

void Reader::texts(const Key& key, std::vector<std::string>& value)
{
    ask(key, "list of texts", "");
    if (!dictionary_) return;
    const auto given = has(key.name) ? dictionary_->texts(key.name) : std::nullopt;
    if (!given || given->empty())
        throw complaint(key.name,
                        "`" + key.name + (has(key.name) ? " " + dictionary_->written(key.name) + ";` is" : "` has") +
                            " no list of texts (" + key.meaning + ")",
                        "write `" + key.name + " (\"one\" \"another\");`");
    value = *given;
}

void Reader::points(const Key& key, std::vector<Vector>& value, std::size_t least, const std::string& remedy)
{
    ask(key, std::to_string(least) + " points or more [" + key.unit + "]", "none");
    if (!has(key.name)) return;
    const auto given = dictionary_->points(key.name);
    if (!given)
        throw complaint(key.name, "`" + key.name + " " + dictionary_->written(key.name) + ";` is no list of points",
                        "write `" + key.name + " ((x y z) (x y z));`");
    if (given->size() < least)
        throw complaint(
            key.name,
            "`" + key.name + "` has " + std::to_string(given->size()) + " of " + std::to_string(least) + " points",
            remedy);
    value = *given;
}

void Reader::own_entries(const Key& key, std::vector<std::pair<std::string, std::string>>& value)
{
    block(key, [&](Reader& entries) {
        if (!entries.dictionary_) return;
        for (const std::string& name : entries.dictionary_->keys()) {
            entries.known_.push_back(name);
            if (entries.dictionary_->block(name))
                throw entries.complaint(name, "`" + name + "` is a block, where a value belongs",
                                        "write `" + name + " VALUE;`");
            value.emplace_back(name, entries.dictionary_->text(name).value_or(entries.dictionary_->written(name)));
        }
    });
}

void Reader::block(const Key& key, const std::function<void(Reader&)>& read)
{
    ask(key, "", "");
    Reader inside = *this;
    inside.known_.clear();
    inside.dictionary_ = nullptr;
    inside.block_ = block_.empty() ? key.name : block_ + "." + key.name;
    std::unique_ptr<Dictionary> entries;
    if (has(key.name)) {
        entries = dictionary_->block(key.name);
        if (!entries)
            throw complaint(key.name, "`" + key.name + "` is not a block in braces",
                            "write `" + key.name + " { ... }`");
        inside.dictionary_ = entries.get();
    }
    read(inside);
    inside.refuse_unknown_keys();
}

void Reader::own_blocks(const Key& key, const std::function<void(const std::string& name, Reader&)>& read)
{
    block(key, [&](Reader& blocks) {
        const auto of_name = [&](const std::string& name) {
            blocks.block({name, "a name of your own for each"}, [&](Reader& entries) { read(name, entries); });
        };
        if (blocks.dictionary_)
            for (const std::string& name : blocks.dictionary_->keys())
                of_name(name);
        else if (descriptions_)
            of_name("NAME");
    });
}

void Reader::block_or_none(const Key& key, bool& wanted, const std::function<void(Reader&)>& read)
{
    if (has(key.name) && dictionary_->text(key.name) == "none") {
        if (!is_among(key.name, known_)) known_.push_back(key.name);
        wanted = false;
        return;
    }
    block({key.name, key.meaning + "; `none` instead of the block: not taken"}, read);
}

void Reader::required_block(const Key& key, const std::string& remedy, const std::function<void(Reader&)>& read)
{
    if (dictionary_ && !has(key.name))
        throw complaint(key.name, "the block `" + key.name + " { ... }` is missing", remedy);
    block(key, read);
}

UserError Reader::complaint(const std::string& key, const std::string& what, const std::string& remedy) const
{
    return UserError(what, dictionary_ ? dictionary_->place(key) : block_, remedy);
}

void Reader::refuse_unknown_keys(const std::vector<std::string>& ignored) const
{
    if (!dictionary_) return;
    for (const std::string& key : dictionary_->keys())
        if (!is_among(key, known_) && !is_among(key, ignored))
            throw complaint(key, "unknown entry `" + key + "`",
                            did_you_mean(key, known_) + "known here: " + listed(known_));
}

}  // namespace interphase
