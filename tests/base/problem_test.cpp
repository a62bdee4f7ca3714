// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user reads of a problem: what, where, when, remedy, each on its line.
#include "base/problem.hpp"

#include <gtest/gtest.h>

#include "base/user_error.hpp"

namespace {

using namespace interphase;

const Problem density{"rho = -1 is not positive", "constant/transportProperties, line 3", "give it in kg/m3"};

TEST(Problem, SaysWhatWhereAndWhatToDo)
{
    EXPECT_EQ(density.message(),
              "rho = -1 is not positive\n  where:  constant/transportProperties, line 3\n  remedy: give it in kg/m3");
}

TEST(Problem, LeavesOutWhatItDoesNotKnow)
{
    // a plug-in's complaint comes with its lines
    EXPECT_EQ((Problem{"no step\n  remedy: none", "", ""}).message(), "no step\n  remedy: none");
}

TEST(Problem, SaysWhenBeforeTheRemedy)
{
    EXPECT_EQ(at_time({"it swings", "everywhere", "wait"}, "t = 1 s").message(),
              "it swings\n  where:  everywhere\n  when:   t = 1 s\n  remedy: wait");
}

TEST(Problem, KeepsTheTimesThatItTells)
{
    EXPECT_EQ(at_time(at_time(density, "t = 1 s"), "in a gas step").when, "t = 1 s, in a gas step");
}

TEST(Problem, TwoAreToldOneAfterTheOther)
{
    const Problem other{"mu = 0 is not positive", "line 4", "give it in Pa s"};
    EXPECT_EQ(followed_by(density, other).message(), density.message() + "\n" + other.message());
}

TEST(UserError, SaysTheProblemAndGivesItBack)
{
    const UserError error(density);
    EXPECT_EQ(error.what(), density.message());
    EXPECT_EQ(error.problem().what, density.what);
    EXPECT_EQ(error.problem().where, density.where);
    EXPECT_EQ(error.problem().remedy, density.remedy);
    EXPECT_EQ(UserError(density.what, density.where, density.remedy).what(), density.message());
}

}  // namespace
