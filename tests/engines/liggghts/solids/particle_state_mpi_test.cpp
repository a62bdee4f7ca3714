// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spheres that pile up in a vessel of walls, with friction, while more are poured in: LIGGGHTS that is started anew and
// given the state goes on to the last bit as the one that puts back its own, and that one as if nothing had been.
#include "engines/liggghts/plugins/own_methods.hpp"
#include "engines/liggghts/solids/particle_state.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "base/user_error.hpp"
#include "engines/liggghts/solids/liggghts_solids.hpp"
#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

constexpr double step = 2e-5;  // s, a twentieth of a collision
constexpr int substeps = 10;

/// A floor of two triangles.
void write_mesh()
{
    std::ofstream mesh("dem/floor.stl");
    mesh << "solid floor\n";
    for (const char* corners : {"-1 -1 0 1 -1 0 1 1 0", "-1 -1 0 1 1 0 -1 1 0"}) {
        std::istringstream numbers(corners);
        mesh << "facet normal 0 0 1\nouter loop\n";
        for (double x = 0, y = 0, z = 0; numbers >> x >> y >> z;)
            mesh << "vertex " << 0.02 + 0.03 * x << ' ' << 0.02 + 0.019 * y << ' ' << z << '\n';
        mesh << "endloop\nendfacet\n";
    }
    mesh << "endsolid floor\n";
}

void write_script(const std::string& more = "")
{
    std::filesystem::create_directory("dem");  // LIGGGHTS's log goes there
    write_mesh();
    std::ofstream script("dem/in.liggghts");
    script
        << "units si\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
           "communicate single vel yes\nprocessors * * *\n"
           "region box block 0 0.04 0 0.04 -0.01 0.1 units box\ncreate_box 1 box\n"
           "neighbor 0.001 bin\nneigh_modify delay 0\n"
           "fix m1 all property/global kn peratomtypepair 1 500\nfix m2 all property/global kt peratomtypepair 1 200\n"
           "fix m3 all property/global gamman_abs peratomtypepair 1 0.05\n"
           "fix m4 all property/global gammat_abs peratomtypepair 1 0.05\n"
           "fix m5 all property/global coefficientFriction peratomtypepair 1 0.4\n"
           "pair_style gran model hooke/stiffness tangential history absolute_damping on\npair_coeff * *\n"
           "fix floor all mesh/surface file dem/floor.stl type 1\n"
           "fix low all wall/gran model hooke/stiffness tangential history mesh n_meshes 1 meshes floor "
           "absolute_damping on\n"
           "fix side3 all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.0 "
           "absolute_damping on\n"
           "fix side4 all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.04 "
           "absolute_damping on\n"
           "fix side1 all wall/gran model hooke/stiffness tangential history primitive type 1 xplane 0.0 "
           "absolute_damping on\n"
           "fix side2 all wall/gran model hooke/stiffness tangential history primitive type 1 xplane 0.04 "
           "absolute_damping on\n"
           "fix g all gravity 9.81 vector 0.3 0 -1\n"
           "fix small all particletemplate/sphere 15485863 atom_type 1 density constant 1500 radius constant 0.0015\n"
           "fix large all particletemplate/sphere 15485867 atom_type 1 density constant 1500 radius constant 0.0025\n"
           "fix kinds all particledistribution/discrete 32452843 2 small 0.5 large 0.5\n"
           "region fill block 0.005 0.035 0.005 0.035 0.01 0.09 units box\n"
           "fix pour all insert/pack seed 49979687 distributiontemplate kinds insert_every 300 overlapcheck yes "
           "all_in yes vel uniform 0 0 -0.3 0.1 0.1 0.1 region fill particles_in_region 150\n"
           "fix move all nve/sphere\n"
        << more;
}

Settings settings()
{
    Settings settings;
    settings.method = own_methods().front();
    settings.script = "dem/in.liggghts";
    return settings;
}

