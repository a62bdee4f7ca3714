// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in law of hard spheres, as a plug-in's.
#include "hard_sphere/fix_tdhs_of.hpp"

INTERPHASE_LAW("constant_law", interphase::hard_sphere::ConstantRestitution)
