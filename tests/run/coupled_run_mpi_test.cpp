// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time loop with engines that are fakes: which steps are made, what is recorded when, what a run refuses, and how
// it ends when a step fails.
#include "run/coupled_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <numeric>

#include "base/user_error.hpp"
#include "support/fake_case.hpp"
#include "support/open_file.hpp"
#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::FakeCase;
using test::FakeCaseGas;
using test::FakeDictionary;
using test::FakeEngine;
using test::FakeMaker;
using test::OpenFile;
using test::Particle;
using test::world;
using Block = FakeDictionary::Block;

class CoupledRunTest : public testing::Test {
protected:
    CoupledRunTest()
    {
        if (world().is_master()) std::ofstream("in.script") << "\n";
        world().barrier();
        says({});
        all = {Particle{}};
        all[0].position = Vector(0.5, 0.5, 2);
    }

    /// couplingDict with this beside what it must have.
    void says(const Block& more)
    {
        Block entries{{"particles", Block{{"script", "in.script"}, {"solidStep", solid_step}}}};
        entries.insert(entries.end(), more.begin(), more.end());
        the_case.coupling = FakeDictionary(entries);
    }

    void run()
    {
        const FakeMaker maker([this](const Communicator& comm) {
            auto made =
                std::make_unique<FakeEngine>(comm, comm.is_master() ? all : std::vector<Particle>{}, particle_gravity);
            made->collision_time = collision_time;
            made->to_come = to_come;
            if (comm.is_master()) made->coming = coming;
            engine = made.get();
            return made;
        });
        CoupledRun coupled(the_case, maker, options);
        ended_by = coupled.run();
        advances = engine->advances;
    }

    std::string refusal()
    {
        try {
            run();
        } catch (const UserError& error) {
            return error.what();
        }
        return "";
    }

    test::ScratchFolder folder{world()};
    test::BoxMesh mesh{
        world(), {test::even_planes(0, 1, 2), test::even_planes(0, 1, 2), test::even_planes(0, 4, 8)}, 2};
    FakeCase the_case{world(), mesh};
    Vector particle_gravity = the_case.gravity;
    std::optional<double> collision_time;
    double solid_step = 1e-3;
    std::vector<Particle> all, coming;
    Scalars to_come;
    FakeEngine* engine = nullptr;
    std::vector<int> advances;
    RunOptions options;
    int ended_by = 0;
};

TEST_F(CoupledRunTest, GoesToTheEndInLockstep)
{
    run();
    EXPECT_EQ(the_case.steps.size(), 10u);  // 0.1 s by 0.01 s
    EXPECT_EQ(advances, std::vector<int>(10, 10));
    EXPECT_NEAR(the_case.now, 0.1, 1e-12);
}

TEST_F(CoupledRunTest, RecordsWhatIsDueWhenItIs)
{
    says({{"records", Block{{"interval", 0.02}, {"snapshotInterval", 0.05}}}});
    the_case.write_interval = 0.05;
    run();
    if (!world().is_master()) return;  // who wrote the file
    const OpenFile results("results.h5"), particles("particles.h5");
    const Scalars times = results.doubles("/series/time"), ledger = results.doubles("/ledger/time");
    ASSERT_EQ(times.size(), 6u);  // with that of the start
    for (std::size_t n = 0; n < times.size(); ++n)
        EXPECT_NEAR(times[n], 0.02 * static_cast<double>(n), 1e-9);
    EXPECT_EQ(ledger.size(), 10u);  // one a gas step
    EXPECT_EQ(the_case.written.size(), 2u);
    EXPECT_TRUE(particles.has("/snapshots"));
    EXPECT_NEAR(results.attribute("/meta", "simulated_time").at(0), 0.1, 1e-9);
}

TEST_F(CoupledRunTest, TheFirstRowIsOfTheStart)
{
    says({{"records", Block{{"interval", 0.05}}}});
    run();
    if (!world().is_master()) return;
    const OpenFile results("results.h5");
    const Scalars lowest = results.doubles("/series/lowest_voidage");
    EXPECT_LT(lowest.at(0), 1);
    // in 0.05 s the particle falls by 12 mm, a fortieth of a cell
    EXPECT_NEAR((1 - lowest.at(0)) / (1 - lowest.at(1)), 1, 0.1);
    EXPECT_EQ(results.doubles("/series/time").at(0), 0);
    EXPECT_EQ(results.doubles("/series/particles").at(0), results.doubles("/series/particles").at(1));
}

