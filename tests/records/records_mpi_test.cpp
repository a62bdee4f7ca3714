// SPDX-License-Identifier: GPL-3.0-or-later
//
// results.h5 and particles.h5 read back, with HDF5 itself, as they were written: by one rank and by all together, and
// the XDMF that leads ParaView to every snapshot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include "base/user_error.hpp"
#include "records/particle_snapshots.hpp"
#include "records/results.hpp"
#include "support/open_file.hpp"
#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::OpenFile;
using test::world;

TEST(Results, AreReadBackAsTheyWereAdded)
{
    const test::ScratchFolder folder(world());
    {
        Results results(world());
        results.describe("/meta", "case", std::string("sscp1"));
        results.describe("/meta", "nothing", std::string());
        results.describe("/meta", "method", std::string("a shorter one takes its place"));
        results.describe("/meta", "method", std::string("W\u00b7d"));
        results.describe("/meta", "weight", 8.0);
        results.describe("/meta", "simulated_time", 0.1);
        results.describe("/meta", "simulated_time", 0.2);  // the later one holds
        Box box = empty_box();
        extend(box, {1, 2, 3});
        extend(box, {4, 5, 6});
        results.describe_box("/meta", "domain", box);
        for (int row = 0; row < 3; ++row) {
            results.add_row("/series", {{"time", "s", 0.05 * row}, {"pressure_drop", "Pa", 1000.0 + row}});
            if (row == 1) results.flush();  // and goes on afterwards
        }
        results.add_row("/ledger", {{"momentum_residual", "1", 1e-15}});
        results.flush();
        results.flush();  // nothing new: adds nothing
    }
    world().barrier();
    if (!world().is_master()) return;

    const OpenFile file("results.h5");
    EXPECT_EQ(file.word("/meta", "case"), "sscp1");
    EXPECT_EQ(file.word("/meta", "nothing"), "");
    EXPECT_EQ(file.word("/meta", "method"), "W\u00b7d");
    EXPECT_EQ(file.attribute("/meta", "weight"), Scalars{8.0});
    EXPECT_EQ(file.attribute("/meta", "simulated_time"), Scalars{0.2});
    EXPECT_EQ(file.attribute("/meta", "domain"), (Scalars{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(file.doubles("/series/time"), (Scalars{0.0, 0.05, 0.1}));
    EXPECT_EQ(file.doubles("/series/pressure_drop"), (Scalars{1000, 1001, 1002}));
    EXPECT_EQ(file.word("/series/pressure_drop", "unit"), "Pa");
    EXPECT_EQ(file.doubles("/ledger/momentum_residual"), Scalars{1e-15});
}

TEST(Results, TakeRowsOfManyNumbersAndGoOnBehindATime)
{
    const test::ScratchFolder folder(world());
    const auto add = [](Results& results, double time, std::size_t width) {
        Results::Row row;
        row.add("time", "s", time);
        row.add("counts", "1", Scalars(width, 10 * time));
        row.add("one", "m", Scalars{time});
        results.add_row("/statistics", row);
    };
    {
        Results results(world());
        results.describe("/statistics", "edges", Scalars{1, 2, 3});
        for (const double time : {0.1, 0.2, 0.3}) {
            add(results, time, 300);
            if (time == 0.2) results.flush();
        }
        results.flush();
    }
    {
        Results results(world(), 0.2);
        add(results, 0.25, 300);
        results.flush();
        add(results, 0.35, 300);
        results.flush();
    }
    world().barrier();
    if (world().is_master()) {
        const OpenFile file("results.h5");
        EXPECT_EQ(file.attribute("/statistics", "edges"), (Scalars{1, 2, 3}));
        EXPECT_EQ(file.doubles("/statistics/time"), (Scalars{0.1, 0.2, 0.25, 0.35}));
        EXPECT_EQ(file.shape("/statistics/counts"), (std::vector<hsize_t>{4, 300}));
        EXPECT_EQ(file.shape("/statistics/one"), (std::vector<hsize_t>{4, 1}));
        const Scalars counts = file.doubles("/statistics/counts");
        for (std::size_t row = 0; row < 4; ++row)
            for (const std::size_t column : {0, 299})
                EXPECT_EQ(counts[300 * row + column], 10 * file.doubles("/statistics/time")[row]);
    }
    world().barrier();
    if (!world().is_master()) return;
    Results results(test::alone(), 0.3);
    add(results, 0.4, 299);
    EXPECT_THROW(results.flush(), UserError);  // what was there stays
}

TEST(Results, AreCompleteAfterAFlushThoughTheRunGoesOn)
{
    const test::ScratchFolder folder(world());
    Results results(world());
    results.add_row("/series", {{"time", "s", 1.0}});
    results.flush();
    results.add_row("/series", {{"time", "s", 2.0}});  // lost if the run died here
    world().barrier();
    if (world().is_master()) {
        std::filesystem::copy_file("results.h5", "copy.h5");  // what a reader finds on the disk
        const OpenFile file("copy.h5");
        EXPECT_EQ(file.doubles("/series/time"), Scalars{1.0});
    }
    world().barrier();
}

TEST(Results, AFolderThatCannotBeWrittenIsNamed)
{
    try {
        Hdf5File::create("/no/such/folder/results.h5");
        FAIL() << "made a file in a folder that is not there";
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("/no/such/folder/results.h5"), std::string::npos) << error.what();
    }
}

/// Rank r holds r + 1 particles in the first snapshot; in the second, rank 0 holds none and the others three each. A
/// particle's values follow from its id. Weights differ in the second.
ParticleRows rows(int snapshot)
{
    const int rank = world().rank();
    const int count = snapshot == 0 ? rank + 1 : rank == 0 ? 0 : 3;
    ParticleRows mine;
    for (int i = 0; i < count; ++i) {
        const int id = 100 * (rank + 1) + i;
        mine.id.push_back(id);
        for (int axis = 0; axis < 3; ++axis) {
            mine.position.push_back(id + 0.1 * axis);
            mine.velocity.push_back(-id + 0.1 * axis);
            mine.angular_velocity.push_back(2 * id + 0.1 * axis);
            mine.force.push_back(1e-6 * id + 0.1 * axis);
        }
        mine.type.push_back(1 + id % 2);
        mine.diameter.push_back(1e-3 * id);
        mine.density.push_back(1000.0 + id);
    }
    if (snapshot == 0) return mine;
    mine.weight.emplace();
    for (const int id : mine.id)
        mine.weight->push_back(0.25 * id);
    return mine;
}

std::vector<int> all_ids(int snapshot)
{
    std::vector<int> ids;
    for (int rank = 0; rank < world().size(); ++rank) {
        const int count = snapshot == 0 ? rank + 1 : rank == 0 ? 0 : 3;
        for (int i = 0; i < count; ++i)
            ids.push_back(100 * (rank + 1) + i);
    }
    return ids;
}

TEST(ParticleSnapshots, HoldEveryRanksParticlesWithTheirOwnValues)
{
    const test::ScratchFolder folder(world());
    ParticleSnapshots snapshots(world());
    snapshots.write(0.0, rows(0));
    snapshots.write(0.125, rows(1));
    world().barrier();
    if (world().is_master()) {
        const OpenFile file("particles.h5");
        for (int snapshot = 0; snapshot < 2; ++snapshot) {
            const std::string group = "/snapshots/00000" + std::to_string(snapshot);
            EXPECT_EQ(file.attribute(group, "time"), Scalars{0.125 * snapshot});
            const std::vector<int> ids = file.integers(group + "/id");
            EXPECT_EQ(ids, all_ids(snapshot));  // in rank order
            EXPECT_EQ(file.shape(group + "/position"), (std::vector<hsize_t>{ids.size(), 3}));
            EXPECT_EQ(file.shape(group + "/diameter"), (std::vector<hsize_t>{ids.size()}));
            EXPECT_EQ(file.word(group + "/force", "unit"), "N");
            EXPECT_EQ(file.word(group + "/density", "unit"), "kg/m3");

            const Scalars x = file.doubles(group + "/position"), v = file.doubles(group + "/velocity");
            const Scalars w = file.doubles(group + "/angular_velocity"), f = file.doubles(group + "/force");
            const Scalars d = file.doubles(group + "/diameter"), density = file.doubles(group + "/density");
            const std::vector<int> types = file.integers(group + "/type");
            EXPECT_EQ(file.has(group + "/weight"), snapshot == 1);
            const Scalars weight = snapshot == 1 ? file.doubles(group + "/weight") : Scalars{};
            for (std::size_t i = 0; i < ids.size(); ++i) {
                EXPECT_EQ(d[i], 1e-3 * ids[i]);
                EXPECT_EQ(density[i], 1000.0 + ids[i]);
                EXPECT_EQ(types[i], 1 + ids[i] % 2);
                if (snapshot == 1) {
                    EXPECT_EQ(weight[i], 0.25 * ids[i]);
                }
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double part = 0.1 * static_cast<double>(axis);
                    EXPECT_EQ(x[3 * i + axis], ids[i] + part);
                    EXPECT_EQ(v[3 * i + axis], -ids[i] + part);
                    EXPECT_EQ(w[3 * i + axis], 2 * ids[i] + part);
                    EXPECT_EQ(f[3 * i + axis], 1e-6 * ids[i] + part);
                }
            }
        }
    }
    world().barrier();
}

TEST(ParticleSnapshots, TheXdmfLeadsToEveryDataSet)
{
    const test::ScratchFolder folder(world());
    ParticleSnapshots snapshots(world());
    snapshots.write(0.0, rows(0));
    snapshots.write(0.125, rows(1));
    world().barrier();
    if (world().is_master()) {
        std::stringstream whole;
        whole << std::ifstream("particles.xdmf").rdbuf();
        const std::string xdmf = whole.str();
        const auto mentions = [&](const std::string& part) { return xdmf.find(part) != std::string::npos; };
        EXPECT_TRUE(mentions("<Time Value=\"0\"/>"));
        EXPECT_TRUE(mentions("<Time Value=\"0.125\"/>"));
        for (int snapshot = 0; snapshot < 2; ++snapshot) {
            const std::string file = "snapshots/00000" + std::to_string(snapshot) + ".h5";
            const std::string n = std::to_string(all_ids(snapshot).size());
            EXPECT_TRUE(mentions("NumberOfElements=\"" + n + "\"/>"));
            if (n == "0") {  // one rank has nobody in the second: no array without rows
                EXPECT_FALSE(mentions(file));
                EXPECT_TRUE(mentions("<Geometry GeometryType=\"XYZ\"/>"));
                continue;
            }
            for (const char* name : {"id", "type", "diameter", "density"})
                EXPECT_TRUE(mentions("Dimensions=\"" + n + "\">" + file + ":/" + name + "</DataItem>")) << name;
            for (const char* name : {"position", "velocity", "angular_velocity", "force"})
                EXPECT_TRUE(mentions("Dimensions=\"" + n + " 3\">" + file + ":/" + name + "</DataItem>")) << name;
        }
        const auto count = [&](const std::string& part) {
            std::size_t found = 0;
            for (std::size_t at = xdmf.find(part); at != std::string::npos; at = xdmf.find(part, at + 1))
                ++found;
            return found;
        };
        EXPECT_EQ(count("/weight</DataItem>"), all_ids(1).empty() ? 0u : 1u);  // where they differ
        EXPECT_EQ(count("<Grid "), count("</Grid>"));
        EXPECT_EQ(count("<Grid "), 3u);  // the collection and its two members
    }
    world().barrier();
}

TEST(Results, GoOnBehindTheRowsUpToATime)
{
    const test::ScratchFolder folder(world());
    {
        Results results(world());
        results.describe("/meta", "case", std::string("sscp1"));
        for (const double row : {1.0, 2.0, 3.0, 4.0})
            results.add_row("/series", {{"time", "s", row / 10}, {"old", "1", row}, {"both", "1", row}});
        results.flush();
    }
    world().barrier();
    const auto series = [](const char* name) { return OpenFile("results.h5").doubles(std::string("/series/") + name); };
    {
        Results results(world(), 0.2);
        if (world().is_master()) {
            EXPECT_EQ(series("time").size(), 4u);  // until the first flush
        }
        results.keep_text("/meta/text", "a");
        results.add_row("/series", {{"time", "s", 0.25}, {"new", "m", 5}, {"both", "1", 5}});
        results.flush();
        results.keep_text("/meta/text", "b");
        results.add_row("/series", {{"time", "s", 0.3}, {"new", "m", 6}, {"both", "1", 6}});
        results.flush();
    }
    world().barrier();
    if (!world().is_master()) return;
    const OpenFile file("results.h5");
    EXPECT_EQ(file.word("/meta", "case"), "sscp1");
    EXPECT_EQ(series("time"), (Scalars{0.1, 0.2, 0.25, 0.3}));
    EXPECT_EQ(series("both"), (Scalars{1, 2, 5, 6}));
    const Scalars old = series("old"), fresh = series("new");  // rows that have no such number hold NaN
    ASSERT_EQ(old.size(), 4u);
    ASSERT_EQ(fresh.size(), 4u);
    for (std::size_t row = 0; row < 4; ++row) {
        EXPECT_EQ(std::isnan(old[row]), row >= 2);
        EXPECT_EQ(std::isnan(fresh[row]), row < 2);
    }
    EXPECT_EQ(file.word("/series/new", "unit"), "m");
}

TEST(Results, TakeEntriesThatComeLater)
{
    const test::ScratchFolder folder(world());
    for (const bool flushed : {false, true}) {
        {
            Results results(world());
            results.add_row("/counters", {{"time", "s", 0.1}, {"old", "1", 1}});
            if (flushed) results.flush();
            results.add_row("/counters", {{"time", "s", 0.2}, {"old", "1", 2}});
            if (flushed) results.flush();
            for (const double row : {3.0, 4.0})
                results.add_row("/counters", {{"time", "s", row / 10}, {"old", "1", row}, {"new", "m", 10 * row}});
            results.flush();
            results.add_row("/counters", {{"time", "s", 0.5}, {"old", "1", 5}, {"new", "m", 50}});
            results.flush();
        }
        world().barrier();
        if (world().is_master()) {
            const OpenFile file("results.h5");
            EXPECT_EQ(file.doubles("/counters/time"), (Scalars{0.1, 0.2, 0.3, 0.4, 0.5}));
            EXPECT_EQ(file.doubles("/counters/old"), (Scalars{1, 2, 3, 4, 5}));
            const Scalars late = file.doubles("/counters/new");
            ASSERT_EQ(late.size(), 5u);
            EXPECT_TRUE(std::isnan(late[0]) && std::isnan(late[1]));
            EXPECT_EQ(Scalars(late.begin() + 2, late.end()), (Scalars{30, 40, 50}));
            EXPECT_EQ(file.word("/counters/new", "unit"), "m");
        }
        world().barrier();
    }
}

TEST(ParticleSnapshots, GoOnBehindThoseUpToATime)
{
    const test::ScratchFolder folder(world());
    {
        ParticleSnapshots snapshots(world());
        for (int number = 0; number < 4; ++number)
            snapshots.write(0.25 * number, rows(number % 2));
    }
    {
        ParticleSnapshots snapshots(world(), 0.25);
        EXPECT_EQ(snapshots.last(), 0.25);
        if (world().is_master()) {
            EXPECT_TRUE(std::filesystem::exists("snapshots/000003.h5"));  // until one takes its place
        }
        world().barrier();
        snapshots.write(0.3, rows(0));
    }
    world().barrier();
    if (!world().is_master()) return;
    const OpenFile file("particles.h5");
    EXPECT_EQ(file.attribute("/snapshots/000001", "time"), Scalars{0.25});
    EXPECT_EQ(file.attribute("/snapshots/000002", "time"), Scalars{0.3});
    EXPECT_FALSE(file.has("/snapshots/000003"));
    EXPECT_FALSE(std::filesystem::exists("snapshots/000003.h5"));
    std::stringstream xdmf;
    xdmf << std::ifstream("particles.xdmf").rdbuf();
    std::size_t times = 0;
    for (const char* time : {"\"0\"", "\"0.25\"", "\"0.3\""})
        times += xdmf.str().find(std::string("<Time Value=") + time) != std::string::npos;
    EXPECT_EQ(times, 3u);
    EXPECT_EQ(xdmf.str().find("\"0.5\""), std::string::npos);
}

}  // namespace
