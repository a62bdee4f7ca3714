// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/fix_fluid.hpp"

#include <cstring>

#include "atom.h"
#include "momentum/fluid_force.hpp"
#include "update.h"

namespace interphase {

namespace {

constexpr int doubles_per_particle = sizeof(ParticleCoupling) / sizeof(double);
constexpr int grow_callback = 0;

}  // namespace

FixFluid::FixFluid(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    create_attribute = 1;
    grow_arrays(atom->nmax);
    atom->add_callback(grow_callback);
}

FixFluid::~FixFluid() { atom->delete_callback(id, grow_callback); }

int FixFluid::setmask() { return LAMMPS_NS::FixConst::POST_FORCE; }

void FixFluid::post_force(int)
{
    const double dt = update->dt;
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit)) continue;
        Eigen::Map<Vector> force(atom->f[i]);
        force = force_with_fluid(coupling_[static_cast<std::size_t>(i)], force, Eigen::Map<const Vector>(atom->v[i]),
                                 atom->rmass[i], dt);
    }
}

void FixFluid::grow_arrays(int count) { coupling_.resize(static_cast<std::size_t>(count)); }

void FixFluid::copy_arrays(int from, int to, int)
{
    coupling_[static_cast<std::size_t>(to)] = coupling_[static_cast<std::size_t>(from)];
}

void FixFluid::set_arrays(int i) { coupling_[static_cast<std::size_t>(i)] = ParticleCoupling{}; }

int FixFluid::pack_exchange(int i, double* buffer)
{
    std::memcpy(buffer, &coupling_[static_cast<std::size_t>(i)], sizeof(ParticleCoupling));
    return doubles_per_particle;
}

int FixFluid::unpack_exchange(int i, double* buffer)
{
    std::memcpy(static_cast<void*>(&coupling_[static_cast<std::size_t>(i)]), buffer, sizeof(ParticleCoupling));
    return doubles_per_particle;
}

double FixFluid::memory_usage() { return static_cast<double>(coupling_.size() * sizeof(ParticleCoupling)); }

}  // namespace interphase