TEST_F(CoupledRunTest, RecordsNoPressureDropWithoutTapsAndNothingOfAGasThatIsNotThere)
{
    const test::FakeDictionary::Points taps{Vector(0.5, 0.5, 0.5), Vector(0.5, 0.5, 0.7)};
    struct Scene {
        const char* model;
        bool with_taps;
    };
    for (const Scene& scene : {Scene{"pimple", true}, Scene{"pimple", false}, Scene{"none", false}}) {
        Block records{{"interval", 0.05}};
        if (scene.with_taps) records.emplace_back("pressureTaps", taps);
        says({{"gas", Block{{"model", scene.model}}}, {"records", records}});
        the_case.now = 0;
        run();
        if (!world().is_master()) continue;
        const OpenFile results("results.h5");
        const bool has_gas = std::string(scene.model) != "none";
        EXPECT_EQ(results.has("/series/pressure_drop"), scene.with_taps);
        for (const char* name : {"bed_weight_per_area", "lowest_voidage", "highest_voidage", "courant_number"})
            EXPECT_EQ(results.has(std::string("/series/") + name), has_gas) << name;
        EXPECT_TRUE(results.has("/series/kinetic_energy"));
    }
}

TEST_F(CoupledRunTest, AdjustsTheGasStepToTheCourantNumber)
{
    the_case.adjusts = true;
    the_case.largest_courant = 0.5;
    the_case.prepare = [](FakeCaseGas& gas) { gas.courant = 1.0; };
    run();
    ASSERT_GE(the_case.steps.size(), 2u);
    EXPECT_NEAR(the_case.steps[0], 0.005, 1e-12);  // halved before the first step
    EXPECT_NEAR(std::accumulate(the_case.steps.begin(), the_case.steps.end(), 0.0), 0.1, 1e-9);
}

TEST_F(CoupledRunTest, RunsParticlesWithoutAGas)
{
    says({{"gas", Block{{"model", "none"}}}});
    run();
    EXPECT_EQ(the_case.gas, nullptr);
    EXPECT_EQ(std::accumulate(advances.begin(), advances.end(), 0), 100);
    if (world().is_master()) {
        EXPECT_FALSE(OpenFile("results.h5").has("/ledger"));
    }
}

TEST_F(CoupledRunTest, TellsTheGasStepInWhichSomethingWentWrongAndKeepsTheRecords)
{
    int solved = 0;
    the_case.prepare = [&](FakeCaseGas& gas) {
        gas.on_solve = [&] {
            if (++solved == 4) throw UserError(Problem{"the gas has had enough", "in the test", "let it rest"});
        };
    };
    says({{"records", Block{{"interval", 0.01}}}});
    const std::string words = refusal();
    EXPECT_NE(words.find("the gas has had enough"), std::string::npos) << words;
    EXPECT_NE(words.find("in the gas step from t = 0.03 s to 0.04 s"), std::string::npos) << words;
    if (!world().is_master()) return;  // who wrote the file
    const OpenFile results("results.h5");
    EXPECT_EQ(results.doubles("/series/time").size(), 4u);  // with that of the start
    EXPECT_NEAR(results.attribute("/meta", "simulated_time").at(0), 0.04, 1e-9);
}

TEST_F(CoupledRunTest, EndsAfterTheStepInWhichOneRankIsAskedTo)
{
    for (const int signal : {SIGINT, SIGTERM, SIGUSR2}) {
        int solved = 0;
        the_case.end = 0.1;
        the_case.now = 0;
        the_case.steps.clear();
        the_case.written.clear();
        the_case.prepare = [&](FakeCaseGas& gas) {
            gas.on_solve = [&] {
                if (++solved == 4 && world().rank() == world().size() - 1) std::raise(signal);
            };
        };
        says({{"records", Block{{"interval", 0.01}}}});
        run();
        EXPECT_EQ(ended_by, 128 + signal);
        EXPECT_EQ(the_case.steps.size(), 4u);
        EXPECT_EQ(the_case.written.size(), 1u);
        if (!world().is_master()) continue;
        const OpenFile results("results.h5"), particles("particles.h5");
        EXPECT_EQ(results.doubles("/series/time").size(), 5u);  // with that of the start
        EXPECT_NEAR(results.attribute("/meta", "simulated_time").at(0), 0.04, 1e-9);
        EXPECT_EQ(results.word("/meta", "stopped_by").substr(0, 3), "SIG");
        EXPECT_TRUE(particles.has("/snapshots/000001"));
    }
}

