// SPDX-License-Identifier: GPL-3.0-or-later
// A fix style whose effect is known to the last bit: every step it adds the given velocity [m/s] to each particle.
#include <interphase/plugin.hpp>

#include <cstdlib>
#include <cstring>

#ifndef TEST_PLUGIN_NAME
#define TEST_PLUGIN_NAME "kick"
#endif
#ifndef TEST_STYLE_NAME
#define TEST_STYLE_NAME "test/kick"
#endif

namespace {

class FixKick : public LAMMPS_NS::Fix {
public:
    FixKick(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
    {
        if (narg != 6) error->all(FLERR, "fix test/kick needs three components of a velocity");
        for (int i = 0; i < 3; ++i)
            kick_[i] = std::atof(arg[3 + i]);
    }

    int setmask() override { return LAMMPS_NS::FixConst::END_OF_STEP; }

    void end_of_step() override
    {
        for (int i = 0; i < atom->nlocal; ++i)
            for (int k = 0; k < 3; ++k)
                if (atom->mask[i] & groupbit) atom->v[i][k] += kick_[k];
    }

    void* extract([[maybe_unused]] const char* name, int& dimension) override
    {
        dimension = 0;
#ifdef TEST_STEP_LIMIT
        if (std::strcmp(name, interphase::extract_solid_step_limit) == 0) return &step_limit_;
#endif
        return nullptr;
    }

private:
    double kick_[3];
#ifdef TEST_STEP_LIMIT
    double step_limit_ = TEST_STEP_LIMIT;
#endif
};

}  // namespace

INTERPHASE_PLUGIN(TEST_PLUGIN_NAME, {TEST_STYLE_NAME, &interphase::create<FixKick>})
