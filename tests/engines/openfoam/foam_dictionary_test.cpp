// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenFOAM's dictionaries as the settings see them: values by their form, as they are written, and where they stand.
#include "engines/openfoam/foam_dictionary.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "IStringStream.H"

namespace {

using namespace interphase;

const char* const words = R"(FoamFile { version 2.0; }
size        0.25;
twice       #eval{ 2*0.25 };
same        $size;
law         WenYu;
script      "dem/in.liggghts";
several     one two;
plugins     (hard_sphere "$FOLDER/libmine.so");
mixed       (hard_sphere 3);
taps        ((0 0 1) (-0.5 2e-3 $size));
flat        ((0 0) (1 1));
none        ();
third       #eval{ 1.0/3.0 };
long        (9.810000000000002 -1.2345678e-7 12345678 1e-5);
gas
{
    model   pimple;
    deep { last 1; }
}
)";

class OfOpenFoam : public testing::Test {
protected:
    static Foam::dictionary parsed()
    {
        Foam::IStringStream stream(words);
        stream.lineNumber(1);  // as a file counts
        return Foam::dictionary(stream);
    }

    const Foam::dictionary dict_ = parsed();
    const FoamDictionary read_{dict_, "system/couplingDict"};
};

TEST_F(OfOpenFoam, ListsItsKeysInOrderWithoutTheHeader)
{
    const std::vector<std::string> all = read_.keys();
    ASSERT_EQ(all.size(), 14u);
    EXPECT_EQ(all.front(), "size");
    EXPECT_EQ(all.back(), "gas");
    EXPECT_TRUE(read_.has("gas"));
    EXPECT_FALSE(read_.has("ga.*"));  // no pattern
}

TEST_F(OfOpenFoam, GivesNumbers)
{
    EXPECT_EQ(read_.number("size"), 0.25);
    EXPECT_EQ(read_.number("twice"), 0.5);
    EXPECT_EQ(read_.number("same"), 0.25);
    for (const char* key : {"law", "several", "plugins", "gas"})
        EXPECT_FALSE(read_.number(key)) << key;
}

TEST_F(OfOpenFoam, GivesTexts)
{
    EXPECT_EQ(read_.text("law"), "WenYu");
    EXPECT_EQ(read_.text("script"), "dem/in.liggghts");
    for (const char* key : {"size", "several", "plugins", "gas"})
        EXPECT_FALSE(read_.text(key)) << key;
}

TEST_F(OfOpenFoam, GivesListsOfNamesWithTheEnvironmentsVariables)
{
    setenv("FOLDER", "/somewhere", 1);
    EXPECT_EQ(read_.names("plugins"), (std::vector<std::string>{"hard_sphere", "/somewhere/libmine.so"}));
    EXPECT_EQ(read_.names("none"), std::vector<std::string>());
    for (const char* key : {"law", "mixed", "taps", "several", "gas"})
        EXPECT_FALSE(read_.names(key)) << key;
}

TEST_F(OfOpenFoam, GivesPoints)
{
    EXPECT_EQ(read_.points("taps"), (std::vector<Vector>{Vector(0, 0, 1), Vector(-0.5, 2e-3, 0.25)}));
    for (const char* key : {"size", "flat", "plugins", "gas"})
        EXPECT_FALSE(read_.points(key)) << key;
}

TEST_F(OfOpenFoam, GivesBlocks)
{
    EXPECT_FALSE(read_.block("law"));
    const auto gas = read_.block("gas");
    ASSERT_TRUE(gas);
    EXPECT_EQ(gas->keys(), (std::vector<std::string>{"model", "deep"}));
    EXPECT_EQ(gas->text("model"), "pimple");
    EXPECT_EQ(gas->block("deep")->number("last"), 1);
}

TEST_F(OfOpenFoam, TellsWhatIsWrittenAndWhere)
{
    EXPECT_EQ(read_.written("size"), "0.25");
    EXPECT_EQ(read_.written("law"), "WenYu");
    EXPECT_EQ(read_.written("several"), "one two");
    EXPECT_EQ(read_.written("gas"), "{...}");
    // What goes into the script as a variable is the same double there.
    EXPECT_EQ(std::stod(read_.written("third")), read_.number("third"));
    EXPECT_EQ(read_.written("long"), "( 9.810000000000002 -1.2345678e-07 12345678 1e-05 )");
    EXPECT_EQ(read_.place("law"), "system/couplingDict, line 5");
    EXPECT_EQ(read_.place("gas"), "system/couplingDict, block at line 17");  // its first entry
    EXPECT_EQ(read_.place("drag"), "system/couplingDict");
    EXPECT_EQ(read_.block("gas")->place("model"), "system/couplingDict.gas, line 17");
}

}  // namespace
