// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

#include "mp_pic/counters.hpp"
#include "mp_pic/fix_mp_pic.hpp"
#include "mp_pic/fix_wall_mp_pic.hpp"
#include "plugin/plugin.hpp"

namespace interphase::mp_pic {

/// The fix style `mp_pic/NAME`: mp_pic with a stress as in stress.hpp, which the script calls NAME.
template <class Stress>
class FixMpPicOf final : public FixMpPic {
public:
    FixMpPicOf(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
        : FixMpPic(lmp, narg, arg, {any_stress<Stress>(arg[2] + std::strlen("mp_pic/"))})
    {}
};

}  // namespace interphase::mp_pic

/// The fix styles `mp_pic/NAME` and `wall/mp_pic/NAME` of a stress, for INTERPHASE_PLUGIN.
#define INTERPHASE_STRESS_STYLES(name, Stress)                                     \
    {"mp_pic/" name, &interphase::create<interphase::mp_pic::FixMpPicOf<Stress>>}, \
    {                                                                              \
        "wall/mp_pic/" name, &interphase::create<interphase::mp_pic::FixWallMpPic> \
    }

/// Makes the library that it stands in (once) a plug-in with the styles of these stresses, which count what fix mp_pic
/// does. Their method is MPPIC, which the plug-in mp_pic brings.
#define INTERPHASE_STRESSES(plugin_name, ...)   \
    INTERPHASE_PLUGIN(plugin_name, __VA_ARGS__) \
    INTERPHASE_COUNTERS(interphase::mp_pic::counters)

/// The same of one stress that has the plug-in's name.
#define INTERPHASE_STRESS(name, Stress) INTERPHASE_STRESSES(name, INTERPHASE_STRESS_STYLES(name, Stress))
