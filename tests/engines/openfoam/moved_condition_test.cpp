// SPDX-License-Identifier: GPL-3.0-or-later
//
// The conditions that two ranks have written become that of a patch of other faces, or are refused by the name of what
// cannot be told apart.
#include "engines/openfoam/moved_condition.hpp"

#include <gtest/gtest.h>

#include "IStringStream.H"
#include "primitiveFields.H"

namespace {

using namespace interphase;

Foam::dictionary read(const std::string& text)
{
    Foam::IStringStream stream(text);
    return Foam::dictionary(stream);
}

class MovedCondition : public testing::Test {
protected:
    /// Of a rank with three faces and one with two; here are the last of the first, and those of the second turned.
    Foam::dictionary moved(const std::string& first, const std::string& second)
    {
        return moved_condition(
            {{read(first), 3, &of_first}, {read(second), 2, &of_second}, {read("type other;"), 0, &of_none}}, 3,
            "the field U on the patch inlet");
    }
    std::string refused(const std::string& first, const std::string& second)
    {
        try {
            moved(first, second);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    }

    const std::vector<Archive::Move> of_first{{2, 0}}, of_second{{0, 2}, {1, 1}}, of_none;
};

TEST_F(MovedCondition, TakesValuesByFaceAndLeavesTheRest)
{
    const Foam::dictionary found = moved(
        "type mixed; n 3; refValue nonuniform List<scalar> 3(1 2 3); inner { v uniform (1 2 3); } u uniform 0.1; same "
        "uniform 8;",
        "type mixed; n 3; refValue nonuniform List<scalar> 2(4 5); inner { v nonuniform List<vector> 2((4 5 6) (7 8 "
        "9)); } "
        "u uniform 0.30000000000000004; same uniform 8;");
    EXPECT_EQ(Foam::word(found.lookup("type")), "mixed");
    const Foam::scalarField values("refValue", found, 3), u("u", found, 3), same("same", found, 3);
    EXPECT_EQ(values, Foam::scalarField({3, 5, 4}));
    EXPECT_EQ(u, Foam::scalarField({0.1, 0.30000000000000004, 0.30000000000000004}));
    EXPECT_EQ(same, Foam::scalarField(3, 8.0));
    const Foam::vectorField inner("v", found.subDict("inner"), 3);
    EXPECT_EQ(inner[0], Foam::vector(1, 2, 3));
    EXPECT_EQ(inner[1], Foam::vector(7, 8, 9));
    EXPECT_EQ(inner[2], Foam::vector(4, 5, 6));
}

TEST_F(MovedCondition, RefusesWhatItCannotTellApart)
{
    EXPECT_NE(refused("state 1;", "state 2;").find("the field U on the patch inlet: its entry state differs"),
              std::string::npos);
    EXPECT_NE(refused("list List<scalar> 3(1 2 3);", "list List<scalar> 3(1 2 3);").find("entry list is a list"),
              std::string::npos);
    EXPECT_NE(refused("a 1; b 2;", "a 1;").find("entry b is not on all ranks"), std::string::npos);
    EXPECT_NE(refused("a 1;", "a 1; b 2;").find("entry b is not on all ranks"), std::string::npos);
    EXPECT_EQ(refused("a 1; t table ((0 1) (1 2));", "a 1; t table ((0 1) (1 2));"), "");
}

}  // namespace
