// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of checkpoints: the newest whole one is found, whatever was cut short, changed or lost of the others.
#include "run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;
namespace fs = std::filesystem;

/// What differs from rank to rank and from time to time.
Archive state_at(double time)
{
    Archive state;
    double number = 100 * time + world().rank();
    std::vector<double> many(1000, number);
    std::string words = "of rank " + std::to_string(world().rank());
    state.keep("number", number);
    state.within("inner", [&] { state.keep("many", many); });
    state.keep("words", words);
    return state;
}

class CheckpointsTest : public testing::Test {
protected:
    void write(double time) { ASSERT_FALSE(checkpoints.write(time, state_at(time), facts)); }

    std::optional<Checkpoints::Found> newest()
    {
        passed_over.clear();
        return checkpoints.newest(passed_over);
    }

    void expect_newest(double time)
    {
        const auto found = newest();
        ASSERT_TRUE(found);
        EXPECT_EQ(found->time, time);
        EXPECT_EQ(found->ranks, world().size());
        EXPECT_EQ(found->facts, facts);
        EXPECT_TRUE(found->state.loads());
        EXPECT_EQ(found->state.state(), state_at(time).state());
    }

    /// On the first rank.
    template <class Body>
    void damage(const Body& body)
    {
        if (world().is_master()) body();
        world().barrier();
    }

    test::ScratchFolder folder{world()};
    Checkpoints checkpoints{world()};
    const Checkpoints::Facts facts{{"version", "interphase 9"}, {"input system/controlDict", "abc def"}};
    std::vector<std::string> passed_over;
    const std::string last_file = "rank" + std::to_string(world().size() - 1) + ".state";
};

TEST_F(CheckpointsTest, GiveBackTheNewestOfTheLastTwo)
{
    EXPECT_FALSE(newest());
    for (const double time : {0.1, 0.25, 1.0 / 3})
        write(time);
    expect_newest(1.0 / 3);
    EXPECT_TRUE(passed_over.empty());
    EXPECT_FALSE(fs::exists("checkpoints/0.1"));
    EXPECT_TRUE(fs::exists("checkpoints/0.25"));
}

TEST_F(CheckpointsTest, ForgetThoseOfAFutureThatWasGivenUp)
{
    write(0.1);
    write(0.3);
    write(0.2);
    expect_newest(0.2);
    EXPECT_FALSE(fs::exists("checkpoints/0.3"));
}

TEST_F(CheckpointsTest, PassOverWhatIsTorn)
{
    write(0.1);
    write(0.2);
    const fs::path file = fs::path("checkpoints/0.2") / last_file, manifest = "checkpoints/0.2/manifest";
    const auto size = fs::file_size(file);
    world().barrier();
    damage([&] {  // one bit
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekg(static_cast<std::streamoff>(size / 2));
        const char byte = static_cast<char>(stream.get() ^ 1);
        stream.seekp(static_cast<std::streamoff>(size / 2));
        stream.put(byte);
    });
    expect_newest(0.1);
    ASSERT_EQ(passed_over.size(), 1u);
    EXPECT_NE(passed_over[0].find("checkpoints/0.2 is no whole checkpoint: " + last_file), std::string::npos)
        << passed_over[0];

    write(0.2);
    damage([&] { fs::resize_file(file, size / 3); });
    expect_newest(0.1);

    write(0.2);
    damage([&] { fs::remove(file); });
    expect_newest(0.1);

    write(0.2);
    damage([&] { fs::resize_file(manifest, fs::file_size(manifest) - 3); });
    expect_newest(0.1);

    write(0.2);
    damage([&] { fs::rename("checkpoints/0.2", "checkpoints/.writing-0.2"); });  // killed before the last step
    expect_newest(0.1);
}

TEST_F(CheckpointsTest, SayWhyTheyCouldNotBeWritten)
{
    write(0.1);
    damage([&] { std::ofstream("checkpoints/.writing-0.2") << "in the way"; });
    EXPECT_FALSE(checkpoints.write(0.2, state_at(0.2), facts));  // of an earlier attempt

    const Checkpoints nowhere(world(), "file/checkpoints");
    damage([&] { std::ofstream("file") << "no folder"; });
    const auto problem = nowhere.write(0.1, state_at(0.1), facts);
    ASSERT_TRUE(problem);
    EXPECT_NE(problem->what.find("the checkpoint of t = 0.1 s could not be written"), std::string::npos);
}

TEST_F(CheckpointsTest, MakeRoomForThoseOfANewRun)
{
    EXPECT_EQ(checkpoints.put_earlier_aside(), "");
    write(0.1);
    EXPECT_EQ(checkpoints.put_earlier_aside(), "checkpoints-of-an-earlier-run-1");
    EXPECT_FALSE(newest());
    write(0.2);
    EXPECT_EQ(checkpoints.put_earlier_aside(), "checkpoints-of-an-earlier-run-2");
    EXPECT_TRUE(fs::exists("checkpoints-of-an-earlier-run-1/0.1/manifest"));
}

}  // namespace
