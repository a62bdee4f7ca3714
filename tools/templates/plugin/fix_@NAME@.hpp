// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <interphase/plugin.hpp>

#include "cells.hpp"

/// The fix style `@NAME@/spheres`: frictionless spheres that push each other apart while they overlap, by a spring and
/// a dashpot along the line of their centres, and so do the faces of the box that are not periodic:
///
///     fix ID group @NAME@/spheres stiffness K restitution E        K [N/m], E from 0 (excluded) to 1
///
/// It adds forces only: another fix, such as nve/sphere, has to move the spheres. Works on any number of ranks.
class Fix@CLASS@ : public LAMMPS_NS::Fix {
public:
    Fix@CLASS@(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

    int setmask() override;
    void init() override;
    void setup(int) override;
    void post_force(int) override;
    void* extract(const char* name, int& dimension) override;

private:
    double push(double overlap, double approach, double mass) const;
    void push_off_walls(int i);

    double stiffness_ = 0;   // [N/m]
    double log_e_ = 0;       // ln(restitution)
    double damping_ = 0;     // of the dashpot, in sqrt(stiffness * mass)
    double step_limit_ = 0;  // [s]
    double largest_radius_ = 0;
    Cells cells_;
};
