// SPDX-License-Identifier: GPL-3.0-or-later
// A fix style whose effect is known to the last bit: every step it adds the given velocity [m/s] to each particle.
#include <interphase/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#ifndef TEST_PLUGIN_NAME
#define TEST_PLUGIN_NAME "kick"
#endif
#ifndef TEST_STYLE_NAME
#define TEST_STYLE_NAME "test/kick"
#endif
#ifndef TEST_COUNTER_KEY
#define TEST_COUNTER_KEY "kicks"
#endif
#ifndef TEST_COUNTERS_TOLD
#define TEST_COUNTERS_TOLD 2
#endif

namespace {

#ifdef TEST_METHOD
using interphase::OverRanks;
constexpr interphase::Counter counters[] = {
    {TEST_COUNTER_KEY, "kicks given", "", OverRanks::sum, 0, "A particle was kicked.", "It is a test.", "no test"},
    {"fastest", "fastest kicked particle", "m/s", OverRanks::largest, 5, "The speed of the fastest.", "It is a test.",
     "a softer kick"}};
#endif

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
        for (int i = 0; i < atom->nlocal; ++i) {
            if (!(atom->mask[i] & groupbit)) continue;
            double* v = atom->v[i];
            for (int k = 0; k < 3; ++k)
                v[k] += kick_[k];
            counted_[0] += 1;
            counted_[1] = std::max(counted_[1], std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
        }
    }

    void* extract([[maybe_unused]] const char* name, int& dimension) override
    {
        dimension = 0;
#ifdef TEST_STEP_LIMIT
        if (std::strcmp(name, interphase::extract_solid_step_limit) == 0) return &step_limit_;
#endif
#ifdef TEST_METHOD
        if (std::strcmp(name, interphase::extract_counters) == 0) return &told_;
#endif
        return nullptr;
    }

private:
    double kick_[3];
    double counted_[2] = {0, 0};
    interphase::CounterValues told_{TEST_COUNTERS_TOLD, counted_};
#ifdef TEST_STEP_LIMIT
    double step_limit_ = TEST_STEP_LIMIT;
#endif
};

}  // namespace

INTERPHASE_PLUGIN(TEST_PLUGIN_NAME, {TEST_STYLE_NAME, &interphase::create<FixKick>})
#ifdef TEST_METHOD
INTERPHASE_METHODS(interphase::method(TEST_METHOD, "kicks").of_particles().steps_per_collision(5))
INTERPHASE_COUNTERS(counters)
#endif
