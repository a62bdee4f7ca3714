// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/moved_condition.hpp"

#include <algorithm>
#include <stdexcept>

#include "IStringStream.H"
#include "OStringStream.H"
#include "fieldTypes.H"
#include "primitiveFields.H"

namespace interphase {

using namespace Foam;

namespace {

constexpr unsigned exact = 17;  // digits by which a double comes back as it was

std::string words_of(const entry& of)
{
    OStringStream stream;
    stream.precision(exact);
    stream << of;
    return stream.str();
}

bool is_field(const entry& of)
{
    return of.isStream() && !of.stream().empty() && of.stream().first().isWord() &&
           (of.stream().first().wordToken() == "uniform" || of.stream().first().wordToken() == "nonuniform");
}

bool has_value_for_each_face(const entry& of)
{
    return is_field(of) && of.stream().first().wordToken() == "nonuniform";
}

/// A list of typed values that no word says to be a field.
bool has_bare_list(const entry& of)
{
    if (!of.isStream() || is_field(of)) return false;
    const ITstream& tokens = of.stream();
    return std::any_of(tokens.begin(), tokens.end(), [](const token& one) { return one.isCompound(); });
}

/// "scalar", "vector", ... of a field.
word type_of(const entry& of)
{
    const ITstream& tokens = of.stream();
    if (has_value_for_each_face(of)) {
        for (const token& one : tokens)
            if (one.isCompound()) {
                const std::string list = one.compoundToken().type();  // List<scalar>
                return list.substr(5, list.size() - 6);
            }
        return {};
    }
    switch (tokens.size()) {  // the word, and numbers in parentheses
        case 2:
            return pTraits<scalar>::typeName;
        case 1 + 3 + 2:
            return pTraits<vector>::typeName;
        case 1 + 6 + 2:
            return pTraits<symmTensor>::typeName;
        case 1 + 9 + 2:
            return pTraits<tensor>::typeName;
        case 1 + 1 + 2:
            return pTraits<sphericalTensor>::typeName;
        default:
            return {};
    }
}

template <class Type>
void add_field(dictionary& to, const word& key, const std::vector<ConditionPart>& parts, int faces)
{
    Field<Type> values(faces, Zero);
    for (const ConditionPart& part : parts) {
        const Field<Type> there(key, part.dict, part.faces);
        for (const Archive::Move& move : *part.moves)
            values[move.to] = there[move.from];
    }
    OStringStream stream;
    stream.precision(exact);
    values.writeEntry(key, stream);
    IStringStream words(stream.str());
    to.merge(dictionary(words));
}

bool add_field_of(const word& type, dictionary& to, const word& key, const std::vector<ConditionPart>& parts, int faces)
{
    if (type == pTraits<scalar>::typeName)
        add_field<scalar>(to, key, parts, faces);
    else if (type == pTraits<vector>::typeName)
        add_field<vector>(to, key, parts, faces);
    else if (type == pTraits<tensor>::typeName)
        add_field<tensor>(to, key, parts, faces);
    else if (type == pTraits<symmTensor>::typeName)
        add_field<symmTensor>(to, key, parts, faces);
    else if (type == pTraits<sphericalTensor>::typeName)
        add_field<sphericalTensor>(to, key, parts, faces);
    else
        return false;
    return true;
}

[[noreturn]] void refuse(const std::string& where, const word& key, const std::string& why)
{
    throw std::runtime_error("the condition of " + where + ": its entry " + key + " " + why +
                             ", and cannot be given to other ranks than those that saved it");
}

/// Of parts that have faces.
dictionary merged(const std::vector<ConditionPart>& parts, int faces, const std::string& where)
{
    dictionary result;
    const dictionary& first = parts.front().dict;
    for (const ConditionPart& part : parts)
        for (const entry& of : part.dict)
            if (!first.found(of.keyword(), keyType::LITERAL)) refuse(where, of.keyword(), "is not on all ranks");
    for (const entry& of : first) {
        const word key = of.keyword();
        std::vector<const entry*> all;
        for (const ConditionPart& part : parts) {
            all.push_back(part.dict.findEntry(key, keyType::LITERAL));
            if (!all.back() || all.back()->isDict() != of.isDict()) refuse(where, key, "is not on all ranks");
        }
        if (of.isDict()) {
            std::vector<ConditionPart> inner;
            for (std::size_t i = 0; i < parts.size(); ++i)
                inner.push_back({all[i]->dict(), parts[i].faces, parts[i].moves});
            result.add(key, merged(inner, faces, where));
            continue;
        }
        const auto any = [&all](const auto& is) {
            return std::any_of(all.begin(), all.end(), [&](const entry* one) { return is(*one); });
        };
        if (any(has_bare_list)) refuse(where, key, "is a list that does not say whether it goes by faces");
        const std::string words = words_of(of);
        const bool alike = !any([&](const entry& one) { return words_of(one) != words; });
        if (alike && !any(has_value_for_each_face)) {
            result.add(of);
            continue;
        }
        if (any([](const entry& one) { return !is_field(one); })) refuse(where, key, "differs from rank to rank");
        const auto typed =
            std::find_if(all.begin(), all.end(), [](const entry* one) { return has_value_for_each_face(*one); });
        const word type = type_of(typed == all.end() ? of : **typed);
        if (!add_field_of(type, result, key, parts, faces))
            refuse(where, key, "is a field of a kind that is not known");
    }
    return result;
}

}  // namespace

dictionary moved_condition(const std::vector<ConditionPart>& parts, int faces, const std::string& where)
{
    std::vector<ConditionPart> with_faces;
    for (const ConditionPart& part : parts)
        if (part.faces > 0) with_faces.push_back(part);
    return merged(with_faces.empty() ? parts : with_faces, faces, where);
}

}  // namespace interphase
