// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/plugin.hpp"

#include "mp_pic/counters.hpp"
#include "mp_pic/fix_mp_pic.hpp"
#include "mp_pic/fix_wall_mp_pic.hpp"
#include "mp_pic/stress_law.hpp"

using namespace interphase;
using namespace interphase::mp_pic;

namespace {

/// The fix style `mp_pic`, with the stresses of stress_law.hpp.
class FixMpPicOfTree final : public FixMpPic {
public:
    FixMpPicOfTree(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
        : FixMpPic(lmp, narg, arg, {any_stress<HarrisCrighton>("harris_crighton"), any_stress<Lun>("lun")},
                   {"harris_crighton", "100", "3"})
    {}
};

}  // namespace

INTERPHASE_PLUGIN("mp_pic", {"mp_pic", &create<FixMpPicOfTree>}, {"wall/mp_pic", &create<FixWallMpPic>})
INTERPHASE_METHODS(method("MPPIC", "a stress of the solids on the gas mesh").without_single_collisions())
INTERPHASE_COUNTERS(interphase::mp_pic::counters)
