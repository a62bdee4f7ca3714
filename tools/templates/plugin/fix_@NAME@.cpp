// SPDX-License-Identifier: GPL-3.0-or-later
#include "fix_@NAME@.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

// This line makes the library a plug-in. More fix styles: more {"name", creator} pairs.
INTERPHASE_PLUGIN("@NAME@", {"@NAME@/spheres", &interphase::create<Fix@CLASS@>})

Fix@CLASS@::Fix@CLASS@(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    // arg: ID, group, style, and then what is ours
    double restitution = 0;
    for (int i = 3; i < narg; i += 2) {
        char* end = nullptr;
        const double value = i + 1 < narg ? std::strtod(arg[i + 1], &end) : 0;
        const bool is_number = end && end != arg[i + 1] && *end == '\0';
        if (is_number && std::strcmp(arg[i], "stiffness") == 0)
            stiffness_ = value;
        else if (is_number && std::strcmp(arg[i], "restitution") == 0)
            restitution = value;
        else
            error->all(FLERR, "fix @NAME@/spheres wants: stiffness K [N/m] restitution E");
    }
    if (!(stiffness_ > 0)) error->all(FLERR, "fix @NAME@/spheres: give a stiffness above 0 N/m");
    if (!(restitution > 0 && restitution <= 1))
        error->all(FLERR, "fix @NAME@/spheres: give a restitution above 0 and at most 1");

    // m x'' + c x' + k x = 0 ends at e times the approach speed when c = -2 ln(e) sqrt(m k/(pi^2 + ln(e)^2))
    log_e_ = std::log(restitution);
    damping_ = -2 * log_e_ / std::sqrt(M_PI * M_PI + log_e_ * log_e_);
}

int Fix@CLASS@::setmask() { return LAMMPS_NS::FixConst::POST_FORCE; }

void Fix@CLASS@::init()
{
    if (!atom->sphere_flag) error->all(FLERR, "fix @NAME@/spheres needs spheres: atom_style granular");
    // The dashpot needs the velocities of ghosts: copies of spheres that belong to other ranks, or to the other side of
    // a periodic box.
    if (!comm->ghost_velocity) error->all(FLERR, "fix @NAME@/spheres needs: communicate single vel yes");

    largest_radius_ = 0;
    for (int i = 0; i < atom->nlocal; ++i)
        largest_radius_ = std::max(largest_radius_, atom->radius[i]);
    MPI_Allreduce(MPI_IN_PLACE, &largest_radius_, 1, MPI_DOUBLE, MPI_MAX, world);

    // Ghosts have to reach as far as a contact, and the skin on top: spheres move between two exchanges.
    comm->cutghostuser = std::max(comm->cutghostuser, 2 * largest_radius_ + neighbor->skin);
}

/// The forces at the start of the first step.
void Fix@CLASS@::setup(int vflag) { post_force(vflag); }

/// Force [N] that drives two bodies apart; `mass` is their reduced mass, `approach` the speed at which they near.
double Fix@CLASS@::push(double overlap, double approach, double mass) const
{
    return stiffness_ * overlap + damping_ * std::sqrt(stiffness_ * mass) * approach;
}

void Fix@CLASS@::post_force(int)
{
    double** x = atom->x;
    double** v = atom->v;
    const double* radius = atom->radius;
    const double* mass = atom->rmass;
    if (largest_radius_ == 0) return;
    cells_.sort(x, atom->nlocal + atom->nghost, 2 * largest_radius_);

    // Every rank computes the force on its own spheres, so a pair is seen twice, with the same numbers and opposite
    // signs: momentum is conserved, on however many ranks.
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit)) continue;
        cells_.near(x[i], [&](int j) {
            if (j == i || !(atom->mask[j] & groupbit)) return;
            const double d[3] = {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
            const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            const double touch = radius[i] + radius[j];
            if (squared >= touch * touch || squared == 0) return;
            const double distance = std::sqrt(squared);
            double approach = 0;
            for (int k = 0; k < 3; ++k)
                approach -= (v[i][k] - v[j][k]) * d[k] / distance;
            const double force = push(touch - distance, approach, mass[i] * mass[j] / (mass[i] + mass[j]));
            for (int k = 0; k < 3; ++k)
                atom->f[i][k] += force * d[k] / distance;
        });
        push_off_walls(i);
    }
}

void Fix@CLASS@::push_off_walls(int i)
{
    const double radius = atom->radius[i], mass = atom->rmass[i];
    for (int k = 0; k < 3; ++k) {
        if (domain->periodicity[k]) continue;
        const double position = atom->x[i][k], velocity = atom->v[i][k];
        const double below = domain->boxlo[k] + radius - position, above = position + radius - domain->boxhi[k];
        if (below > 0) atom->f[i][k] += push(below, -velocity, mass);
        if (above > 0) atom->f[i][k] -= push(above, velocity, mass);
    }
}

/// What the coupler asks: the step that resolves the shortest contact, m = half a sphere's mass, by 20 steps.
void* Fix@CLASS@::extract(const char* name, int& dimension)
{
    dimension = 0;
    if (std::strcmp(name, interphase::extract_solid_step_limit) != 0 || atom->nlocal == 0) return nullptr;
    double lightest = atom->rmass[0];
    for (int i = 1; i < atom->nlocal; ++i)
        lightest = std::min(lightest, atom->rmass[i]);
    step_limit_ = std::sqrt(0.5 * lightest / stiffness_ * (M_PI * M_PI + log_e_ * log_e_)) / 20;
    return &step_limit_;
}
