// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/fix_tdhs_of.hpp"
#include "laws/viscoelastic.hpp"
#include "laws/with_cohesion.hpp"
#include "laws/with_rolling.hpp"

using interphase::hard_sphere::ConstantRestitution;
using namespace interphase::laws;

INTERPHASE_PLUGIN("laws", INTERPHASE_LAW_STYLES("viscoelastic", Viscoelastic),
                  INTERPHASE_LAW_STYLES("rolling", WithRolling<ConstantRestitution>),
                  INTERPHASE_LAW_STYLES("cohesive", WithCohesion<ConstantRestitution>),
                  INTERPHASE_LAW_STYLES("cohesive_rolling", WithCohesion<WithRolling<ConstantRestitution>>))
INTERPHASE_COUNTERS(interphase::hard_sphere::counters)
