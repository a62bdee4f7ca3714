// SPDX-License-Identifier: GPL-3.0-or-later
// How far a dump is whole, wherever a run may have been killed.
#include "engines/liggghts/solids/dump_files.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace interphase {
namespace {

std::string items(int step)
{
    const std::string number = std::to_string(step);
    return "ITEM: TIMESTEP\n" + number + "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n" +
           "ITEM: ATOMS id x\n1 0." + number + "\n2 0.5\n";
}

std::string xyz(int step) { return "2\nAtoms. Timestep: " + std::to_string(step) + "\n1 0 0 0.1\n1 0 0 0.2\n"; }

WholeFrames of(const std::string& words, int last_step)
{
    std::istringstream text(words);
    return whole_frames(text, last_step).value();
}

TEST(DumpFiles, AreCutBehindTheLastWholeFrameOfAnEarlierStep)
{
    for (const auto& frame : {items, xyz}) {
        const std::string first = frame(100), second = frame(200), third = frame(300);
        EXPECT_EQ(of(first + second + third, 300).end, (first + second + third).size());
        EXPECT_EQ(of(first + second + third, 250).end, (first + second).size());
        EXPECT_EQ(of(first + second + third, 50).end, 0u);
        for (std::size_t left = 0; left < third.size(); ++left) {
            const WholeFrames early = of(first + second + third.substr(0, left), 250);
            EXPECT_EQ(early.end, (first + second).size()) << left;
            const WholeFrames late = of(first + second + third.substr(0, left), 300);
            EXPECT_EQ(late.end, (first + second).size()) << left;
            EXPECT_EQ(late.torn, left > 0) << left;
        }
    }
}

TEST(DumpFiles, AreCutBeforeAFrameThatLacksLines)
{
    const std::string first = items(100), second = items(200), third = items(300);
    for (const std::size_t lost : {3, 6}) {  // the end of a line, a line
        const WholeFrames found = of(first + second.substr(0, second.size() - lost) + third, 300);
        EXPECT_EQ(found.end, first.size());
        EXPECT_TRUE(found.torn);
    }
}

TEST(DumpFiles, OfOtherKindsAreNotCut)
{
    for (const char* words : {"", "# vtk DataFile Version 2.0\n", "12 0.5\n", "solid ascii\n"}) {
        std::istringstream text(words);
        EXPECT_FALSE(whole_frames(text, 100)) << words;
    }
}

}  // namespace
}  // namespace interphase
