// SPDX-License-Identifier: GPL-3.0-or-later
#include "mp_pic/fix_mp_pic.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "base/problem.hpp"
#include "base/text.hpp"
#include "comm.h"
#include "modify.h"
#include "mp_pic/velocity_limiter.hpp"
#include "neighbor.h"
#include "plugin/plugin.hpp"
#include "script/script.hpp"
#include "update.h"

namespace interphase::mp_pic {

namespace {

constexpr int grow_callback = 0;

const std::vector<std::string> sum_names{"stress_x", "stress_y", "stress_z", "walls_x",
                                         "walls_y",  "walls_z",  "bounces",  "pushed"};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FixMpPic::FixMpPic(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, const std::vector<AnyStress>& stresses,
                   const std::vector<std::string>& usual)
    : Fix(lmp, narg, arg)
{
    if (!atom->sphere_flag) complain("the particles are no spheres; use atom_style granular");
    time_integrate = 1;
    create_attribute = 1;
    restart_global = 1;
    vector_flag = 1;
    size_vector = static_cast<int>(sums_.size());
    global_freq = 1;
    extvector = 1;
    read_arguments({arg + 3, arg + narg}, stresses, usual);
    script::name_values(*lmp, *this, sum_names);
    grow_arrays(atom->nmax);
    atom->add_callback(grow_callback);
}

FixMpPic::~FixMpPic() { atom->delete_callback(id, grow_callback); }

int FixMpPic::setmask() { return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE; }

void FixMpPic::write_restart(FILE* file)
{
    std::array<double, std::tuple_size_v<decltype(sums_)>> all{};
    MPI_Reduce(sums_.data(), all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, 0, world);
    if (comm->me != 0) return;
    const int bytes = sizeof all;
    std::fwrite(&bytes, sizeof bytes, 1, file);
    std::fwrite(all.data(), sizeof all, 1, file);
}

void FixMpPic::restart(char* buffer)
{
    sums_ = {};
    if (comm->me == 0) std::memcpy(sums_.data(), buffer, sizeof sums_);
}

void* FixMpPic::extract(const char* name, int& dimension)
{
    dimension = 0;
    static int yes = 1;
    if (std::strcmp(name, extract_takes_new_forces) == 0) return &yes;
    if (std::strcmp(name, extract_counters) == 0) return &counted_;
    if (stress_ && std::strcmp(name, extract_solid_stress) == 0) return static_cast<SolidStress*>(this);
    return nullptr;
}

void FixMpPic::init()
{
    refuse_company();
    read_restitution();
    script::sort_by_default(*lmp, neighbor->skin);
}

void FixMpPic::setup(int)
{
    walls_.collect(*modify, style);
    if (!walls_.are_of_types(atom->ntypes)) complain("a wall has a type that the simulation box does not know");
    follow_walls();
}

/// Parcels meet a wall where it will be at the end of the step, as it moves now: LIGGGHTS moves meshes before or after
/// them, as the script has it.
void FixMpPic::follow_walls()
{
    if (!walls_.any_travels()) return;
    const double off = walls_.follow();
    walls_.travel(update->dt);
    double smallest = 1e300;
    for (int i = 0; i < atom->nlocal; ++i)
        smallest = std::min(smallest, atom->radius[i]);
    MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, world);
    const double way = update->dt * walls_.fastest();
    if (std::max(way, off) <= walls::most_way_of_walls * smallest) return;
    const std::string what =
        way > off ? "moves by " + text(way) + " m in a step of " + text(update->dt) + " s"
                  : "is " + text(off) + " m from where its last velocity would have brought it in a step";
    complain(
        "a wall " + what + ", more than half the radius of the smallest parcel, " + text(smallest) +
        " m, and may pass through it. Give a shorter step (solidStep), or a wall that is slower or sets out slowly");
}

StepTooLong FixMpPic::begin(double gas_step)
{
    arrived_ = true;
    kicked_whole_ = gas_step < 1.5 * update->dt;
    StepTooLong found;
    int worst = -1;
    double shortest = gas_step;
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit)) continue;
        const LongestStep longest = longest_step(states_[at(i)], to_vector(atom->v[i]), courant_, relaxation_share_);
        found.crossing_cells += longest.crossing < gas_step;
        found.beyond_relaxation += longest.relaxation < update->dt;
        found.longest = std::min({found.longest, longest.crossing, longest.relaxation});
        if (longest.crossing < shortest) {
            shortest = longest.crossing;
            worst = i;
        }
    }
    if (refuses_long_steps_ && worst >= 0) complain_of_step(worst, gas_step, shortest);
    return found;
}

