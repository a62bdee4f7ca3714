// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fix.h"
#include "momentum/fluid_force.hpp"
#include "momentum/particle_coupling.hpp"

namespace interphase {

/// The LIGGGHTS fix style `interphase/fluid`: keeps a FluidForce, its booked sum and a ParticleCoupling per atom, lets
/// them travel with their atom, and applies the force. It must be the last fix that changes forces.
class FixFluid : public LAMMPS_NS::Fix {
public:
    static constexpr const char* style_name = "interphase/fluid";

    FixFluid(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
    ~FixFluid() override;

    int setmask() override;
    void setup(int) override;  ///< the forces again, which are booked already
    void post_force(int) override;

    void grow_arrays(int count) override;
    void copy_arrays(int from, int to, int) override;
    void set_arrays(int i) override;
    int pack_exchange(int i, double* buffer) override;
    int unpack_exchange(int i, double* buffer) override;
    double memory_usage() override;

    FluidForce* forces() { return forces_.data(); }
    double* booked() { return booked_.data(); }
    ParticleCoupling* coupling() { return coupling_.data(); }

    /// Makes the force on each particle [N] the one that it felt last, whatever its velocity becomes: that of the
    /// middle of the step of `dt` [s] was seen (velocity Verlet; where particles move first, nobody asks for it).
    void hold(double dt);

    /// Of all particles, in their order.
    struct State {
        std::vector<FluidForce> forces;
        std::vector<double> booked;
        std::vector<ParticleCoupling> coupling;
    };
    State state() const;
    void take(const State& state);

private:
    std::vector<FluidForce> forces_;
    std::vector<double> booked_;  ///< flat [n x 3]
    std::vector<ParticleCoupling> coupling_;
};

}  // namespace interphase