TEST_F(CoupledRunTest, EndsBeforeItsLimitOfWallClockTime)
{
    options.wall_limit = 0.1;  // less than the half second that is kept back: after the first step
    the_case.end = 1e3;
    run();
    EXPECT_EQ(ended_by, static_cast<int>(ExitCode::wall_limit));
    EXPECT_EQ(the_case.steps.size(), 1u);
    EXPECT_EQ(the_case.written.size(), 1u);
    if (!world().is_master()) return;
    EXPECT_EQ(OpenFile("results.h5").word("/meta", "stopped_by"), "its limit of wall-clock time");
}

TEST_F(CoupledRunTest, ASecondSignalEndsAtOnce)
{
    if (world().size() > 1) GTEST_SKIP() << "the death test starts a process without ranks";
    the_case.prepare = [&](FakeCaseGas& gas) {
        gas.on_solve = [] {
            std::raise(SIGINT);
            std::raise(SIGTERM);
        };
    };
    EXPECT_EXIT(run(), testing::KilledBySignal(SIGTERM), "");
}

TEST_F(CoupledRunTest, RefusesAnEmptyScene)
{
    all.clear();
    EXPECT_NE(refusal().find("there are no particles"), std::string::npos);
}

TEST_F(CoupledRunTest, StartsEmptyWhereParticlesAreToCome)
{
    all.clear();
    to_come = {5e-4};
    for (const char* model : {"pimple", "none"}) {
        coming.assign(3, Particle{});
        for (std::size_t n = 0; n < coming.size(); ++n) {
            coming[n].id = static_cast<int>(n) + 1;
            coming[n].position = Vector(0.5, 0.5, 1 + static_cast<double>(n));
        }
        says({{"gas", Block{{"model", model}}}, {"records", Block{{"interval", 0.02}}}});
        the_case.now = 0;
        run();
        if (!world().is_master()) continue;
        const OpenFile results("results.h5");
        EXPECT_EQ(results.doubles("/series/particles").back(), 3);
        EXPECT_EQ(results.doubles("/series/particles_in").back(), 3);
        EXPECT_EQ(results.doubles("/series/particles_out").back(), 0);
        EXPECT_EQ(results.attribute("/meta", "particles_at_start").at(0), 0);
        EXPECT_EQ(results.attribute("/meta", "particles").at(0), 3);
        EXPECT_EQ(results.attribute("/meta", "weight").at(0), 1);
    }
}

TEST_F(CoupledRunTest, RefusesTwoGravities)
{
    particle_gravity = Vector(0, 0, -1.62);
    EXPECT_NE(refusal().find("gas and particles feel different gravity"), std::string::npos);
}

TEST_F(CoupledRunTest, RefusesASolidStepThatContactsDoNotBear)
{
    collision_time = 5e-3;
    EXPECT_NE(refusal().find("too long for the contact model"), std::string::npos);
}

TEST_F(CoupledRunTest, RefusesASolidStepLongerThanTheGasStep)
{
    the_case.step = 5e-4;
    EXPECT_NE(refusal().find("is longer than the gas step"), std::string::npos);
}

TEST_F(CoupledRunTest, DerivesTheSolidStepFromTheCollisionTime)
{
    the_case.coupling = FakeDictionary({{"particles", Block{{"script", "in.script"}, {"stepsPerCollision", 20.0}}}});
    collision_time = 5e-2;  // /20 = 2.5e-3 s, four in a gas step
    run();
    EXPECT_EQ(advances, std::vector<int>(10, 4));
}

TEST_F(CoupledRunTest, SaysWhichEnginesRan)
{
    run();
    if (!world().is_master()) return;
    const std::string versions = OpenFile("results.h5").word("/meta", "versions");
    EXPECT_NE(versions.find("PointParticles 1"), std::string::npos) << versions;
    EXPECT_NE(versions.find("BoxGas 1"), std::string::npos) << versions;
}

}  // namespace
