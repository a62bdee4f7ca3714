// SPDX-License-Identifier: GPL-3.0-or-later
//
// LIGGGHTS's warnings are told from its other words, and what it writes is in its log all the same.
#include "engines/liggghts/script/listening_screen.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace {

using namespace interphase;

TEST(LiggghtsWarning, IsWhatFollowsTheMark)
{
    EXPECT_EQ(warning_in("WARNING: time-step is 23.5 % of rayleigh time"), "time-step is 23.5 % of rayleigh time");
    EXPECT_EQ(warning_in("WARNING: Less insertions than requested (./src/fix_insert.cpp:1112)"),
              "Less insertions than requested");
    EXPECT_EQ(warning_in("WARNING: Mesh a (of b) is odd"), "Mesh a (of b) is odd");
    EXPECT_EQ(warning_in("WARNING on proc 3: Elements are not neighbors (./src/surface_mesh_I.h:77)"),
              "on proc 3: Elements are not neighbors");
    EXPECT_EQ(warning_in("  Warning: maxLiquidContent was specified"), "maxLiquidContent was specified");
    for (const char* other : {"", "Step Atoms KinEng", "print \"WARNING: x\"", "WARNINGS: 3", "WARNING:"})
        EXPECT_EQ(warning_in(other), "") << other;
}

TEST(ListeningScreen, HearsLinesAndPassesAllOn)
{
    std::FILE* log = std::tmpfile();
    std::FILE* screen = log;
    EngineWarnings warnings("LIGGGHTS", "log");
    {
        ListeningScreen listening(screen, warnings);
        ASSERT_NE(screen, log);
        std::fputs("run 10\nWARN", screen);
        listening.flush();
        EXPECT_TRUE(warnings.own_news().empty());
        std::fputs("ING: slow\nWARNING: cold", screen);
        listening.flush();
        EXPECT_EQ(warnings.own_news(), std::vector<std::string>{"slow"});
        std::rewind(log);
        char text[64] = {};
        EXPECT_EQ(std::fread(text, 1, sizeof text, log), 34u);
        EXPECT_EQ(std::string(text), "run 10\nWARNING: slow\nWARNING: cold");
    }
}

}  // namespace
