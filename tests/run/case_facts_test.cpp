// SPDX-License-Identifier: GPL-3.0-or-later
// What of a case may change when a run goes on, and in which words another change is refused.
#include "run/case_facts.hpp"

#include <gtest/gtest.h>

namespace interphase {
namespace {

InputFile file(const std::string& path, const std::string& text)
{
    InputFile made;
    made.path = path;
    made.bytes = text.size();
    made.text = text;
    return made;
}

using Words = std::vector<std::string>;

FactDifferences of(const std::string& path, const std::string& then, const std::string& now)
{
    return differences(facts_of({file(path, then)}), facts_of({file(path, now)}));
}

TEST(CaseFacts, CommentsAndLayoutDoNotCount)
{
    const auto dictionary =
        of("constant/transportProperties",
           "FoamFile { version 2.0; }\nrho 1.2; mu 1.8e-5; a { b (0 0 1); \"U.*\" c; }\n#include \"x\"",
           "/* air; {\n*/ mu\n  0.000018; // rho 7;\nrho 1.20;\n#include   \"x\" // y\na{b ( 0 0 1.0);\"U.*\" c;}");
    EXPECT_EQ(dictionary.refused, Words{});
    EXPECT_EQ(dictionary.told, Words{});
    const auto script = of("dem/in.liggghts", "fix move all nve/sphere\n\n# a\nneighbor 1e-3 bin\n",
                           "fix   move all & # b\n nve/sphere # c\nneighbor 0.001 bin");
    EXPECT_EQ(script.refused, Words{});
    EXPECT_EQ(script.told, Words{});
}

TEST(CaseFacts, AnEntryIsRefusedByName)
{
    const auto values =
        of("0/U", "boundaryField { inlet { type fixedValue; value uniform (0 0 1); } outlet { type a; } }",
           "boundaryField { inlet { type fixedValue; value uniform (0 0 2); } side { type a; } }");
    EXPECT_EQ(values.refused,
              (Words{"0/U, boundaryField/inlet/value: uniform ( 0 0 2 ), and was uniform ( 0 0 1 )",
                     "0/U, boundaryField/outlet/type is gone", "0/U, boundaryField/side/type: a is new"}));
    std::string list = "internalField nonuniform List<scalar> 40 (";
    for (int n = 0; n < 40; ++n)
        list += " " + std::to_string(1000 + n);
    EXPECT_EQ(of("0/p", list + ");", list + " 7);").refused, Words{"0/p, internalField has changed"});
    EXPECT_EQ(of("constant/polyMesh/points", "2 ((0 0 0) (1 0 0))", "2 ((0 0 0) (1 1 0))").refused.size(), 1u);
    EXPECT_EQ(of("system/controlDict", "deltaT 1e-3;", "deltaT 2e-3;").refused,
              Words{"system/controlDict, deltaT: 0.002, and was 0.001"});
    EXPECT_EQ(of("system/couplingDict", "drag { law BVK; }", "drag { law Ergun; }").refused,
              Words{"system/couplingDict, drag/law: Ergun, and was BVK"});
}

TEST(CaseFacts, ALineOfAScriptIsRefusedByItsWords)
{
    const auto lines = of("dem/in.liggghts", "fix g all gravity 9.81\nregion a block 0 1\nrun 0\n",
                          "fix g all gravity 1.62\nregion a block 0 1\nrun 0\n");
    EXPECT_EQ(lines.refused,
              Words{"dem/in.liggghts: `fix g all gravity 1.62` is new, `fix g all gravity 9.81` is gone"});
    EXPECT_EQ(of("dem/in.liggghts", "fix a all nve\nfix b all nve\n", "fix b all nve\nfix a all nve\n").refused,
              Words{"dem/in.liggghts: in another order"});
}

TEST(CaseFacts, WhatIsWrittenAndWhenItEndsIsTold)
{
    const auto control = of("system/controlDict", "endTime 1; writeInterval 0.1; functions { a { type probes; } }",
                            "endTime 2; writeInterval 0.5; stopAt writeNow;");
    EXPECT_EQ(control.refused, Words{});
    EXPECT_EQ(
        control.told,
        (Words{"system/controlDict, endTime: 2, and was 1", "system/controlDict, functions/a/type is gone",
               "system/controlDict, writeInterval: 0.5, and was 0.1", "system/controlDict, stopAt: writeNow is new"}));
    const auto coupling = of("system/couplingDict", "weight 1; records { interval 0.1; }",
                             "weight 1; records { interval 0.2; } checkpoint { interval 0.5; }");
    EXPECT_EQ(coupling.refused, Words{});
    EXPECT_EQ(coupling.told.size(), 2u);
    const auto script = of("dem/in.liggghts", "thermo 10\nfix a all nve\ndump d all xyz 5 x.xyz\n",
                           "fix w all print 5 \"hello\"\nthermo 20\nfix a all nve\nfix m all ave/time 1 1 1 c_e\n");
    EXPECT_EQ(script.refused, Words{});
    EXPECT_EQ(script.told.size(), 1u);
    EXPECT_EQ(of("system/decomposeParDict", "numberOfSubdomains 2;", "numberOfSubdomains 4;").refused, Words{});
}

TEST(CaseFacts, APlugInIsAnotherBuildOrElsewhere)
{
    const auto found = differences({{"plug-in a", "12"}, {"place of plug-in a", "/x/liba.so"}},
                                   {{"plug-in a", "34"}, {"place of plug-in a", "/y/liba.so"}});
    EXPECT_EQ(found.refused, Words{"plug-in a is another build"});
    EXPECT_EQ(found.told, Words{"place of plug-in a: /y/liba.so, and was /x/liba.so"});
}

}  // namespace
}  // namespace interphase
