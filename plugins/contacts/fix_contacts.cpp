// SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/fix_contacts.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

namespace interphase::contacts {

FixContacts::FixContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, const char* wall_style)
    : Fix(lmp, narg, arg), wall_style_(wall_style), reach_(*lmp, 2)
{
    if (!atom->sphere_flag) complain("the particles are no spheres; use atom_style granular");
    comm_forward = 2;
    force_reneighbor = 1;
    next_reneighbor = -1;
}

int FixContacts::setmask()
{
    using namespace LAMMPS_NS::FixConst;
    return PRE_NEIGHBOR | POST_FORCE;
}

void FixContacts::setup(int vflag)
{
    collect_walls();
    in_setup_ = true;
    post_force(vflag);
    in_setup_ = false;
}

void FixContacts::begin_step()
{
    if (sizes_change(*lmp)) comm->forward_comm_fix(this);
    walls_.follow();
    contact_.step = in_setup_ ? 0 : update->dt;
    double largest = 0;
    const int count = atom->nlocal + atom->nghost;
    for (int i = 0; i < count; ++i) {
        largest = std::max(largest, atom->radius[i]);
        if (!to_vector(atom->x[i]).allFinite())
            complain_alone("sphere " + std::to_string(atom->tag[i]) + " is at " + text(to_vector(atom->x[i])) +
                           " m. Give a shorter step, or find the force that no number describes");
    }
    // Sorted in every step, so that nothing is assumed of who is where and how large since the last one.
    cells_.sort(atom->x, count, 2 * largest);
}

void FixContacts::end_step(int longest)
{
    double sizes[] = {0, static_cast<double>(longest)};
    for (int i = 0; i < atom->nlocal; ++i)
        sizes[0] = std::max(sizes[0], atom->radius[i]);
    MPI_Allreduce(MPI_IN_PLACE, sizes, 2, MPI_DOUBLE, MPI_MAX, world);
    longest_ = static_cast<int>(sizes[1]);
    if (sizes[0] > reach_.largest_radius()) next_reneighbor = update->ntimestep + 1;
}

int FixContacts::pack_comm(int n, int* list, double* buffer, int, int*)
{
    for (int k = 0; k < n; ++k) {
        buffer[2 * k] = atom->radius[list[k]];
        buffer[2 * k + 1] = atom->rmass[list[k]];
    }
    return 2;
}

void FixContacts::unpack_comm(int n, int first, double* buffer)
{
    for (int k = 0; k < n; ++k) {
        atom->radius[first + k] = buffer[2 * k];
        atom->rmass[first + k] = buffer[2 * k + 1];
    }
}

/// Sets contact_ and arm_ of two spheres that overlap. All of it changes its sign, and nothing else, as i and j change
/// places.
void FixContacts::touch(int i, int j)
{
    const Vector apart = to_vector(atom->x[i]) - to_vector(atom->x[j]);
    const double radius = atom->radius[i], other_radius = atom->radius[j], reach = radius + other_radius;
    const double distance = apart.norm();
    if (distance == 0)
        complain_alone("spheres " + std::to_string(atom->tag[i]) + " and " + std::to_string(atom->tag[j]) +
                       " have the same centre, so no force knows which way to part them. Take one of them away");
    const double overlap = reach - distance, mass = atom->rmass[i], other_mass = atom->rmass[j];
    arm_ = radius - 0.5 * overlap;
    const Vector normal = apart / distance, spin = to_vector(atom->omega[i]), other_spin = to_vector(atom->omega[j]);
    const Vector rolling = arm_ * spin + (other_radius - 0.5 * overlap) * other_spin;
    contact_.normal = normal;
    contact_.overlap = overlap;
    contact_.velocity = to_vector(atom->v[i]) - to_vector(atom->v[j]) - rolling.cross(normal);
    contact_.spin = spin - other_spin;
    contact_.mass = mass * other_mass / (mass + other_mass);
    contact_.radius = radius * other_radius / reach;
    contact_.type = atom->type[i] - 1;
    contact_.other_type = atom->type[j] - 1;
}

void FixContacts::find_wall_points(int i, const walls::Wall& wall)
{
    points_.clear();
    walls::Place sphere;
    set(sphere.centre, to_vector(atom->x[i]));
    sphere.radius = atom->radius[i];
    if (wall.may_touch(sphere, 0)) wall.near(sphere, 0, points_);
}

void FixContacts::touch_wall(int i, const walls::WallPoint& point, int type)
{
    const Vector spin = to_vector(atom->omega[i]);
    arm_ = atom->radius[i] + point.gap;
    contact_.normal = -point.normal;
    contact_.overlap = -point.gap;
    contact_.velocity = to_vector(atom->v[i]) - point.velocity - arm_ * spin.cross(contact_.normal);
    contact_.spin = spin;
    contact_.mass = atom->rmass[i];
    contact_.radius = atom->radius[i];
    contact_.type = atom->type[i] - 1;
    contact_.other_type = type;
}

void FixContacts::push(int i, Partner partner, const Push& push)
{
    if (!push.force.allFinite() || !push.moment.allFinite())
        complain_alone("the law answers a force of " + text(push.force) + " N and a moment of " + text(push.moment) +
                       " N m on sphere " + std::to_string(atom->tag[i]) + ", at an overlap of " +
                       text(contact_.overlap) + " m with " +
                       (partner > 0 ? "sphere " + std::to_string(partner) : "a wall") + " and a velocity of " +
                       text(contact_.velocity) + " m/s there. Look for a division by 0 in it, or for a step too long");
    const Vector torque = push.moment - arm_ * contact_.normal.cross(push.force);
    for (int k = 0; k < 3; ++k) {
        atom->f[i][k] += push.force[k];
        atom->torque[i][k] += torque[k];
    }
}

void FixContacts::tell_wall(int i, std::size_t wall, int element, const Push& push) const
{
    if (in_setup_) return;  // of no step
    walls_.push(wall, element, to_vector(atom->x[i]) - arm_ * contact_.normal, -update->dt * push.force);
}

}  // namespace interphase::contacts
