// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the coupler keeps of each particle goes with it: spheres fly through a periodic box, changing rank and place in
// LIGGGHTS's arrays many times, and each arrives with the force, the booked sum and the coupling that it was given, has
// felt no other force on the way, and is where that force brings it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "engines/liggghts/plugins/own_methods.hpp"
#include "engines/liggghts/solids/liggghts_solids.hpp"
#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

constexpr int per_side = 5, count = per_side * per_side * per_side;
constexpr double step = 1e-3, diameter = 0.01, density = 1000;  // s, m, kg/m3
constexpr int substeps = 300;
const Vector speed(3, 2, -1);  // m/s: about one, two thirds and a third of the box

void write_script()
{
    std::filesystem::create_directory("dem");  // LIGGGHTS's log goes there
    std::ofstream script("dem/in.liggghts");
    script << "units si\natom_style granular\natom_modify map array sort 1 0.1\nboundary p p p\nnewton off\n"
              "communicate single vel yes\nprocessors * * *\n"
              "region box block 0 1 0 1 0 1 units box\ncreate_box 1 box\n"
              "lattice sc "
           << 1.0 / per_side << "\ncreate_atoms 1 box\n"
           << "set group all diameter " << diameter << " density " << density << "\nvelocity all set " << speed.x()
           << " " << speed.y() << " " << speed.z()
           << " units box\nneighbor 0.01 bin\nneigh_modify delay 0 every 1 check no\nfix move all nve/sphere\n";
}

/// Marks that tell every particle from every other one. Forces are exact in single precision.
Vector force_on(int id) { return Vector(id, -2 * id, 0.5 * id + 1) / 1024; }
Vector booked_of(int id) { return Vector(10 * id, id + 0.25, -id); }
CellAddress owner_cell_of(int id) { return {id % 7, 1000 + id}; }
Vector impulse_of(int id) { return Vector(-id, 0.125 * id, 3 * id); }

class Luggage : public testing::Test {
protected:
    Luggage() : folder_(world())
    {
        if (world().is_master()) write_script();
        world().barrier();
        Settings settings;
        settings.method = own_methods().front();
        settings.script = "dem/in.liggghts";
        solids_ = std::make_unique<LiggghtsSolids>(world(), settings);
        solids_->start(step, substeps, true);
    }

    std::set<int> ids() const
    {
        const ParticleView here = solids_->particles();
        return {here.id, here.id + here.size()};
    }

    void mark()
    {
        const ParticleView here = solids_->particles();
        for (std::size_t i = 0; i < here.size(); ++i) {
            const int id = here.id[i];
            for (int axis = 0; axis < 3; ++axis) {
                here.fluid[i].constant[axis] = static_cast<float>(force_on(id)[axis]);
                here.booked[3 * i + static_cast<std::size_t>(axis)] = booked_of(id)[axis];
            }
            here.coupling[i].owner_cell = owner_cell_of(id);
            set(here.coupling[i].assumed_impulse, impulse_of(id));
        }
    }

    test::ScratchFolder folder_;
    std::unique_ptr<LiggghtsSolids> solids_;
};

/// One flight, as LIGGGHTS does not like to be started twice in a process.
TEST_F(Luggage, IsEmptyAtFirstAndGoesWithItsParticle)
{
    const ParticleView fresh = solids_->particles();
    EXPECT_EQ(world().sum(static_cast<long>(fresh.size())), count);
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        EXPECT_EQ(to_vector(fresh.fluid[i].constant), Vector(0, 0, 0));
        EXPECT_EQ(fresh.fluid[i].rate, 0);
        EXPECT_EQ(fresh.fluid[i].share, 1);
        EXPECT_EQ(fresh.booked_force(i), Vector(0, 0, 0));
        EXPECT_FALSE(fresh.coupling[i].owner_cell.known());
        EXPECT_EQ(to_vector(fresh.coupling[i].assumed_impulse), Vector(0, 0, 0));
    }

    mark();
    const std::set<int> at_start = ids();
    solids_->advance(substeps);

    const ParticleView here = solids_->particles();
    const double mass = density * M_PI / 6 * std::pow(diameter, 3);
    long came = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const int id = here.id[i];
        came += at_start.count(id) == 0;
        const Vector force = force_on(id);
        EXPECT_EQ(to_vector(here.fluid[i].constant), force) << id;
        // a sum of some hundred terms, one for each substep
        EXPECT_LT((here.booked_force(i) - booked_of(id) - substeps * force).norm(), 1e-10 * booked_of(id).norm()) << id;
        EXPECT_EQ(here.coupling[i].owner_cell.rank, owner_cell_of(id).rank) << id;
        EXPECT_EQ(here.coupling[i].owner_cell.cell, owner_cell_of(id).cell) << id;
        EXPECT_EQ(to_vector(here.coupling[i].assumed_impulse), impulse_of(id)) << id;

        // no other particle's force has moved it; velocity Verlet's first half kick was by the forces of the setup:
        // none
        const Vector gained = (substeps - 0.5) * step / mass * force;
        const Vector velocity = here.velocity.col(static_cast<Eigen::Index>(i));
        EXPECT_LT((velocity - speed - gained).norm(), 1e-10 * (speed + gained).norm()) << id;
    }
    EXPECT_EQ(world().sum(static_cast<long>(here.size())), count);
    EXPECT_EQ(world().sum(came) > count / 4, world().size() > 1) << world().sum(came) << " changed rank";
}

}  // namespace
