// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asking a dictionary for a key reads it, checks it, makes it known and describes it.
#include "settings/reader.hpp"

#include <gtest/gtest.h>

#include "support/fake_dictionary.hpp"
#include "support/refused.hpp"

namespace {

using namespace interphase;
using test::FakeDictionary;
using test::refused;
using Block = FakeDictionary::Block;
using Names = FakeDictionary::Names;
using Points = FakeDictionary::Points;

enum class Shape { sphere, cube, needle };
const Reader::Choices<Shape> shapes{{"sphere", Shape::sphere}, {"cube", Shape::cube}, {"needle", Shape::needle}};

const Key length{"length", "how long it is", "m"};
const Key shape{"shape", "what it looks like"};

double read_length(const Block& entries)
{
    const FakeDictionary dict(entries);
    double value = 7;
    Reader(dict).number(length, value, above(0));
    return value;
}

Shape read_shape(const Block& entries)
{
    const FakeDictionary dict(entries);
    Shape value = Shape::cube;
    Reader(dict).choice(shape, value, shapes);
    return value;
}

TEST(Range, HoldsWhatItsWordsSay)
{
    EXPECT_EQ(above(0).words, "above 0");
    EXPECT_FALSE(above(0).holds(0));
    EXPECT_TRUE(above(0).holds(1e-300));
    EXPECT_EQ(at_least(10).words, "at least 10");
    EXPECT_TRUE(at_least(10).holds(10));
    EXPECT_FALSE(at_least(10).holds(9.999));
    EXPECT_EQ(between(0, 1).words, "between 0 and 1");
    EXPECT_FALSE(between(0, 1).holds(0));
    EXPECT_TRUE(between(0, 1).holds(0.5));
    EXPECT_FALSE(between(0, 1).holds(1));
}

TEST(Reader, LeavesWhatIsNotGiven)
{
    EXPECT_EQ(read_length({}), 7);
    EXPECT_EQ(read_shape({}), Shape::cube);
}

TEST(Reader, TakesWhatIsGiven)
{
    EXPECT_EQ(read_length(Block{{"length", 0.25}}), 0.25);
    EXPECT_EQ(read_shape(Block{{"shape", "needle"}}), Shape::needle);
}

TEST(Reader, RefusesANumberOutOfRange)
{
    const Problem problem = refused([] { read_length(Block{{"other", 1.0}, {"length", -2.0}}); });
    EXPECT_EQ(problem.what, "`length -2;` is not accepted: it must be a number [m], above 0 (how long it is)");
    EXPECT_EQ(problem.where, "dict, line 2");
    EXPECT_EQ(problem.remedy, "correct the value (SI units)");
}

TEST(Reader, RefusesWhatIsNoNumber)
{
    const std::string demand = " is not accepted: it must be a number [m], above 0 (how long it is)";
    EXPECT_EQ(refused([] { read_length(Block{{"length", "long"}}); }).what, "`length long;`" + demand);
    EXPECT_EQ(refused([] { read_length(Block{{"length", Block{{"x", 1.0}}}}); }).what, "`length {...};`" + demand);
}

TEST(Reader, RefusesANameThatIsNoChoice)
{
    const Problem near = refused([] { read_shape(Block{{"shape", "spere"}}); });
    EXPECT_EQ(near.what, "`shape spere;` names nothing that is there");
    EXPECT_EQ(near.where, "dict, line 1");
    EXPECT_EQ(near.remedy, "did you mean `sphere`? choose one of sphere, cube, needle");
    const Problem far = refused([] { read_shape(Block{{"shape", "blue"}}); });
    EXPECT_EQ(far.remedy, "choose one of sphere, cube, needle");
    EXPECT_EQ(refused([] { read_shape(Block{{"shape", 3.0}}); }).what, "`shape 3;` names nothing that is there");
}

TEST(Reader, WantsATextThatMustBeGiven)
{
    const auto read = [](const Block& entries) {
        const FakeDictionary dict(entries);
        std::string value;
        Reader(dict).required_text({"title", "what it is called"}, value, "give it one");
        return value;
    };
    EXPECT_EQ(read(Block{{"title", "a bed"}}), "a bed");
    const Problem missing = refused([&] { read({}); });
    EXPECT_EQ(missing.what, "the entry `title` is missing");
    EXPECT_EQ(missing.where, "dict");
    EXPECT_EQ(missing.remedy, "give it one");
    const Problem number = refused([&] { read(Block{{"title", 1.0}}); });
    EXPECT_EQ(number.what, "`title 1;` is not accepted: it must be a text");
    EXPECT_EQ(number.where, "dict, line 1");
    EXPECT_EQ(number.remedy, "write it in quotes");
}

TEST(Reader, ReadsListsOfNames)
{
    const Key key{"parts", "what it is made of"};
    const Names parts{"lid", "pot", "handle"};
    const auto read = [&](const Block& entries, const Names& choices) {
        const FakeDictionary dict(entries);
        Names value{"pot"};
        Reader(dict).names(key, value, choices);
        return value;
    };
    EXPECT_EQ(read({}, {}), Names{"pot"});
    EXPECT_EQ(read(Block{{"parts", Names{"spout", "pot"}}}, {}), (Names{"spout", "pot"}));
    EXPECT_EQ(read(Block{{"parts", Names{"pot", "lid"}}}, parts), (Names{"pot", "lid"}));

    const Problem word = refused([&] { read(Block{{"parts", "pot"}}, {}); });
    EXPECT_EQ(word.what, "`parts pot;` is no list of names");
    EXPECT_EQ(word.where, "dict, line 1");
    EXPECT_EQ(word.remedy, "write `parts (one \"another/one\");`");
    const Problem unknown = refused([&] { read(Block{{"parts", Names{"pot", "lit"}}}, parts); });
    EXPECT_EQ(unknown.what, "`parts (lit);` names nothing that is there");
    EXPECT_EQ(unknown.remedy, "did you mean `lid`? choose one of lid, pot, handle");
}

TEST(Reader, ReadsAsManyPointsAsItShould)
{
    const auto read = [](const Block& entries) {
        const FakeDictionary dict(entries);
        std::vector<Vector> value;
        Reader(dict).points({"ends", "where it ends", "m"}, value, 2, "give both ends");
        return value;
    };
    const Points two{Vector(0, 0, 1), Vector(0, 0, 2)};
    EXPECT_EQ(read(Block{{"ends", two}}), two);
    EXPECT_TRUE(read({}).empty());
    const Problem one = refused([&] { read(Block{{"ends", Points{Vector(0, 0, 1)}}}); });
    EXPECT_EQ(one.what, "`ends` has 1 of 2 points");
    EXPECT_EQ(one.where, "dict, line 1");
    EXPECT_EQ(one.remedy, "give both ends");
    EXPECT_EQ(refused([&] { read(Block{{"ends", "here"}}); }).what, "`ends here;` is no list of points");
}

TEST(Reader, TakesEntriesOfTheUsersOwn)
{
    const auto read = [](const Block& entries) {
        const FakeDictionary dict(entries);
        std::vector<std::pair<std::string, std::string>> value;
        Reader(dict).own_entries({"variables", "handed on"}, value);
        return value;
    };
    const std::vector<std::pair<std::string, std::string>> expected{{"width", "0.5"}, {"kind", "coarse"}};
    EXPECT_EQ(read(Block{{"variables", Block{{"width", 0.5}, {"kind", "coarse"}}}}), expected);
    EXPECT_TRUE(read({}).empty());
    const Problem block = refused([&] { read(Block{{"variables", Block{{"deep", Block{}}}}}); });
    EXPECT_EQ(block.what, "`deep` is a block, where a value belongs");
    EXPECT_EQ(block.where, "dict.variables, line 1");
    EXPECT_EQ(block.remedy, "write `deep VALUE;`");
}

TEST(Reader, KnowsTheKeysOfABlockByWhatIsAskedFor)
{
    const auto read = [](const Block& entries) {
        const FakeDictionary dict(entries);
        double value = 1;
        Reader(dict).block({"size", "how large it is"}, [&](Reader& size) { size.number(length, value, above(0)); });
        return value;
    };
    EXPECT_EQ(read(Block{{"size", Block{{"length", 3.0}}}}), 3);
    EXPECT_EQ(read({}), 1);
    const Problem unknown = refused([&] { read(Block{{"size", Block{{"length", 3.0}, {"lenght", 4.0}}}}); });
    EXPECT_EQ(unknown.what, "unknown entry `lenght`");
    EXPECT_EQ(unknown.where, "dict.size, line 2");
    EXPECT_EQ(unknown.remedy, "did you mean `length`? known here: length");
    const Problem value = refused([&] { read(Block{{"size", 3.0}}); });
    EXPECT_EQ(value.what, "`size` is not a block in braces");
    EXPECT_EQ(value.where, "dict, line 1");
    EXPECT_EQ(value.remedy, "write `size { ... }`");
}

TEST(Reader, WantsABlockThatMustBeGiven)
{
    const FakeDictionary empty({});
    const Problem missing = refused([&] {
        Reader(empty).required_block({"size", "how large it is"}, "add it", [](Reader&) { FAIL() << "read"; });
    });
    EXPECT_EQ(missing.what, "the block `size { ... }` is missing");
    EXPECT_EQ(missing.where, "dict");
    EXPECT_EQ(missing.remedy, "add it");
}

TEST(Reader, RefusesKeysThatNobodyAskedFor)
{
    const FakeDictionary dict({{"length", 1.0}, {"note", "mine"}, {"mass", 2.0}});
    Reader reader(dict);
    double value = 0;
    reader.number(length, value, above(0));
    reader.number(length, value, above(0));  // known once, though asked for twice
    const Problem problem = refused([&] { reader.refuse_unknown_keys({"note"}); });
    EXPECT_EQ(problem.what, "unknown entry `mass`");
    EXPECT_EQ(problem.where, "dict, line 3");
    EXPECT_EQ(problem.remedy, "known here: length");
    reader.refuse_unknown_keys({"note", "mass"});
}

TEST(Reader, DescribesWhatItIsAskedFor)
{
    Reader::KeyDescriptions keys;
    Reader reader(keys);
    double size = 7;
    Shape form = Shape::cube;
    std::string title;
    Names parts;
    Points ends;
    reader.number(length, size, above(0));
    reader.choice({"shape", "what it looks like", "", "by its length"}, form, shapes);
    reader.required_block({"inside", "what is in it"}, "", [&](Reader& inside) {
        inside.number({"fill", "how full it is", "", "", "0 to 1, closed or not"}, size, between(0, 1));
        inside.required_text({"title", "what it is called"}, title, "");
        inside.names({"parts", "what it is made of"}, parts);
        inside.names({"colours", "what it is painted in"}, parts, {"red", "blue"});
        inside.points({"ends", "where it ends", "m"}, ends, 2, "");
    });
    EXPECT_FALSE(reader.has("length"));

    const std::vector<std::vector<std::string>> expected{
        {"", "length", "number [m], above 0", "7", "how long it is"},
        {"", "shape", "sphere | cube | needle", "by its length", "what it looks like"},
        {"", "inside", "", "", "what is in it"},
        {"inside", "fill", "number, 0 to 1, closed or not", "7", "how full it is"},
        {"inside", "title", "text", "", "what it is called"},
        {"inside", "parts", "list of names", "()", "what it is made of"},
        {"inside", "colours", "list of red | blue", "()", "what it is painted in"},
        {"inside", "ends", "2 points or more [m]", "none", "where it ends"}};
    std::vector<std::vector<std::string>> described;
    for (const KeyDescription& key : keys)
        described.push_back({key.block, key.name, key.values, key.fallback, key.meaning});
    EXPECT_EQ(described, expected);
}

}  // namespace
