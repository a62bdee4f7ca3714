// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each pair of spheres that overlap counts once, on any number of ranks and across periodic sides.
#include "statistics/overlap_counts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "support/shared_particles.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::world;

constexpr double diameter = 1e-3;

/// A simple cubic lattice of n^3, `gap` apart.
std::vector<Particle> lattice(int n, double gap)
{
    std::vector<Particle> all;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                all.push_back({static_cast<int>(all.size()) + 1, gap * Vector(i + 0.5, j + 0.5, k + 0.5),
                               Vector::Zero(), diameter});
    return all;
}

TEST(OverlapCounts, OfALattice)
{
    constexpr int n = 7;
    constexpr double share = 0.02;
    auto particles = test::shared(lattice(n, diameter * (1 - share)));
    const OverlapCounts found = overlap_counts(world(), particles.particles(), {}, {0.001, 0.05});
    EXPECT_EQ(found.pairs, 3 * n * n * (n - 1));
    EXPECT_NEAR(found.largest, share, 1e-12);  // differences of lengths 1e-3 to 7e-3, rounded
    EXPECT_EQ(found.below, (Scalars{0, found.pairs}));
    const Scalars& edges = overlap_edges();
    for (std::size_t bin = 0; bin < found.counts.size(); ++bin)
        EXPECT_EQ(found.counts[bin], edges[bin] <= share && share < edges[bin + 1] ? found.pairs : 0) << bin;
}

TEST(OverlapCounts, AcrossPeriodicSides)
{
    constexpr int n = 5;
    const double gap = diameter * 0.99;
    PeriodicBox box;
    box.box << 0, n * gap, 0, n * gap, 0, n * gap;
    for (const int axes : {1, 2, 3}) {
        box.periodic = {axes > 0, axes > 1, axes > 2};
        std::vector<Particle> all = lattice(n, gap);
        all[0].position.x() += n * gap;  // the engine has not brought it back yet
        auto particles = test::shared(all);
        EXPECT_EQ(overlap_counts(world(), particles.particles(), box, {}).pairs, 3 * n * n * (n - 1) + axes * n * n);
    }
}

TEST(OverlapCounts, OfManySizesAsByTryingAllPairs)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 0.05), size(-3, -1.8);  // diameters of 1 to 16 mm
    std::vector<Particle> all;
    for (int n = 0; n < 400; ++n)
        all.push_back(
            {n + 1, {place(random), place(random), place(random)}, Vector::Zero(), std::pow(10.0, size(random))});
    all.push_back({401, {1e4, 0, 0}, Vector::Zero(), 2e-3});  // far away: the table of cells does not grow with it
    double pairs = 0, below = 0, largest = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double depth = (all[i].diameter + all[j].diameter) / 2 - (all[i].position - all[j].position).norm();
            if (depth <= 0) continue;
            const double share = depth / std::min(all[i].diameter, all[j].diameter);
            ++pairs;
            below += share < 0.3;
            largest = std::max(largest, share);
        }
    auto particles = test::shared(all);
    const OverlapCounts found = overlap_counts(world(), particles.particles(), {}, {0.3});
    EXPECT_GT(pairs, 500);
    EXPECT_EQ(found.pairs, pairs);
    EXPECT_EQ(found.below[0], below);
    EXPECT_NEAR(found.largest, largest, 1e-12);
    EXPECT_EQ(std::accumulate(found.counts.begin(), found.counts.end(), 0.0), pairs);
}

TEST(OverlapCounts, OfNoParticles)
{
    auto particles = test::shared({});
    EXPECT_EQ(overlap_counts(world(), particles.particles(), {}, {0.1}).pairs, 0);
}

}  // namespace
