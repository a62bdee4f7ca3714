// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/foam_dictionary.hpp"

#include <charconv>

#include "OStringStream.H"
#include "token.H"

namespace interphase {

namespace {

constexpr auto literal = Foam::keyType::LITERAL;  // a key is a name, no pattern

const char* const header = "FoamFile";

using Tokens = std::vector<Foam::token>;

/// None for a block.
Tokens tokens_of(const Foam::dictionary& dict, const std::string& key)
{
    if (dict.isDict(key, literal)) return {};
    const Foam::ITstream& stream = dict.lookup(key, literal);
    return Tokens(stream.begin(), stream.end());
}

bool is(const Foam::token& token, Foam::token::punctuationToken mark)
{
    return token.isPunctuation() && token.pToken() == mark;
}

/// Those between the parentheses that hold all of them.
std::optional<Tokens> listed_in(const Tokens& tokens)
{
    if (tokens.size() < 2 || !is(tokens.front(), Foam::token::BEGIN_LIST) || !is(tokens.back(), Foam::token::END_LIST))
        return std::nullopt;
    return Tokens(tokens.begin() + 1, tokens.end() - 1);
}

std::optional<Foam::string> text_of(const Foam::token& token)
{
    if (token.isWord()) return token.wordToken();
    if (token.isString()) return token.stringToken();
    return std::nullopt;
}

/// A number in as few digits as give it back; OpenFOAM's own streams round to six.
std::string written(const Foam::token& token)
{
    if (token.isScalar()) {
        char text[32];  // no double takes more than 24
        return {text, std::to_chars(text, text + sizeof text, token.scalarToken()).ptr};
    }
    Foam::OStringStream stream;
    stream << token;
    return stream.str();
}

}  // namespace

std::vector<std::string> FoamDictionary::keys() const
{
    std::vector<std::string> names;
    for (const Foam::word& key : dict_.toc())
        if (key != header) names.push_back(key);
    return names;
}

bool FoamDictionary::has(const std::string& key) const { return dict_.found(key, literal); }

std::optional<double> FoamDictionary::number(const std::string& key) const
{
    const Tokens tokens = tokens_of(dict_, key);
    if (tokens.size() != 1 || !tokens[0].isNumber()) return std::nullopt;
    return tokens[0].number();
}

std::optional<std::string> FoamDictionary::text(const std::string& key) const
{
    const Tokens tokens = tokens_of(dict_, key);
    if (tokens.size() != 1) return std::nullopt;
    return text_of(tokens[0]);
}

std::optional<std::vector<std::string>> FoamDictionary::names(const std::string& key) const
{
    const auto tokens = listed_in(tokens_of(dict_, key));
    if (!tokens) return std::nullopt;
    std::vector<std::string> found;
    for (const Foam::token& token : *tokens) {
        auto name = text_of(token);
        if (!name) return std::nullopt;
        found.push_back(name->expand(true));
    }
    return found;
}

std::optional<std::vector<std::string>> FoamDictionary::texts(const std::string& key) const
{
    const auto tokens = listed_in(tokens_of(dict_, key));
    if (!tokens) return std::nullopt;
    std::vector<std::string> found;
    for (const Foam::token& token : *tokens) {
        const auto text = text_of(token);
        if (!text) return std::nullopt;
        found.push_back(*text);
    }
    return found;
}

std::optional<Scalars> FoamDictionary::numbers(const std::string& key) const
{
    const auto tokens = listed_in(tokens_of(dict_, key));
    if (!tokens) return std::nullopt;
    Scalars found;
    for (const Foam::token& token : *tokens) {
        if (!token.isNumber()) return std::nullopt;
        found.push_back(token.number());
    }
    return found;
}

std::optional<std::vector<Vector>> FoamDictionary::points(const std::string& key) const
{
    const auto tokens = listed_in(tokens_of(dict_, key));
    constexpr std::size_t width = 5;  // ( x y z )
    if (!tokens || tokens->size() % width != 0) return std::nullopt;
    std::vector<Vector> found;
    for (auto point = tokens->begin(); point != tokens->end(); point += width) {
        if (!is(point[0], Foam::token::BEGIN_LIST) || !is(point[4], Foam::token::END_LIST)) return std::nullopt;
        if (!(point[1].isNumber() && point[2].isNumber() && point[3].isNumber())) return std::nullopt;
        found.emplace_back(point[1].number(), point[2].number(), point[3].number());
    }
    return found;
}

std::unique_ptr<Dictionary> FoamDictionary::block(const std::string& key) const
{
    if (!dict_.isDict(key, literal)) return nullptr;
    return std::make_unique<FoamDictionary>(dict_.subDict(key, literal), path_ + "." + key);
}

std::string FoamDictionary::written(const std::string& key) const
{
    if (dict_.isDict(key, literal)) return "{...}";
    std::string all;
    for (const Foam::token& token : tokens_of(dict_, key))
        all += (all.empty() ? "" : " ") + interphase::written(token);
    return all;
}

std::string FoamDictionary::place(const std::string& key) const
{
    const Foam::entry* entry = dict_.findEntry(key, literal);
    // OpenFOAM counts a block from the line of its first entry, and knows no line of an empty one
    if (!entry || entry->startLineNumber() < 0) return path_;
    return path_ + (entry->isDict() ? ", block at line " : ", line ") + std::to_string(entry->startLineNumber());
}

}  // namespace interphase
