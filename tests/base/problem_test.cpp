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

TEST(Problem, SaysSinceWhenBeforeTheRemedyAndTheStepAtTheEnd)
{
    EXPECT_EQ((Problem{"it swings", "everywhere", "wait", "for 24 gas steps", "in the gas step from t = 1 s to 2 s"})
                  .message(),
              "it swings\n  where:  everywhere\n  when:   for 24 gas steps\n  remedy: wait\n"
              "  when:   in the gas step from t = 1 s to 2 s");
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
