// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fix.h"
#include "momentum/particle_coupling.hpp"

namespace interphase {

/// The LIGGGHTS fix style `interphase/fluid`: keeps a ParticleCoupling per atom, lets it travel with its atom, and turns
/// the sum of all other forces into the one that force_with_fluid() gives. It must be the last fix that changes forces.
class FixFluid : public LAMMPS_NS::Fix {
public:
    static constexpr const char* style_name = "interphase/fluid";

    FixFluid(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
    ~FixFluid() override;

    int setmask() override;
    void post_force(int) override;

    void grow_arrays(int count) override;
    void copy_arrays(int from, int to, int) override;
    void set_arrays(int i) override;
    int pack_exchange(int i, double* buffer) override;
    int unpack_exchange(int i, double* buffer) override;
    double memory_usage() override;

    ParticleCoupling* coupling() { return coupling_.data(); }

private:
    std::vector<ParticleCoupling> coupling_;
};

}  // namespace interphase
