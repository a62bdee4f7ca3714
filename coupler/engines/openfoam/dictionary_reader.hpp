// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/user_error.hpp"
#include "dictionary.H"

namespace interphase {

/// Reads entries of an OpenFOAM dictionary with checks; every complaint names file, line, value and remedy. Keys that
/// nobody asked for are refused by refuse_unknown_keys().
class DictionaryReader {
public:
    DictionaryReader(const Foam::dictionary& dict, std::string path) : dict_(dict), path_(std::move(path)) {}

    bool has(const std::string& key);
    const Foam::dictionary& raw() const { return dict_; }

    /// A number for which `holds` is true; `demand` says in words what that is, e.g. "at least 1".
    double number(const std::string& key, double fallback, const std::function<bool(double)>& holds,
                  const std::string& demand);

    /// One of `choices`.
    std::string choice(const std::string& key, const std::string& fallback, const std::vector<std::string>& choices);

    std::string text_of(const std::string& key, const std::string& remedy);

    /// A list of words and quoted texts in parentheses; empty where there is none.
    std::vector<std::string> names(const std::string& key);

    /// A sub-dictionary; an empty one where there is none.
    DictionaryReader sub(const std::string& key);

    UserError complaint(const std::string& key, const std::string& what, const std::string& remedy) const;

    /// `ignored`: keys that stand there for another purpose.
    void refuse_unknown_keys(const std::vector<std::string>& ignored = {}) const;

private:
    std::string place(const std::string& key) const;

    const Foam::dictionary& dict_;
    std::string path_;
    std::vector<std::string> known_;
};

}  // namespace interphase
