// SPDX-License-Identifier: GPL-3.0-or-later
//
// A particle outside the mesh, a value that is not finite, a weight below 1, a lost particle: every rank stops, with a
// message that names who, on which rank, where, and what to do.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::Scene;
using test::world;

constexpr double cell = 0.01;

/// Ten particles with the ids 101 to 110, all at rest; number n on rank n modulo size.
std::vector<Particle> ten()
{
    std::vector<Particle> all;
    for (int n = 0; n < 10; ++n) {
        Particle p;
        p.id = 101 + n;
        p.position = Vector(0.5, 0.5, 0.4 + 0.8 * n) * cell;
        all.push_back(p);
    }
    return all;
}

std::unique_ptr<Scene> scene(const std::vector<Particle>& all, const Settings& rules = {})
{
    const test::BoxMesh::Planes planes{test::even_planes(0, cell, 1), test::even_planes(0, cell, 1),
                                       test::even_planes(0, 8 * cell, 8)};
    return std::make_unique<Scene>(world(), planes, 1.2, 1.8e-5, all, Vector::Zero(), 1e-5, rules);
}

/// What this rank is told; empty where the step went well.
std::string message_of(Scene& s)
{
    try {
        s.advance(5);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts)
{
    for (const std::string& part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

std::string rank_of(int id) { return "rank " + std::to_string((id - 101) % world().size()); }

TEST(Trouble, NoneWhereAllIsWell) { EXPECT_EQ(message_of(*scene(ten())), ""); }

TEST(Trouble, AParticleOutsideTheMeshAtTheStart)
{
    auto all = ten();
    all[6].position = Vector(0.005, 0.012, 0.03);
    const std::string message = message_of(*scene(all));
    expect_parts(message,
                 {"particle 107", rank_of(107), "in no gas cell", "(0.005 0.012 0.03)", "remedy:", "outsideMesh"});
}

TEST(Trouble, AParticleThatLeavesTheMesh)
{
    auto all = ten();
    all[3].velocity = Vector(30, 0, 0);  // a hundred times 1e-5 s: 0.03 m, out of a cell of 0.01
    const auto s = scene(all);
    std::string message;
    for (int n = 0; n < 20 && message.empty(); ++n)
        message = message_of(*s);
    expect_parts(message, {"particle 104", rank_of(104), "in no gas cell"});
}

TEST(Trouble, OutsideTheMeshOnPurposeIsCounted)
{
    auto all = ten();
    all[2].position.x() = -1;
    all[7].position.z() = 1;
    Settings rules;
    rules.outside_mesh = OutsideMesh::ignore;
    const auto s = scene(all, rules);
    s->gas.set_velocity({0, 0, 1});
    for (int n = 0; n < 3; ++n)
        EXPECT_EQ(message_of(*s), "");
    EXPECT_EQ(s->counted("particles_outside_mesh"), 6);
    for (std::size_t i = 0; i < s->particles.size(); ++i)
        EXPECT_EQ(s->particles.velocity(i) == Vector::Zero(), s->particles.id(i) == 103 || s->particles.id(i) == 108)
            << i;
}

TEST(Trouble, AVelocityThatIsNotFiniteAtTheStart)
{
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        auto all = ten();
        all[8].velocity.y() = bad;
        const std::string message = message_of(*scene(all));  // before it could make others' so too
        expect_parts(message, {"velocity", "particle 109", rank_of(109), "not finite", "v = (0 ",
                               "where:  at (0.005 0.005 ", "remedy:"});
    }
}

TEST(Trouble, AVelocityOrPositionThatStopsBeingFinite)
{
    for (const bool position_too : {false, true}) {
        const auto s = scene(ten());
        EXPECT_EQ(message_of(*s), "");
        s->particles.break_next(102, position_too);
        expect_parts(message_of(*s), {"particle 102", rank_of(102), "not finite", "v = (0 nan 0)",
                                      position_too ? "(0.005 0.005 nan)" : "(0.005 0.005 0.012)"});
    }
}

TEST(Trouble, AWeightThatIsNoNumberOfParticles)
{
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {0.5, 0.0, -8.0, std::nan(""), infinite}) {
        auto all = ten();
        all[4].weight = bad;
        const std::string message = message_of(*scene(all));
        expect_parts(message, {"weight", "particle 105", rank_of(105), "is " + text(bad), "(0.005 0.005 0.036)",
                               "remedy:", "property/atom weight"});
    }
}

TEST(Trouble, AWeightThatStopsBeingOne)
{
    const auto s = scene(ten());
    EXPECT_EQ(message_of(*s), "");
    for (std::size_t i = 0; i < s->particles.size(); ++i)
        if (s->particles.id(i) == 108) s->particles.set_weight(i, 0.25);
    expect_parts(message_of(*s), {"weight", "particle 108", rank_of(108), "is 0.25"});
}

TEST(Trouble, AGasFieldOfOneRank)
{
    const auto s = scene(ten());
    EXPECT_EQ(message_of(*s), "");
    if (world().rank() == world().size() - 1)
        s->gas.set_trouble({"the gas field U is not finite in cell 3", "at (0 0 0)", "a shorter gas step"});
    expect_parts(message_of(*s),
                 {"U is not finite in cell 3\n  where:  at (0 0 0)\n  remedy: a shorter"});  // on every rank
}

TEST(Trouble, ALostParticle)
{
    const auto s = scene(ten());
    EXPECT_EQ(message_of(*s), "");
    s->particles.remove_next(105);
    // number 4: at 0.4 + 0.8 n cells
    expect_parts(message_of(*s), {"1 of 10 particles were lost", "where:", "particle 105", rank_of(105),
                                  "(0.005 0.005 0.036)", "remedy:"});
}

TEST(Trouble, AParticleLostInTheFirstStep)
{
    const auto s = scene(ten());
    s->particles.remove_next(105);
    expect_parts(message_of(*s), {"1 of 10 particles were lost", "particle 105", rank_of(105)});
}

TEST(Trouble, ASceneMayRemoveParticles)
{
    const auto s = scene(ten());
    s->particles.allow_removal();
    EXPECT_EQ(message_of(*s), "");
    s->particles.remove_next(105);
    EXPECT_EQ(message_of(*s), "");
    EXPECT_EQ(message_of(*s), "");
}

TEST(Trouble, OutsideTheLawsRangeIsCounted)
{
    // BVK claims voidages from 0.4 to 0.9: one particle of 1 mm in a cell of 10 mm leaves more
    const auto s = scene(ten());
    EXPECT_EQ(message_of(*s), "");
    EXPECT_EQ(s->counted("beyond_drag_range"), 10);
}

}  // namespace
