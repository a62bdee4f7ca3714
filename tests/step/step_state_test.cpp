// SPDX-License-Identifier: GPL-3.0-or-later
//
// Series of steps are written and read, also those of a user: with INTERPHASE_STEP_SERIES="a.txt b.txt" (and
// INTERPHASE_GRAVITY, 9.81 unless given) the last test prints what the stability watch finds in each, and fails on any.
#include "step/step_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "support/heard.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

TEST(StepState, ReadsWhatWasWritten)
{
    StepState state = bed(3, 2e-3);
    state.where = Vector(1, 2, 3);
    state.fastest_id = 17;
    state.largest_crossing = 0.25;
    state.largest_wave_crossing = 0.75;
    std::stringstream table;
    write_names(table);
    write(state, table);
    write(bed(4, 2e-3), table);
    const std::vector<StepState> read = read_states(table);
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].where, state.where);
    EXPECT_EQ(read[0].fastest_id, 17);
    EXPECT_EQ(read[0].largest_crossing, 0.25);
    EXPECT_EQ(read[0].largest_wave_crossing, 0.75);
    EXPECT_EQ(read[1].mean_pressure_gradient.z(), -weight);

    std::stringstream some("time mean_pressure_gradient_z\n0.5 nan\n");
    EXPECT_TRUE(std::isnan(read_states(some).at(0).mean_pressure_gradient.z()));
    std::stringstream wrong("time presure\n0.5 1\n");
    EXPECT_THROW(read_states(wrong), std::runtime_error);
}

TEST(StepState, StabilityWatchIsSilentInRecordedSeries)
{
    const char* files = std::getenv("INTERPHASE_STEP_SERIES");
    if (!files) GTEST_SKIP() << "INTERPHASE_STEP_SERIES names none";
    const char* gravity = std::getenv("INTERPHASE_GRAVITY");
    std::istringstream names(files);
    for (std::string name; names >> name;) {
        std::ifstream file(name);
        const std::vector<StepState> states = read_states(file);
        EXPECT_FALSE(states.empty()) << name;
        const Heard heard = hear(states, gravity ? std::atof(gravity) : g);
        std::cout << name << ": " << states.size() << " steps, alternating " << heard.counts.alternating
                  << ", accelerating " << heard.counts.accelerating << ", crossing " << heard.counts.crossing
                  << ", first doubtful step " << heard.first(Stability::doubtful) << ", hopeless "
                  << heard.first(Stability::hopeless) << '\n';
        std::string last;
        for (const std::string& message : heard.messages) {
            std::cout << message << '\n';
            if (message.find("diverges") != std::string::npos) break;  // it is said in every step from there on
        }
        EXPECT_EQ(heard.first(Stability::doubtful), 0) << name;
    }
}

}  // namespace