class ParticleState : public testing::Test {
protected:
    void script(const std::string& more = "")
    {
        if (world().is_master()) write_script(more);
        world().barrier();
    }

    static void advance(LiggghtsSolids& solids, int times)
    {
        for (int n = 0; n < times; ++n)
            solids.advance(substeps);
    }

    /// As CoupledRun names it.
    static void keep(LiggghtsSolids& solids, Archive& archive)
    {
        archive.within("solids", [&] { solids.keep(archive); });
    }

    static Archive kept(LiggghtsSolids& solids)
    {
        Archive saved;
        keep(solids, saved);
        Archive loading = saved.to_load();
        keep(solids, loading);
        return saved;
    }

    struct Sphere {
        Vector position, velocity, spin, force;
    };
    static std::map<int, Sphere> all_of(LiggghtsSolids& solids)
    {
        std::map<int, Sphere> all;
        const ParticleView now = solids.particles();
        for (std::size_t i = 0; i < now.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            all[now.id[i]] = {now.position.col(k), now.velocity.col(k), now.angular_velocity.col(k), now.force.col(k)};
        }
        return all;
    }

    /// What rank `rank` has taken in, on all.
    static Archive::State from_rank(int rank, const Archive::State& own)
    {
        Archive::State state;
        auto count = static_cast<int>(own.size());
        MPI_Bcast(&count, 1, MPI_INT, rank, world().handle());
        auto entry = own.begin();
        const bool sends = world().rank() == rank;
        const auto shared = [rank](std::vector<char> bytes) {
            auto size = static_cast<int>(bytes.size());
            MPI_Bcast(&size, 1, MPI_INT, rank, world().handle());
            bytes.resize(static_cast<std::size_t>(size));
            MPI_Bcast(bytes.data(), size, MPI_BYTE, rank, world().handle());
            return bytes;
        };
        for (int n = 0; n < count; ++n) {
            const std::vector<char> name =
                shared(sends ? std::vector<char>(entry->first.begin(), entry->first.end()) : std::vector<char>{});
            state[{name.begin(), name.end()}] = shared(sends ? entry->second : std::vector<char>{});
            if (sends) ++entry;
        }
        return state;
    }

    test::ScratchFolder folder{world()};
    const Settings rules = settings();
};

TEST_F(ParticleState, LetsAnotherLiggghtsGoOnToTheLastBit)
{
    script();
    LiggghtsSolids straight(world(), rules);
    straight.start(step, 100000, true);
    advance(straight, 400);
    Archive loading = kept(straight).to_load();
    advance(straight, 500);

    LiggghtsSolids resumed(world(), rules);
    resumed.go_on_from(loading, 400 * step);
    resumed.start(step, 100000, true);
    keep(resumed, loading);
    advance(resumed, 500);

    const auto expected = all_of(straight), found = all_of(resumed);
    EXPECT_GT(world().sum(static_cast<long>(expected.size())), 100);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [id, sphere] : expected) {
        ASSERT_EQ(found.count(id), 1u) << id;
        EXPECT_EQ(found.at(id).position, sphere.position) << id;
        EXPECT_EQ(found.at(id).velocity, sphere.velocity) << id;
        EXPECT_EQ(found.at(id).spin, sphere.spin) << id;
        EXPECT_EQ(found.at(id).force, sphere.force) << id;
    }
}

