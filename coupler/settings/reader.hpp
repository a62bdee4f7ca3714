// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/user_error.hpp"
#include "settings/dictionary.hpp"
#include "settings/key.hpp"

namespace interphase {

/// Reads the entries of a dictionary with checks. Asking for a key is all that makes one: it is read, checked, known
/// to the search for unknown ones, and described. Every complaint is a UserError that names file, line, value and
/// remedy. Values are left as they are where the key is not given, so what is in them before is the default.
class Reader {
public:
    using KeyDescriptions = std::vector<KeyDescription>;
    template <class Choice>
    using Choices = std::vector<std::pair<std::string, Choice>>;

    explicit Reader(const Dictionary& dictionary) : dictionary_(&dictionary) {}
    /// Over nothing: no key is given, none is missing, and what is asked for goes to `descriptions`.
    explicit Reader(KeyDescriptions& descriptions) : descriptions_(&descriptions) {}

    void number(const Key& key, double& value, const Range& range);
    void number(const Key& key, std::optional<double>& value, const Range& range);  ///< without one where none is given
    void whole_number(const Key& key, double& value);                               ///< above 0

    /// A list (1 2 3) of numbers, each in `range`, at least one.
    enum class Order { ascending, any };
    void numbers(const Key& key, Scalars& value, const Range& range, Order order = Order::ascending);
    void vector(const Key& key, std::optional<Vector>& value);  ///< (x y z)

    /// One of `choices`, by its name.
    template <class Choice>
    void choice(const Key& key, Choice& value, const Choices<Choice>& choices)
    {
        std::vector<std::string> names;
        std::size_t chosen = 0;
        for (const auto& [name, meant] : choices) {
            if (meant == value) chosen = names.size();
            names.push_back(name);
        }
        value = choices[choose(key, chosen, names)].second;
    }
    void choice(const Key& key, std::string& value, const std::vector<std::string>& choices);

    /// A text that must be given; `remedy` is for where it is not.
    void required_text(const Key& key, std::string& value, const std::string& remedy);

    /// A list of words and quoted texts in parentheses. With `choices`, only of these.
    void names(const Key& key, std::vector<std::string>& value, const std::vector<std::string>& choices = {});

    /// A list of texts in quotes, at least one.
    void texts(const Key& key, std::vector<std::string>& value);

    /// At least as many points as said; `remedy` is for where there are less.
    void points(const Key& key, std::vector<Vector>& value, std::size_t least, const std::string& remedy);

    /// A block whose keys are the user's own: name and value of each, as text.
    void own_entries(const Key& key, std::vector<std::pair<std::string, std::string>>& value);

    /// A block of blocks whose names are the user's own: `read` is called for each.
    void own_blocks(const Key& key, const std::function<void(const std::string& name, Reader&)>& read);

    /// A block of entries that `read` asks for; others are refused. As if it was empty where it is not given.
    void block(const Key& key, const std::function<void(Reader&)>& read);
    /// The same; `none` in its place sets `wanted` to false.
    void block_or_none(const Key& key, bool& wanted, const std::function<void(Reader&)>& read);
    /// One that must be given; `remedy` is for where it is not.
    void required_block(const Key& key, const std::string& remedy, const std::function<void(Reader&)>& read);

    bool has(const std::string& key) const { return dictionary_ && dictionary_->has(key); }
    std::string word(const std::string& key) const;  ///< as it stands there, unchecked; empty where it is not given

    UserError complaint(const std::string& key, const std::string& what, const std::string& remedy) const;

    /// `ignored`: keys that stand there for another purpose.
    void refuse_unknown_keys(const std::vector<std::string>& ignored = {}) const;

private:
    void ask(const Key& key, const std::string& values, const std::string& fallback);
    std::size_t choose(const Key& key, std::size_t fallback, const std::vector<std::string>& choices);
    UserError not_accepted(const Key& key, const std::string& demand, const std::string& remedy) const;
    UserError nothing_there(const Key& key, const std::string& name, const std::string& shown,
                            const std::vector<std::string>& choices) const;

    const Dictionary* dictionary_ = nullptr;  ///< null: nothing is given
    KeyDescriptions* descriptions_ = nullptr;
    std::string block_;
    std::vector<std::string> known_;
};

}  // namespace interphase
