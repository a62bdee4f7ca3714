// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "hard_sphere/counters.hpp"
#include "hard_sphere/fix_tdhs.hpp"
#include "hard_sphere/fix_wall_tdhs.hpp"
#include "hard_sphere/law_of.hpp"
#include "plugin/plugin.hpp"

namespace interphase::hard_sphere {

/// The fix style of hard spheres with a law as in law.hpp.
template <class Law>
class FixTdhsOf final : public FixTdhs {
public:
    FixTdhsOf(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : FixTdhs(lmp, narg, arg, std::make_unique<LawOf<Law>>()) {}
};

}  // namespace interphase::hard_sphere

/// The fix styles `tdhs/NAME` and `wall/tdhs/NAME` of a law, for INTERPHASE_PLUGIN.
#define INTERPHASE_LAW_STYLES(name, Law)                                             \
    {"tdhs/" name, &interphase::create<interphase::hard_sphere::FixTdhsOf<Law>>},    \
    {                                                                                \
        "wall/tdhs/" name, &interphase::create<interphase::hard_sphere::FixWallTdhs> \
    }

/// Makes the library that it stands in (once) a plug-in with these styles and the counters of hard spheres.
#define INTERPHASE_LAW(name, Law)                             \
    INTERPHASE_PLUGIN(name, INTERPHASE_LAW_STYLES(name, Law)) \
    INTERPHASE_COUNTERS(interphase::hard_sphere::counters)
