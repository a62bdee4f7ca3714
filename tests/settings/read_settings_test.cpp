// SPDX-License-Identifier: GPL-3.0-or-later
//
// Defaults of system/couplingDict, what each key sets, and each rule's complaint: what, where and remedy.
#include "settings/read_settings.hpp"

#include <gtest/gtest.h>

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "forces/drag/drag_law.hpp"
#include "support/fake_dictionary.hpp"
#include "support/methods.hpp"
#include "support/refused.hpp"
#include "support/scratch_folder.hpp"

namespace {

using namespace interphase;
using test::FakeDictionary;
using Block = FakeDictionary::Block;
using Names = FakeDictionary::Names;
using Points = FakeDictionary::Points;

class ReadSettings : public testing::Test {
protected:
    ReadSettings()
    {
        folder_ = test::new_folder();
        std::ofstream(folder_ / "in.liggghts") << "units si\n";
    }
    ~ReadSettings() override { std::filesystem::remove_all(folder_); }

    /// With a block `particles` of a script and `particles` where `entries` have none.
    Settings read(Block entries, const Block& particles = {}, const Block& scene = {}) const
    {
        Block with_script{{"script", "in.liggghts"}};
        with_script.insert(with_script.end(), particles.begin(), particles.end());
        entries.emplace_back("particles", with_script);
        return read_as_given(entries, scene);
    }

    Settings read_as_given(const Block& entries, const Block& scene = {}) const
    {
        return read_settings(FakeDictionary(entries), FakeDictionary(scene), folder_, test::FakeMethods());
    }

    /// The problem's what, where and remedy.
    void refuses(const Block& entries, const Block& particles, const std::string& what, const std::string& where,
                 const std::string& remedy) const
    {
        const Problem problem = test::refused([&] { read(entries, particles); });
        EXPECT_EQ(problem.what, what);
        EXPECT_EQ(problem.where, where);
        EXPECT_EQ(problem.remedy, remedy);
    }

