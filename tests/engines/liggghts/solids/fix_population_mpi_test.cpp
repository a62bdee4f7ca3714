// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who left LIGGGHTS, how, and as what: spheres burst out of an open box through its faces, edges and corners, on the
// way from rank to rank, while others are poured in. Each is told once, on one rank, as it was.
#include "engines/liggghts/plugins/own_methods.hpp"
#include "engines/liggghts/solids/fix_population.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "engines/liggghts/solids/liggghts_solids.hpp"
#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

constexpr int per_side = 6, at_start = per_side * per_side * per_side, poured = 32;
constexpr double step = 1e-3, diameter = 0.01, density = 1000;  // s, m, kg/m3
constexpr int substeps = 7;

/// Away from the middle, the farther the faster, so that they do not meet [m/s].
Vector velocity_from(const Vector& at) { return 4 * (at - Vector(0.5, 0.5, 0.5)); }

void write_script()
{
    std::filesystem::create_directory("dem");  // LIGGGHTS's log goes there
    std::ofstream script("dem/in.liggghts");
    script << "units si\natom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\n"
              "communicate single vel yes\nprocessors * * *\n"
              "region box block 0 1 0 1 0 1 units box\ncreate_box 1 box\n"
              "lattice sc "
           << 1.0 / per_side << " origin 0.5 0.5 0.5\ncreate_atoms 1 box\n"
           << "set group all diameter " << diameter << " density " << density
           << "\nneighbor 0.01 bin\nneigh_modify delay 0 every 1 check no\n"
              "fix kind all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant 0.005\n"
              "fix kinds all particledistribution/discrete 32452843 1 kind 1.0\n"
              "region middle block 0.3 0.7 0.3 0.7 0.3 0.7 units box\n"
              "fix pour all insert/pack seed 49979687 distributiontemplate kinds insert_every once overlapcheck yes "
              "all_in yes vel constant 30 20 10 region middle particles_in_region "
           << poured + 8  // with those of the lattice that are there
           << "\nfix move all nve/sphere\n";
}

TEST(FixPopulation, TellsEachThatLeavesOnceAsItWas)
{
    const test::ScratchFolder folder(world());
    if (world().is_master()) write_script();
    world().barrier();
    Settings settings;
    settings.method = own_methods().front();
    settings.script = "dem/in.liggghts";
    LiggghtsSolids solids(world(), settings);
    EXPECT_EQ(solids.radii_to_come(), (Scalars{0.005, 0.005}));
    solids.start(step, 1000, true);

    const ParticleView fresh = solids.particles();
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        solids.kick_again(i, velocity_from(fresh.position.col(column)), Vector::Zero());
        fresh.coupling[i].home = {fresh.id[i] % 5, fresh.id[i]};
    }

    constexpr double mass = density * M_PI / 6 * diameter * diameter * diameter;
    std::map<int, int> told;
    long arrived = 0, there = at_start;
    for (int n = 0; n < 400 && there > 0; ++n) {
        solids.advance(substeps);
        arrived += world().sum(static_cast<long>(solids.arrivals().size()));
        for (const std::size_t i : solids.arrivals())
            EXPECT_FALSE(solids.particles().coupling[i].home.known());
        long fast_and_new = 0;
        for (const Departure& departure : solids.departures()) {
            ++told[departure.id];
            EXPECT_EQ(departure.exit, Exit::boundary);
            EXPECT_NEAR(departure.mass, mass, 1e-12 * mass);
            EXPECT_EQ(departure.radius, diameter / 2);
            const Vector x = to_vector(departure.position), v = to_vector(departure.velocity);
            EXPECT_TRUE((x.array() < 0).any() || (x.array() >= 1).any()) << x.transpose();
            const bool was_poured = departure.id > at_start;
            fast_and_new += departure.is_new;
            if (was_poured) {
                EXPECT_LT((v - Vector(30, 20, 10)).norm(), 1e-9);
                continue;
            }
            EXPECT_EQ(departure.coupling.home.cell, departure.id);
            // on a line from the middle, at the speed that it had there
            EXPECT_LT(((x - Vector(0.5, 0.5, 0.5)).normalized() - v.normalized()).norm(), 1e-9);
        }
        arrived += world().sum(fast_and_new);
        there = world().sum(static_cast<long>(solids.particles().size()));
    }
    EXPECT_EQ(there, 0);
    EXPECT_EQ(arrived, poured);
    for (int id = 1; id <= at_start + poured; ++id) {
        const auto found = told.find(id);
        EXPECT_EQ(world().sum(static_cast<long>(found == told.end() ? 0 : found->second)), 1) << id;
    }
}

}  // namespace
