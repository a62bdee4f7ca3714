// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/fix_fluid.hpp"

#include <algorithm>
#include <cstring>

#include "atom.h"

namespace interphase {

namespace {

/// What travels with an atom, without gaps: of a checkpoint every byte is told.
struct Luggage {
    FluidForce force;
    float unused;
    double booked[3];
    ParticleCoupling coupling;
};
static_assert(sizeof(Luggage) == sizeof(FluidForce) + sizeof(float) + 3 * sizeof(double) + sizeof(ParticleCoupling));
constexpr int luggage_doubles = (sizeof(Luggage) + sizeof(double) - 1) / sizeof(double);

constexpr int grow_callback = 0;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

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
    const int count = atom->nlocal;
    if (count == 0) return;
    double* force = atom->f[0];
    const double* velocity = atom->v[0];
    double* booked = booked_.data();
    for (int i = 0; i < count; ++i)
        forces_[index(i)].apply(force + 3 * i, velocity + 3 * i, booked + 3 * i);
}

void FixFluid::setup(int)
{
    double nowhere[3] = {0, 0, 0};
    for (int i = 0; i < atom->nlocal; ++i)
        forces_[index(i)].apply(atom->f[i], atom->v[i], nowhere);
}

void FixFluid::hold(double dt)
{
    for (int i = 0; i < atom->nlocal; ++i) {
        const Vector force = to_vector(atom->f[i]);
        const Vector seen = to_vector(atom->v[i]) - 0.5 * dt / atom->rmass[i] * force;
        const Vector fluid = forces_[index(i)].part_of(force, seen);
        forces_[index(i)] = FluidForce{};
        set(forces_[index(i)].constant, fluid);
    }
}

FixFluid::State FixFluid::state() const { return {forces_, booked_, coupling_}; }

void FixFluid::take(const State& state)
{
    forces_ = state.forces;
    booked_ = state.booked;
    coupling_ = state.coupling;
    grow_arrays(atom->nmax);
}

void FixFluid::grow_arrays(int count)
{
    forces_.resize(index(count));
    booked_.resize(3 * index(count));
    coupling_.resize(index(count));
}

void FixFluid::copy_arrays(int from, int to, int)
{
    forces_[index(to)] = forces_[index(from)];
    std::copy_n(&booked_[3 * index(from)], 3, &booked_[3 * index(to)]);
    coupling_[index(to)] = coupling_[index(from)];
}

void FixFluid::set_arrays(int i)
{
    forces_[index(i)] = FluidForce{};
    std::fill_n(&booked_[3 * index(i)], 3, 0.0);
    coupling_[index(i)] = ParticleCoupling{};
}

int FixFluid::pack_exchange(int i, double* buffer)
{
    Luggage luggage{forces_[index(i)], 0, {}, coupling_[index(i)]};
    std::copy_n(&booked_[3 * index(i)], 3, luggage.booked);
    std::memcpy(buffer, &luggage, sizeof luggage);
    return luggage_doubles;
}

int FixFluid::unpack_exchange(int i, double* buffer)
{
    Luggage luggage;
    std::memcpy(static_cast<void*>(&luggage), buffer, sizeof luggage);
    forces_[index(i)] = luggage.force;
    std::copy_n(luggage.booked, 3, &booked_[3 * index(i)]);
    coupling_[index(i)] = luggage.coupling;
    return luggage_doubles;
}

double FixFluid::memory_usage() { return static_cast<double>(forces_.size() * sizeof(Luggage)); }

}  // namespace interphase