/// What is put back is what was there, contact springs included: one step later the difference is that of sums in
/// another order.
TEST_F(ParticleState, DisturbsNothing)
{
    script();
    LiggghtsSolids solids(world(), rules), twin(world(), rules);
    for (LiggghtsSolids* each : {&solids, &twin}) {
        each->start(step, 100000, true);
        advance(*each, 290);  // just before some are poured in
    }
    kept(solids);
    for (LiggghtsSolids* each : {&solids, &twin})
        advance(*each, 3);
    const auto expected = all_of(twin), found = all_of(solids);
    double largest_force = 0;
    for (const auto& [id, sphere] : expected)
        largest_force = std::max(largest_force, sphere.force.norm());
    largest_force = world().max(largest_force);
    EXPECT_GT(largest_force, 1e-2);  // a hundred times the weight of a sphere: there are contacts
    for (const auto& [id, sphere] : expected) {
        const auto same = found.find(id);
        if (same == found.end()) continue;  // it has changed rank a few steps earlier or later
        EXPECT_LT((same->second.position - sphere.position).norm(), 1e-15) << id;
        EXPECT_LT((same->second.velocity - sphere.velocity).norm(), 1e-11) << id;
        EXPECT_LT((same->second.force - sphere.force).norm(), 1e-8 * largest_force) << id;
    }
}

/// From all ranks to each alone, and back: none lost or doubled, and three gas steps later the forces, contact springs
/// included, are those where nothing was moved.
TEST_F(ParticleState, GoesToOtherRanks)
{
    script();
    const Communicator& alone = test::alone();
    for (const bool from_all : {true, false}) {
        const Communicator &before = from_all ? world() : alone, &after = from_all ? alone : world();
        LiggghtsSolids solids(before, rules);
        solids.start(step, 100000, true);
        advance(solids, 400);
        const Archive saved = kept(solids);
        const long number = before.sum(static_cast<long>(all_of(solids).size()));
        EXPECT_GT(number, 100);

        std::map<int, Archive::State> mine;
        if (from_all)
            for (int rank = 0; rank < world().size(); ++rank)
                mine[rank] = from_rank(rank, saved.state());
        else if (world().is_master())
            mine[0] = saved.state();
        Archive loading = Archive::loading(after, before.size(), mine);
        LiggghtsSolids moved(after, rules);
        moved.go_on_from(loading, 400 * step);
        moved.start(step, 100000, true);
        keep(moved, loading);
        EXPECT_EQ(after.sum(static_cast<long>(all_of(moved).size())), number);

        for (LiggghtsSolids* each : {&solids, &moved})
            advance(*each, 3);
        const auto expected = all_of(solids), found = all_of(moved);
        double largest_force = 0;
        for (const auto& [id, sphere] : expected)
            largest_force = std::max(largest_force, sphere.force.norm());
        largest_force = world().max(largest_force);
        long compared = 0;
        for (const auto& [id, sphere] : expected) {
            const auto same = found.find(id);
            if (same == found.end()) continue;  // on another rank
            ++compared;
            EXPECT_LT((same->second.position - sphere.position).norm(), 1e-15) << id;
            EXPECT_LT((same->second.velocity - sphere.velocity).norm(), 1e-11) << id;
            EXPECT_LT((same->second.force - sphere.force).norm(), 1e-8 * largest_force) << id;
        }
        EXPECT_EQ(world().sum(compared), number);
    }
}

TEST_F(ParticleState, RefusesWhatItCannotHold)
{
    script();
    EXPECT_FALSE(LiggghtsSolids(world(), rules).cannot_be_kept());
    script("fix up all move/mesh mesh floor linear 0. 0. 0.1\n");
    const auto problem = LiggghtsSolids(world(), rules).cannot_be_kept();
    ASSERT_TRUE(problem);
    EXPECT_NE(problem->message().find("fix up (move/mesh)"), std::string::npos) << problem->message();
}

TEST_F(ParticleState, RefusesAnotherScript)
{
    script();
    Archive saved;
    {
        LiggghtsSolids solids(world(), rules);
        solids.start(step, 100000, true);
        keep(solids, saved);
    }
    script("fix heat all property/atom heat scalar yes no no 0\n");
    LiggghtsSolids other(world(), rules);
    other.start(step, 100000, true);
    Archive loading = saved.to_load();
    EXPECT_THROW(keep(other, loading), UserError);
}

}  // namespace
