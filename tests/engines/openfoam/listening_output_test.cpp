// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenFOAM's warnings are told from its other words, whatever they are made of, and all that it prints is in its log.
#include "engines/openfoam/listening_output.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <sstream>

namespace {

using namespace interphase;
using Words = std::vector<std::string>;

Words heard_in(const std::string& printed)
{
    EngineWarnings warnings("OpenFOAM", "log");
    std::stringbuf log;
    ListeningOutput output(&log, warnings);
    std::ostream(&output) << printed << std::flush;
    output.finish_warning();
    EXPECT_EQ(log.str(), printed);
    return warnings.own_news();
}

TEST(ListeningOutput, HearsWhatAWarningSays)
{
    EXPECT_EQ(heard_in("PIMPLE: iteration 1\n"
                       "--> FOAM Warning : \n"
                       "    From function Foam::word Foam::probes::findElements(const Foam::fvMesh&)\n"
                       "    in file probes/probes.C at line 102\n"
                       "    Did not find location (9 9 9) in any cell. Skipping location.\n"
                       "GAMG:  Solving for p_rgh\n"),
              Words{"Did not find location (9 9 9) in any cell. Skipping location."});
}

TEST(ListeningOutput, HearsWhatWasRead)
{
    EXPECT_EQ(
        heard_in("--> FOAM IOWarning : \n"
                 "    From function T get() const\n"
                 "    in file lnInclude/dictionaryTemplates.C at line 90\n"
                 "    Reading /case/system/fvSolution.solvers.p at line 21\n"
                 "    Entry minIter is deprecated\n"
                 "    and of no use\n\nnext\n"),
        Words{"Entry minIter is deprecated and of no use (reading /case/system/fvSolution.solvers.p at line 21)"});
}

TEST(ListeningOutput, HearsSeriousErrorsOfOtherRanks)
{
    EXPECT_EQ(heard_in("[1] --> FOAM Serious Error : \n[1]     From function f\n[1]     in file g at line 7\n"
                       "[1]     cells are inside out\n[1] \n"),
              Words{"cells are inside out"});
}

TEST(ListeningOutput, HearsOneAfterTheOther)
{
    EXPECT_EQ(heard_in("--> FOAM Warning : first\n--> FOAM Warning : second\nCourant 0.3\n"),
              (Words{"first", "second"}));
}

TEST(ListeningOutput, LeavesOtherWordsAlone) { EXPECT_EQ(heard_in("Warning signs\n    From function\n\n"), Words{}); }

}  // namespace
