// SPDX-License-Identifier: GPL-3.0-or-later
// A fix style that fails: `fix ID all test/fail HOW RANK STEP`, on one rank (-1: on all of them) at the end of a step.
#include <interphase/plugin.hpp>

#include <csignal>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "comm.h"

namespace {

class FixFail : public LAMMPS_NS::Fix {
public:
    FixFail(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
    {
        if (narg != 6) error->all(FLERR, "fix test/fail needs how, on which rank and in which step");
        how_ = arg[3];
        rank_ = std::atoi(arg[4]);
        step_ = std::atol(arg[5]);
    }

    int setmask() override { return LAMMPS_NS::FixConst::END_OF_STEP; }

    void end_of_step() override
    {
        if (update->ntimestep != step_ || (rank_ >= 0 && rank_ != comm->me)) return;
        if (how_ == "all") error->all(FLERR, "told to fail by all");
        if (how_ == "one") error->one(FLERR, "told to fail by one");
        if (how_ == "abort") MPI_Abort(world, 1);
        if (how_ == "exit") std::exit(1);
        if (how_ == "throw") throw std::runtime_error("told to fail by an exception");
        if (how_ == "segv") std::raise(SIGSEGV);
        if (how_ == "kill") std::raise(SIGKILL);
        if (how_ == "nan")
            for (int i = 0; i < atom->nlocal; ++i)
                atom->v[i][0] = std::numeric_limits<double>::quiet_NaN();
    }

private:
    std::string how_;
    int rank_;
    long step_;
};

}  // namespace

INTERPHASE_PLUGIN("fail", {"test/fail", &interphase::create<FixFail>})
