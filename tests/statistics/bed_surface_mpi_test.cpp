// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of a bed that is higher from column to column, and the voidage of layers and bins.
#include "statistics/bed_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "statistics/bins.hpp"
#include "statistics/solids_energy.hpp"
#include "statistics/voidage_counts.hpp"
#include "support/box_mesh.hpp"
#include "support/shared_particles.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::world;

TEST(BedSurface, FollowsASlope)
{
    Box vessel;
    vessel << 0, 0.1, 0, 0.02, 0, 0.5;
    constexpr double spacing = 1e-3;
    std::vector<Particle> all;
    for (int i = 0; i < 80; ++i)  // the last two columns are empty
        for (int k = 0; (k + 0.5) * spacing < 0.1 + 0.02 * (i / 10); ++k)
            all.push_back(
                {static_cast<int>(all.size()) + 1, spacing * Vector(i + 0.5, 0, k + 0.5), Vector::Zero(), spacing});
    all.push_back(
        {static_cast<int>(all.size()) + 1, {0.005, 0, 0.45}, Vector::Zero(), spacing});  // one that was flung up
    auto particles = test::shared(all);
    const BedSurface surface(vessel, 10, 0.99);
    const Scalars heights = surface.heights(world(), particles.particles());
    double mean = 0;
    for (std::size_t k = 0; k < 8; ++k) {
        const double height = 0.1 + 0.02 * static_cast<double>(k);
        EXPECT_NEAR(heights[k], 0.99 * height, 0.5 / 512 + spacing) << k;  // a bin, and the spacing
        mean += heights[k] / 8;
    }
    EXPECT_TRUE(std::isnan(heights[8]) && std::isnan(heights[9]));
    EXPECT_NEAR(mean_height(heights), mean, 1e-12);
    EXPECT_EQ(surface.column_at(-1), 0u);
    EXPECT_EQ(surface.column_at(0.1), 9u);
}

TEST(Layers, HaveTheVoidageOfTheirCells)
{
    Box vessel;
    vessel << 0, 1, 0, 1, 0, 2;
    for (const double ratio : {1.0, 1.3}) {
        const test::BoxMesh mesh(
            world(), {test::even_planes(0, 1, 3), test::even_planes(0, 1, 2), test::graded_planes(0, 2, 10, ratio)}, 2);
        const Layers layers(world(), mesh.view(), vessel);
        Scalars voidage(mesh.view().size()), even(mesh.view().size(), 0.4);
        for (std::size_t c = 0; c < voidage.size(); ++c)
            voidage[c] = 0.3 + 0.2 * mesh.view().centre[c].z();
        const Scalars means = layers.means(world(), voidage), same = layers.means(world(), even);
        double whole = 0;
        for (std::size_t k = 0; k < layers.count(); ++k) {
            EXPECT_NEAR(same[k], 0.4, 1e-12);
            whole += means[k] / static_cast<double>(layers.count());
            if (ratio == 1) {
                EXPECT_NEAR(means[k], 0.3 + 0.2 * (layers.edges()[k] + layers.edges()[k + 1]) / 2, 1e-12);
            }
        }
        EXPECT_NEAR(whole, 0.5, 1e-12);  // of the whole box
        if (ratio == 1) {
            EXPECT_EQ(layers.count(), 10u);
        }
    }
}

TEST(VoidageCounts, KnowTheirEdges)
{
    const Scalars edges = even_edges(0, 1, 4);
    EXPECT_EQ(bin_of(-0.1, edges), 0u);
    EXPECT_EQ(bin_of(0, edges), 1u);
    EXPECT_EQ(bin_of(0.25, edges), 2u);
    EXPECT_EQ(bin_of(1, edges), 4u);
    EXPECT_EQ(bin_of(1.1, edges), 5u);
    const double ranks = world().size();
    EXPECT_EQ(voidage_counts(world(), {0.1, 0.25, 1}, edges), (Scalars{0, ranks, ranks, 0, ranks, 0}));
}

TEST(SolidsEnergy, OfTwoParticles)
{
    constexpr double mass = 3.14159265358979323846 / 6;  // 1 m, 1 kg/m3
    auto particles = test::shared({{1, {0, 0, 2}, {3, 0, 4}, 1, 1}, {2, {0, 0, 5}, {0, 0, 0}, 1, 1}}, {0, 0, -10});
    const SolidsEnergy found = solids_energy(world(), particles, 1);
    EXPECT_NEAR(found.translation, 12.5 * mass, 1e-12);
    EXPECT_NEAR(found.potential, 10 * (1 + 4) * mass, 1e-12);
    EXPECT_EQ(found.rotation, 0);
}

}  // namespace
