// SPDX-License-Identifier: GPL-3.0-or-later
//
// A TwinFile is whole whenever somebody looks: while it is being changed, after a change that failed, and after the
// process was killed at a random moment of writing.
#include "records/twin_file.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "base/numbers.hpp"
#include "base/user_error.hpp"
#include "support/open_file.hpp"

namespace {

using namespace interphase;
using test::OpenFile;

class TwinFileTest : public testing::Test {
protected:
    TwinFileTest() : folder_(std::filesystem::temp_directory_path() / ("twin-file-" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(folder_);
        path = folder_ / "table.h5";
    }
    ~TwinFileTest() override { std::filesystem::remove_all(folder_); }

    std::size_t files() const
    {
        const std::filesystem::directory_iterator all(folder_);
        return static_cast<std::size_t>(std::distance(begin(all), end(all)));
    }

    std::string path;

private:
    std::filesystem::path folder_;
};

TwinFile::Change row(double value)
{
    return [value](Hdf5File& file) {
        file.append("/a", "m", {value});
        file.append("/b", "m", {value});
    };
}

TEST_F(TwinFileTest, HasEveryChangeOnceWhicheverCopyIsShown)
{
    Scalars wanted;
    {
        TwinFile file(path);
        for (int n = 0; n < 5; ++n) {
            file.change(row(n));
            wanted.push_back(n);
            if (n == 2) continue;  // two of them at once
            file.publish();
            file.publish();  // nothing new
            EXPECT_EQ(OpenFile(path).doubles("/a"), wanted);
        }
    }
    EXPECT_EQ(OpenFile(path).doubles("/b"), wanted);
    EXPECT_EQ(files(), 1u);  // no copy beside
}

TEST_F(TwinFileTest, IsWholeWhileItIsChanged)
{
    TwinFile file(path);
    file.change(row(1));
    file.publish();
    int looked = 0;
    file.change([](Hdf5File& to) { to.append("/a", "m", {2}); });
    file.change([&](Hdf5File&) {
        if (++looked > 1) return;  // the other copy, which has it later
        const OpenFile seen(path);
        EXPECT_EQ(seen.doubles("/a"), Scalars{1});
        EXPECT_EQ(seen.doubles("/b"), Scalars{1});
    });
    file.change([](Hdf5File& to) { to.append("/b", "m", {2}); });
    file.publish();
    EXPECT_EQ(OpenFile(path).doubles("/b"), (Scalars{1, 2}));
    file.change(row(3));
    file.publish();
    EXPECT_EQ(looked, 2);
}

TEST_F(TwinFileTest, StaysAsItWasWhereAChangeFailsAndGoesOnAfterwards)
{
    TwinFile file(path);
    file.change(row(1));
    file.publish();
    bool fails = true;
    file.change([&fails](Hdf5File& to) {
        to.append("/a", "m", {2});
        if (fails) throw UserError("the disk is full", "the test", "wait");
        to.append("/b", "m", {2});
    });
    EXPECT_THROW(file.publish(), UserError);
    EXPECT_EQ(OpenFile(path).doubles("/a"), Scalars{1});
    EXPECT_EQ(files(), 1u);
    fails = false;
    file.change(row(3));
    file.publish();
    EXPECT_EQ(OpenFile(path).doubles("/a"), (Scalars{1, 2, 3}));
    EXPECT_EQ(OpenFile(path).doubles("/b"), (Scalars{1, 2, 3}));
}

TEST_F(TwinFileTest, IsWholeAfterAKillAtAnyMoment)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<useconds_t> wait(0, 20000);
    for (int kill_number = 0; kill_number < 40; ++kill_number) {
        int pipe_ends[2];
        ASSERT_EQ(pipe(pipe_ends), 0);
        const pid_t writer = fork();
        if (writer == 0) {
            TwinFile file(path);
            for (int n = 1;; ++n) {
                for (int i = 0; i < 3; ++i)
                    file.change(row(n));
                file.publish();
                if (write(pipe_ends[1], "x", 1) != 1) _exit(1);
            }
        }
        close(pipe_ends[1]);
        char published = 0;
        ASSERT_EQ(read(pipe_ends[0], &published, 1), 1);
        usleep(wait(random));
        kill(writer, SIGKILL);
        waitpid(writer, nullptr, 0);
        std::size_t least = 3;  // rows that were said to be there
        while (read(pipe_ends[0], &published, 1) == 1)
            least += 3;
        close(pipe_ends[0]);

        const OpenFile file(path);
        const Scalars a = file.doubles("/a");
        EXPECT_EQ(a, file.doubles("/b"));
        EXPECT_GE(a.size(), least);
        for (std::size_t n = 0; n < a.size(); ++n)
            EXPECT_EQ(a[n], static_cast<double>(1 + n / 3));
    }
}

}  // namespace
