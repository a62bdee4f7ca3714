// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells above the packing limit hand their excess on through their faces: solids and whatever goes with them stay
// whole, on any number of ranks, and a lack of room is told.
#include <gtest/gtest.h>

#include <numeric>

#include "base/user_error.hpp"
#include "support/mesh_shapes.hpp"
#include "support/sizings.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// Absolute, of sums of some hundred terms of order one.
constexpr double rounding = 1e-12;

constexpr double limit = 0.6;
constexpr std::size_t count = 120;
constexpr double each_volume = 0.1;  ///< [m3]

WholeMesh mesh() { return WholeMesh::of_boxes(unit_planes({6, 5, 8})); }

/// Half of the spheres in eight cells of 1 m3 about the middle, 6 m3 in all; half of them anywhere.
Spheres crowd()
{
    const CellFinder finder(whole_view(mesh()));
    Spheres spheres = scattered(mesh(), count / 2, [](std::size_t) { return 0.4; });
    std::mt19937 random(3);
    std::uniform_real_distribution<double> off(-0.4, 0.4);
    while (spheres.size() < count) {
        const Vector x(3 + off(random), 2.3 + off(random), 4 + off(random));
        spheres.add(x, finder.cell_at(x), sphere_volume(0.4));
    }
    return spheres;
}

MappingRules rules(double maximum_packing, MappingType type = MappingType::kernel)
{
    MappingRules rules;
    rules.type = type;
    rules.maximum_packing = maximum_packing;
    return rules;
}

Scalars filled(MappedSpheres& p) { return p.mapping.solid_volume(Scalars(p.here.size(), each_volume)); }

TEST(PackingLimit, HandsTheExcessOnAndKeepsTheVolume)
{
    for (const MappingType type : {MappingType::kernel, MappingType::cell_centre}) {
        MappedSpheres unlimited(world(), mesh(), crowd(), rules(no_limit, type));
        const Scalars before = unlimited.of_whole_mesh(filled(unlimited));
        ASSERT_GT(*std::max_element(before.begin(), before.end()), limit);  // there is something to do

        MappedSpheres p(world(), mesh(), crowd(), rules(limit, type));
        const Scalars after = p.of_whole_mesh(filled(p));
        EXPECT_LE(*std::max_element(after.begin(), after.end()), limit + 1e-3);  // what it lets stand at last
        EXPECT_NEAR(std::accumulate(after.begin(), after.end(), 0.0), count * each_volume, count * rounding);
        const auto above = std::count_if(before.begin(), before.end(), [](double volume) { return volume > limit; });
        EXPECT_EQ(world().sum(p.mapping.cells_relieved()), above);
    }
}

TEST(PackingLimit, LeavesCellsWithinTheLimitAlone)
{
    MappedSpheres p(world(), mesh(), crowd(), rules(10.0)), unlimited(world(), mesh(), crowd(), rules(no_limit));
    EXPECT_EQ(filled(p), filled(unlimited));
    EXPECT_EQ(p.mapping.cells_relieved(), 0);
}

TEST(PackingLimit, HandsOnThroughFacesOnly)
{
    // One cell of a box of 3 x 3 x 1 with all: what its corners' neighbours get has gone through two faces, so is less;
    // on the other side of a baffle nothing arrives.
    const Vector middle(1.5, 1.5, 0.5);
    Spheres one;
    one.add(middle, 4, sphere_volume(0.1));
    const auto shares = [&](const WholeMesh& of) {
        MappedSpheres p(world(), of, one, rules(limit, MappingType::cell_centre));
        return p.of_whole_mesh(p.mapping.solid_volume(Scalars(p.here.size(), 1.0)));
    };
    const WholeMesh open = WholeMesh::of_boxes(unit_planes({3, 3, 1}));
    const Scalars all = shares(open);
    for (const std::size_t c : {1u, 3u, 5u, 7u})
        EXPECT_NEAR(all[c], 0.1, rounding);
    for (const std::size_t c : {0u, 2u, 6u, 8u})
        EXPECT_EQ(all[c], 0.0);
    const Scalars parted = shares(with_baffle(open, [](const Vector& face) { return face.x() == 2; }));
    EXPECT_NEAR(parted[3], 0.4 / 3, rounding);
    for (const std::size_t c : {2u, 5u, 8u})
        EXPECT_EQ(parted[c], 0.0);
}

TEST(PackingLimit, EverythingElseFollowsTheVolume)
{
    MappedSpheres p(world(), mesh(), crowd(), rules(limit));
    const Scalars volume = filled(p);
    ASSERT_GT(world().sum(p.mapping.cells_relieved()), 0);

    // the same operator: another quantity in proportion to the volume ends where the volume did
    const Scalars doubled = p.mapping.deposit(Scalars(p.here.size(), 2 * each_volume));
    for (std::size_t c = 0; c < volume.size(); ++c)
        EXPECT_NEAR(doubled[c], 2 * volume[c], rounding);

    // any quantity is conserved, a constant stays one, and the two directions are transposed
    const Scalars q = p.of_particles(noise), g = p.of_cells(noise), content = p.mapping.deposit(q);
    EXPECT_NEAR(p.total(content), p.total(q), count * rounding);
    EXPECT_NEAR(p.dot(content, g), p.dot(q, p.at_particles(g)), count * rounding);
    for (const double one : p.at_particles(Scalars(p.view.size(), 1.0)))
        EXPECT_NEAR(one, 1.0, rounding);
}

TEST(PackingLimit, RanksDoNotChangeTheHandOver)
{
    MappedSpheres many(world(), mesh(), crowd(), rules(limit)), one(alone(), mesh(), crowd(), rules(limit));
    const Scalars volume = many.of_whole_mesh(filled(many)), volume_of_one = one.of_whole_mesh(filled(one));
    // many passes, each on the round-off of the one before
    for (std::size_t c = 0; c < volume.size(); ++c)
        EXPECT_NEAR(volume[c], volume_of_one[c], 1e3 * rounding) << c;
    EXPECT_EQ(world().sum(many.mapping.cells_relieved()), one.mapping.cells_relieved());

    const Scalars values = many.of_all_spheres(many.at_particles(many.of_cells(noise)));
    const Scalars values_of_one = one.of_all_spheres(one.at_particles(one.of_cells(noise)));
    for (std::size_t i = 0; i < count; ++i)
        EXPECT_NEAR(values[i], values_of_one[i], 1e3 * rounding) << i;
}

TEST(PackingLimit, WithoutRoomAnywhereAllRanksAreToldWhere)
{
    // 240 cells of 1 m3, 0.6 each: room for 144 m3; the spheres have 180
    MappedSpheres p(world(), mesh(), crowd(), rules(limit));
    try {
        p.mapping.solid_volume(Scalars(p.here.size(), 1.5));
        FAIL() << "180 m3 of solids found room in 144";
    } catch (const UserError& error) {
        const std::string message = error.what();
        for (const char* part :
             {"solid fraction", "in cell", "of rank", "limit of 0.6", "where:  at (", "maximumPacking"})
            EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
    }
}

}  // namespace