    std::filesystem::path folder_;
};

TEST_F(ReadSettings, NeedsAScriptAndHasDefaultsForTheRest)
{
    const Settings s = read({});
    EXPECT_EQ(s.method.name, "SPRINGS");
    EXPECT_EQ(s.weight, 1);
    EXPECT_TRUE(s.plugins.empty());
    EXPECT_EQ(s.script, "in.liggghts");
    EXPECT_TRUE(s.variables.empty());
    EXPECT_EQ(s.solid_step, 0);
    EXPECT_EQ(s.steps_per_collision, 20);
    EXPECT_EQ(s.largest_overlap, 0);
    EXPECT_EQ(s.impact_speed, 0);
    EXPECT_EQ(s.gas, GasModel::pimple);
    EXPECT_TRUE(s.two_way);
    EXPECT_EQ(s.drag_law, drag_laws().front().name);
    EXPECT_EQ(s.mapping.type, MappingType::kernel);
    EXPECT_EQ(s.mapping.width_in_diameters, 2.5);
    EXPECT_EQ(s.mapping.width, 0);
    EXPECT_EQ(s.mapping.maximum_packing, 0.74);
    EXPECT_EQ(s.outside_mesh, OutsideMesh::stop);
    EXPECT_EQ(s.record_interval, 0.05);
    EXPECT_EQ(s.snapshot_interval, 0);
    EXPECT_TRUE(s.pressure_taps.empty());
}

TEST_F(ReadSettings, EachKeySetsItsOwn)
{
    const Points taps{Vector(0, 0, 0.1), Vector(0, 0, 0.4)};
    const Settings s = read({{"method", "MEAN"},
                             {"weight", 8.0},
                             {"plugins", Names{"mean", "./mine.so"}},
                             {"gas", Block{{"model", "pimple"}, {"coupling", "oneWay"}}},
                             {"drag", Block{{"law", "Ergun"}}},
                             {"mapping", Block{{"type", "kernel"}, {"width", 0.02}, {"maximumPacking", 0.6}}},
                             {"outsideMesh", "ignore"},
                             {"records", Block{{"interval", 0.1}, {"snapshotInterval", 0.2}, {"pressureTaps", taps}}}},
                            {{"variables", Block{{"radius", 0.5}, {"kind", "coarse"}}}});
    EXPECT_EQ(s.method.name, "MEAN");
    EXPECT_EQ(s.weight, 8);
    EXPECT_EQ(s.plugins, (Names{"mean", "./mine.so"}));
    EXPECT_EQ(s.variables, (std::vector<std::pair<std::string, std::string>>{{"radius", "0.5"}, {"kind", "coarse"}}));
    EXPECT_EQ(s.gas, GasModel::pimple);
    EXPECT_FALSE(s.two_way);
    EXPECT_EQ(s.drag_law, "Ergun");
    EXPECT_EQ(s.mapping.width, 0.02);
    EXPECT_EQ(s.mapping.maximum_packing, 0.6);
    EXPECT_EQ(s.outside_mesh, OutsideMesh::ignore);
    EXPECT_EQ(s.record_interval, 0.1);
    EXPECT_EQ(s.snapshot_interval, 0.2);
    EXPECT_EQ(s.pressure_taps, taps);
    EXPECT_EQ(read({{"mapping", Block{{"type", "cellCentre"}}}}).mapping.type, MappingType::cell_centre);
    EXPECT_EQ(read({{"mapping", Block{{"widthInDiameters", 3.5}}}}).mapping.width_in_diameters, 3.5);
    EXPECT_EQ(read({}, {{"solidStep", 1e-5}}).solid_step, 1e-5);
    const Settings hard =
        read({{"method", "IMPULSES"}, {"plugins", Names{"impulses"}}}, {{"largestOverlap", 0.1}, {"impactSpeed", 2.0}});
    EXPECT_EQ(hard.largest_overlap, 0.1);
    EXPECT_EQ(hard.impact_speed, 2);
}

TEST_F(ReadSettings, KnowsAllMethodsAndLawsByTheirNames)
{
    const Names plugins{"impulses", "mean"};
    for (const Method& method : test::FakeMethods().methods(plugins))
        EXPECT_EQ(read({{"method", method.name.c_str()}, {"plugins", plugins}}).method.name, method.name);
    for (const DragLaw& law : drag_laws())
        EXPECT_EQ(read({{"drag", Block{{"law", std::string(law.name).c_str()}}}}).drag_law, law.name);
}

TEST_F(ReadSettings, AMethodSaysHowManyStepsACollisionTakes)
{
    const Block hard{{"method", "IMPULSES"}, {"plugins", Names{"impulses"}}};
    EXPECT_EQ(read(hard).steps_per_collision, 1);
    EXPECT_EQ(read(hard, {{"stepsPerCollision", 0.5}}).steps_per_collision, 0.5);
}

TEST_F(ReadSettings, AGasThatIsNotSolvedDoesNotFeelTheParticles)
{
    for (const char* model : {"frozen", "none"}) {
        EXPECT_FALSE(read({{"gas", Block{{"model", model}}}}).two_way);
        refuses({{"gas", Block{{"model", model}, {"coupling", "twoWay"}}}}, {},
                std::string("`coupling twoWay;` with a gas that is not solved (model ") + model + ")",
                "dict.gas, line 2", "set `coupling oneWay;`");
    }
}

TEST_F(ReadSettings, AWeightWantsParcels)
{
    refuses(
        {{"weight", 0.5}}, {},
        "`weight 0.5;` is not accepted: it must be a number, at least 1 (real particles per tracked one, unless the "
        "script gives each its own)",
        "dict, line 1", "correct the value (SI units)");
    refuses({{"method", "SPRINGS"}, {"weight", 8.0}}, {},
            "`weight 8;` with method SPRINGS, which tracks real particles", "dict, line 2",
            "set `weight 1;`, or take method PARCELS");
    refuses({{"method", "IMPULSES"}, {"weight", 8.0}, {"plugins", Names{"impulses"}}}, {},
            "`weight 8;` with method IMPULSES, which tracks real particles", "dict, line 2", "set `weight 1;`");
}

TEST_F(ReadSettings, MethodsOfPlugInsWantOne)
{
    refuses({{"method", "MEAN"}}, {}, "`method MEAN;` is of the plug-in mean, which `plugins` does not name",
            "dict, line 1", "add `plugins (mean);`");
    refuses({{"method", "MEAN"}, {"plugins", Names{"impulses"}}}, {},
            "`method MEAN;` is of the plug-in mean, which `plugins` does not name", "dict, line 1",
            "add `plugins (mean);`");
    refuses({{"method", "WHATEVER"}}, {}, "`method WHATEVER;` takes its collisions from a plug-in, and none is named",
            "dict, line 1", "add `plugins (NAME);` with the name or \"path\" of yours");
    refuses({{"method", "IMPULSE"}, {"plugins", Names{"impulses"}}}, {},
            "`method IMPULSE;` names nothing that is there", "dict, line 1",
            "did you mean `IMPULSES`? choose one of SPRINGS, PARCELS, WHATEVER, IMPULSES");
}

TEST_F(ReadSettings, WantsTheBlockOfParticles)
{
    const Problem problem = test::refused([&] { read_as_given({{"method", "SPRINGS"}}); });
    EXPECT_EQ(problem.what, "the block `particles { ... }` is missing");
    EXPECT_EQ(problem.where, "dict");
    EXPECT_EQ(problem.remedy, "add it, with the LIGGGHTS script");
}

TEST_F(ReadSettings, WantsAScriptThatIsThere)
{
    const Problem missing = test::refused([&] { read_as_given({{"particles", Block{}}}); });
    EXPECT_EQ(missing.what, "the entry `script` is missing");
    EXPECT_EQ(missing.where, "dict.particles");
    EXPECT_EQ(missing.remedy, "name the LIGGGHTS script, e.g. `script \"dem/in.liggghts\";`");
    const Problem elsewhere = test::refused([&] { read_as_given({{"particles", Block{{"script", "out.liggghts"}}}}); });
    EXPECT_EQ(elsewhere.what, "there is no LIGGGHTS script `out.liggghts` in the case");
    EXPECT_EQ(elsewhere.where, "dict.particles, line 1");
    EXPECT_EQ(elsewhere.remedy, "correct the name, or put the script there");
}

TEST_F(ReadSettings, ResolvedContactsWantSmallSteps)
{
    for (const char* method : {"SPRINGS", "PARCELS"}) {
        const Problem few = test::refused([&] { read({{"method", method}}, {{"stepsPerCollision", 9.0}}); });
        EXPECT_NE(few.what.find("`stepsPerCollision 9;` is not accepted: it must be a number, at least 10 ("),
                  std::string::npos)
            << few.what;
        EXPECT_EQ(few.where, "dict.particles, line 2");
        EXPECT_EQ(read({{"method", method}}, {{"stepsPerCollision", 10.0}}).steps_per_collision, 10);
        for (const char* key : {"largestOverlap", "impactSpeed"})
            refuses({{"method", method}}, {{key, 0.1}},
                    std::string(key) + " with method " + method + ", whose step has to resolve each contact",
                    "dict.particles, line 2", "give stepsPerCollision or solidStep instead");
    }
}

TEST_F(ReadSettings, AStressHasNoSingleCollisions)
{
    const Block stress{{"method", "MEAN"}, {"plugins", Names{"mean"}}};
    for (const char* key : {"stepsPerCollision", "largestOverlap", "impactSpeed"})
        refuses(stress, {{key, 0.1}}, std::string(key) + " with method MEAN, which has no single collisions",
                "dict.particles, line 2", "leave it away for the gas step, or give solidStep");
    EXPECT_EQ(read(stress, {{"solidStep", 1e-4}}).solid_step, 1e-4);
}

TEST_F(ReadSettings, TheSolidStepHasOneRule)
{
    const Block hard{{"method", "IMPULSES"}, {"plugins", Names{"impulses"}}};
    const std::string both = "give both: the solid step is largestOverlap * diameter / impactSpeed";
    refuses(hard, {{"largestOverlap", 0.1}}, "largestOverlap is given alone", "dict.particles, line 2", both);
    refuses(hard, {{"impactSpeed", 0.1}}, "impactSpeed is given alone", "dict.particles, line 2", both);
    refuses(hard, {{"solidStep", 1e-4}, {"stepsPerCollision", 2.0}}, "both solidStep and stepsPerCollision are given",
            "dict.particles, line 2", "keep one of them");
    refuses(hard, {{"largestOverlap", 0.1}, {"impactSpeed", 1.0}, {"solidStep", 1e-4}},
            "both largestOverlap and solidStep are given", "dict.particles, line 2", "keep one of them");
}

TEST_F(ReadSettings, AKernelsWidthWantsAKernel)
{
    refuses({{"mapping", Block{{"type", "cellCentre"}, {"width", 0.1}}}}, {}, "a kernel width with `type cellCentre;`",
            "dict.mapping, line 2", "remove it, or set `type kernel;`");
    refuses({{"mapping", Block{{"type", "cellCentre"}, {"widthInDiameters", 3.0}}}}, {},
            "a kernel width with `type cellCentre;`", "dict.mapping, line 2", "remove it, or set `type kernel;`");
}

TEST_F(ReadSettings, AKernelHasOneWidth)
{
    refuses({{"mapping", Block{{"widthInDiameters", 3.0}, {"width", 0.1}}}}, {},
            "two widths of the kernel, `width` and `widthInDiameters`", "dict.mapping, line 2", "keep one of them");
}

TEST_F(ReadSettings, PressureIsTakenAtTwoPoints)
{
    refuses({{"records", Block{{"pressureTaps", Points{Vector(0, 0, 1)}}}}}, {}, "`pressureTaps` has 1 of 2 points",
            "dict.records, line 1",
            "give two points or more: the pressure of the first less that of the last is recorded");
}

TEST_F(ReadSettings, StatisticsAreOffUntilTheyHaveAnInterval)
{
    const StatisticsSettings s = read({}).statistics;
    EXPECT_EQ(s.interval, 0);
    EXPECT_EQ(s.tap_interval, 0);
    EXPECT_TRUE(s.windows.wanted && s.overlaps.wanted && s.voidage.wanted && s.surface.wanted && s.bubbles.wanted);
    EXPECT_FALSE(s.windows.left || s.windows.centre);
    const StatisticsSettings given =
        read({{"statistics", Block{{"interval", 0.05},
                                   {"windows", Block{{"count", 3.0}, {"left", -0.1}, {"right", 0.2}}},
                                   {"overlaps", "none"},
                                   {"voidage", Block{{"bins", 10.0}, {"limits", FakeDictionary::Numbers{0.4, 0.9}}}},
                                   {"surface", "none"}}}})
            .statistics;
    EXPECT_EQ(given.interval, 0.05);
    EXPECT_EQ(given.windows.count, 3);
    EXPECT_EQ(given.windows.left, -0.1);
    EXPECT_FALSE(given.overlaps.wanted || given.surface.wanted || given.bubbles.wanted);
    EXPECT_EQ(given.voidage.limits, (Scalars{0.4, 0.9}));
}

TEST_F(ReadSettings, StatisticsThatCannotBeAreRefused)
{
    using Numbers = FakeDictionary::Numbers;
    const auto refused = [&](const Block& block, const std::string& says) {
        const Problem problem = test::refused([&] { read({{"statistics", block}}); });
        EXPECT_NE(problem.what.find(says), std::string::npos) << problem.what;
        EXPECT_EQ(problem.where.rfind("dict", 0), 0u) << problem.where;
        EXPECT_FALSE(problem.remedy.empty());
    };
    refused({{"interval", -1.0}}, "`interval -1;`");
    refused({{"tapInterval", 0.1}}, "`tapInterval 0.1;` without records.pressureTaps");
    refused({{"windows", Block{{"left", 0.2}, {"right", 0.1}}}}, "`right 0.1;` is not right of `left 0.2;`");
    refused({{"windows", Block{{"count", 2.5}}}}, "a whole number above 0");
    refused({{"windows", Block{{"height", 0.0}}}}, "`height 0;`");
    refused({{"overlaps", Block{{"shares", Numbers{0.1, 0.01}}}}}, "ascending");
    refused({{"overlaps", Block{{"shares", Numbers{}}}}}, "list of numbers");
    refused({{"voidage", Block{{"limits", Numbers{0.5, 1.2}}}}}, "0 to 1");
    refused({{"voidage", Block{{"lowest", 0.8}, {"highest", 0.7}}}}, "the histogram is empty");
    refused({{"surface", Block{{"share", 1.0}}}}, "`share 1;`");
    refused({{"bubbles", Block{{"voidage", 1.5}}}}, "`voidage 1.5;`");
    refused({{"bubbles", Block{{"voidage", 0.7}}}, {"surface", "none"}}, "`surface none;`");
    refused({{"bubble", "none"}}, "unknown entry `bubble`");
}

TEST_F(ReadSettings, NumbersKeepToTheirRanges)
{
    const auto refused = [&](const char* block, const char* key, double value) {
        const Problem problem = test::refused([&] { read({{block, Block{{key, value}}}}); });
        EXPECT_NE(problem.what.find("`" + std::string(key)), std::string::npos) << problem.what;
        EXPECT_EQ(problem.where, "dict." + std::string(block) + ", line 1");
    };
    for (const double packing : {0.0, 1.0, 64.0})
        refused("mapping", "maximumPacking", packing);
    for (const double width : {0.0, -0.1}) {
        refused("mapping", "width", width);
        refused("mapping", "widthInDiameters", width);
    }
    refused("records", "interval", 0);
    refused("records", "snapshotInterval", -1);
    const Problem step = test::refused([&] { read({}, {{"solidStep", 0.0}}); });
    EXPECT_NE(step.what.find("`solidStep 0;` is not accepted: it must be a number [s], above 0"), std::string::npos);
}

TEST_F(ReadSettings, RefusesUnknownKeysAndBlocks)
{
    refuses({{"wieght", 8.0}}, {}, "unknown entry `wieght`", "dict, line 1",
            "did you mean `weight`? known here: plugins, method, weight, particles, gas, drag, forces, mapping, "
            "outsideMesh, "
            "records, statistics, checkpoint");
    refuses({{"maping", Block{}}}, {}, "unknown entry `maping`", "dict, line 1",
            "did you mean `mapping`? known here: plugins, method, weight, particles, gas, drag, forces, mapping, "
            "outsideMesh, "
            "records, statistics, checkpoint");
    refuses({{"gas", Block{{"modell", "none"}}}}, {}, "unknown entry `modell`", "dict.gas, line 1",
            "did you mean `model`? known here: model, coupling");
}

TEST_F(ReadSettings, ASpeltSlipOfALawIsRecognised)
{
    const Problem problem = test::refused([&] { read({{"drag", Block{{"law", "WenYuu"}}}}); });
    EXPECT_EQ(problem.what, "`law WenYuu;` names nothing that is there");
    EXPECT_EQ(problem.where, "dict.drag, line 1");
    EXPECT_EQ(problem.remedy.rfind("did you mean `WenYu`? choose one of BVK, ", 0), 0u) << problem.remedy;
}

TEST_F(ReadSettings, TheScenesOwnNumbersMayStandBesideTheKeys)
{
    const Block scene{{"diameter", 1e-3}, {"height", 0.2}};
    EXPECT_EQ(read({{"diameter", 1e-3}, {"height", 0.2}, {"method", "SPRINGS"}}, {}, scene).method.name, "SPRINGS");
    const Problem other = test::refused([&] { read({{"diameter", 1e-3}, {"depth", 0.2}}, {}, scene); });
    EXPECT_EQ(other.what, "unknown entry `depth`");
    const Problem inside = test::refused([&] { read({{"gas", Block{{"diameter", 1e-3}}}}, {}, scene); });
    EXPECT_EQ(inside.what, "unknown entry `diameter`");  // in a block they have no business
}

}  // namespace