void FixMpPic::complain_of_step(int particle, double gas_step, double longest)
{
    const auto told = [](const double* v) { return text(to_vector(v)); };
    complaint_ = Problem{"particle " + std::to_string(atom->tag[particle]) + " moves at " + told(atom->v[particle]) +
                             " m/s and would cross more than " + text(courant_) + " of its gas cell in a gas step of " +
                             text(gas_step) + " s",
                         "at " + told(atom->x[particle]) + " (fix " + id + " " + style + ")",
                         "give a gas step below " + text(longest) +
                             " s (deltaT in system/controlDict), or `too_fast count` in the script"}
                     .message();
}

void FixMpPic::initial_integrate(int)
{
    if (stress_ && !arrived_)
        complain(
            "no solid stress has arrived. It comes from the gas mesh: run the case through `interphase` "
            "with a gas, or give `stress off` for particles that do not feel each other");
    const double half = 0.5 * update->dt;
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit)) continue;
        kick(i, half);
        if (stress_) {
            const Vector given = atom->rmass[i] * take_stress(i);
            for (int axis = 0; axis < 3; ++axis)
                sums_[at(by_stress + axis)] += given[axis];
        }
        move(i);
    }
}

void FixMpPic::final_integrate()
{
    const double half = 0.5 * update->dt;
    for (int i = 0; i < atom->nlocal; ++i)
        if (atom->mask[i] & groupbit) kick(i, half);
    follow_walls();
}

void FixMpPic::kick(int i, double dt)
{
    const double per_mass = dt / atom->rmass[i];
    for (int axis = 0; axis < 3; ++axis)
        atom->v[i][axis] += per_mass * atom->f[i][axis];
}

Vector FixMpPic::take_stress(int i)
{
    const StressState& state = states_[at(i)];
    const double r = atom->radius[i], density = atom->rmass[i] / (4.0 / 3.0 * M_PI * r * r * r);
    // The mean motion is compared with velocities of its own time, and with these after a whole kick. It is that of
    // whole steps, half a kick behind; or, where the gas step began with its own forces, that before the whole kick.
    const Vector velocity = to_vector(atom->v[i]);
    const Vector kick = update->dt / atom->rmass[i] * to_vector(atom->f[i]);
    const Vector before = velocity - (kicked_whole_ ? 1.0 : 0.5) * kick;
    const double e = restitution_[at(atom->type[i] - 1)];
    const Vector change = limited_stress_change(state, before, before + kick, density, e, update->dt);
    set(atom->v[i], velocity + change);
    set(states_[at(i)].change, to_vector(state.change) + change);
    return change;
}

void FixMpPic::move(int i)
{
    const Vector velocity = to_vector(atom->v[i]);
    walls::Place place;
    set(place.centre, to_vector(atom->x[i]));
    place.radius = atom->radius[i];
    const Drift moved = drift(place, velocity, update->dt, walls_.all(), wall_laws_[at(atom->type[i] - 1)]);
    if (!moved.bounces.empty() || moved.pushed > 0) {
        const Vector given = atom->rmass[i] * (moved.velocity - velocity);
        for (int axis = 0; axis < 3; ++axis)
            sums_[at(by_walls + axis)] += given[axis];
        sums_[bounces] += static_cast<double>(moved.bounces.size());
        sums_[pushed] += moved.pushed;
    }
    for (const Bounce& bounce : moved.bounces)
        walls_.push(bounce.wall, bounce.element, bounce.point, -atom->rmass[i] * bounce.velocity_change);
    set(atom->x[i], moved.position);
    set(atom->v[i], moved.velocity);
}

double FixMpPic::compute_vector(int k)
{
    double sum = 0;
    MPI_Allreduce(&sums_[at(k)], &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
}

void FixMpPic::grow_arrays(int count) { states_.resize(at(count)); }

void FixMpPic::copy_arrays(int from, int to, int) { states_[at(to)] = states_[at(from)]; }

void FixMpPic::set_arrays(int i) { states_[at(i)] = {}; }

int FixMpPic::pack_exchange(int i, double* buffer)
{
    static_assert(sizeof(StressState) % sizeof(double) == 0);
    std::memcpy(buffer, &states_[at(i)], sizeof(StressState));
    return sizeof(StressState) / sizeof(double);
}

int FixMpPic::unpack_exchange(int i, double* buffer)
{
    std::memcpy(static_cast<void*>(&states_[at(i)]), buffer, sizeof(StressState));
    return sizeof(StressState) / sizeof(double);
}

double FixMpPic::memory_usage() { return static_cast<double>(states_.size() * sizeof(StressState)); }

}  // namespace interphase::mp_pic
