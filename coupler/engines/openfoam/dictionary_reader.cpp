// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/dictionary_reader.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace interphase {

bool DictionaryReader::has(const std::string& key)
{
    known_.push_back(key);
    return dict_.found(key, Foam::keyType::LITERAL);
}

std::string DictionaryReader::place(const std::string& key) const
{
    const Foam::entry* entry = dict_.findEntry(key, Foam::keyType::LITERAL);
    std::string place = path_;
    // OpenFOAM counts a block from the line of its first entry
    if (entry) place += (entry->isDict() ? ", block at line " : ", line ") + std::to_string(entry->startLineNumber());
    return place;
}

UserError DictionaryReader::complaint(const std::string& key, const std::string& what, const std::string& remedy) const
{
    return UserError(what, place(key), remedy);
}

double DictionaryReader::number(const std::string& key, double fallback, const std::function<bool(double)>& holds,
                                const std::string& demand)
{
    if (!has(key)) return fallback;
    Foam::ITstream& stream = dict_.lookup(key, Foam::keyType::LITERAL);
    const bool is_number = stream.size() == 1 && stream.first().isNumber();
    const double value = is_number ? stream.first().number() : 0.0;
    if (is_number && holds(value)) return value;
    const std::string written = is_number ? text(value) : std::string(stream.toString());
    throw complaint(key, "`" + key + " " + written + ";` is not accepted: it must be a number, " + demand,
                    "correct the value (SI units)");
}

std::string DictionaryReader::choice(const std::string& key, const std::string& fallback,
                                     const std::vector<std::string>& choices)
{
    if (!has(key)) return fallback;
    const std::string value = dict_.get<Foam::word>(key, Foam::keyType::LITERAL);
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
    const std::string near = nearest_name(value, choices);
    throw complaint(key, "`" + key + " " + value + ";` names nothing that is there",
                    (near.empty() ? "" : "did you mean `" + near + "`? ") + ("choose one of " + listed(choices)));
}

std::string DictionaryReader::text_of(const std::string& key, const std::string& remedy)
{
    if (!has(key)) throw complaint(key, "the entry `" + key + "` is missing", remedy);
    return dict_.get<Foam::string>(key, Foam::keyType::LITERAL);
}

std::vector<std::string> DictionaryReader::names(const std::string& key)
{
    std::vector<std::string> found;
    if (!has(key)) return found;
    const auto is = [](const Foam::token& token, Foam::token::punctuationToken mark) {
        return token.isPunctuation() && token.pToken() == mark;
    };
    bool understood = !dict_.isDict(key);
    std::string written = "{...}";
    if (understood) {
        Foam::ITstream& tokens = dict_.lookup(key, Foam::keyType::LITERAL);
        written = tokens.toString();
        const Foam::label last = tokens.size() - 1;
        understood = last >= 1 && is(tokens[0], Foam::token::BEGIN_LIST) && is(tokens[last], Foam::token::END_LIST);
        for (Foam::label i = 1; understood && i < last; ++i) {
            understood = tokens[i].isWord() || tokens[i].isString();
            if (understood) found.push_back(tokens[i].isWord() ? tokens[i].wordToken() : tokens[i].stringToken());
        }
    }
    if (!understood)
        throw complaint(key, "`" + key + " " + written + ";` is no list of names",
                        "write `" + key + " (one \"another/one\");`");
    return found;
}

DictionaryReader DictionaryReader::sub(const std::string& key)
{
    const std::string path = path_ + "." + key;
    if (!has(key)) return DictionaryReader(Foam::dictionary::null, path);
    if (!dict_.isDict(key))
        throw complaint(key, "`" + key + "` is not a block in braces", "write `" + key + " { ... }`");
    return DictionaryReader(dict_.subDict(key, Foam::keyType::LITERAL), path);
}

void DictionaryReader::refuse_unknown_keys(const std::vector<std::string>& ignored) const
{
    for (const auto& found : dict_.toc()) {
        const std::string key = found;
        if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
        if (std::find(ignored.begin(), ignored.end(), key) != ignored.end()) continue;
        const std::string near = nearest_name(key, known_);
        throw complaint(key, "unknown entry `" + key + "`",
                        (near.empty() ? "" : "did you mean `" + near + "`? ") + ("known here: " + listed(known_)));
    }
}

}  // namespace interphase
