// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of counts has all that a coupling step counts, and says of each what a reader wants to know.
#include "run/count_page.hpp"

#include <gtest/gtest.h>

#include <set>

#include "forces/terms.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

TEST(CountPage, HasWhatAStepCounts)
{
    Settings rules;
    rules.forces = names_of_optional_terms();
    test::Particle particle;
    particle.position = Vector(0.5, 0.5, 0.5);
    const test::Scene scene(
        world(),
        test::BoxMesh::Planes{test::even_planes(0, 1, 4), test::even_planes(0, 1, 4), test::even_planes(0, 1, 4)}, 1.2,
        1.8e-5, {particle}, Vector(0, 0, -9.81), 1e-3, rules);
    const CountKinds known = counts_of_the_step();
    const std::string page = count_page({}, {});
    for (const Count& count : scene.step.counts()) {
        EXPECT_NE(std::find(known.begin(), known.end(), count.kind), known.end()) << count.kind->key;
        EXPECT_NE(page.find("`" + std::string(count.kind->key) + "`"), std::string::npos) << count.kind->key;
    }
}

TEST(CountPage, SaysOfEachWhyAndWhatToDo)
{
    std::set<std::string> keys;
    for (const CountKind* kind : counts_of_the_step()) {
        EXPECT_TRUE(keys.insert(kind->key).second) << kind->key << " is there twice";
        for (const std::string words : {kind->text, kind->meaning, kind->reason})
            EXPECT_FALSE(words.empty()) << kind->key;
        // what is never to be looked at needs no remedy, all else does
        EXPECT_EQ(std::string(kind->remedy).empty(), kind->worry == Worry::never) << kind->key;
        if (kind->worry == Worry::share) {
            EXPECT_FALSE(name_of(kind->whole).empty()) << kind->key;
        }
    }
}

}  // namespace
