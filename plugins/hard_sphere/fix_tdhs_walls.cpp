// SPDX-License-Identifier: GPL-3.0-or-later
// The walls that fix tdhs heeds: which, where they are, and what spheres do to them.
#include <string>

#include "atom.h"
#include "hard_sphere/fix_tdhs.hpp"
#include "hard_sphere/wall_contacts.hpp"

namespace interphase::hard_sphere {

void FixTdhs::collect_walls()
{
    walls_.collect(*modify, style);
    if (!walls_.are_of_types(atom->ntypes)) complain("a wall has a type that the simulation box does not know");
}

void FixTdhs::follow_walls()
{
    if (!walls_.any_travels()) return;
    walls_.travel(limits_.step);  // through the last part of the step
    const double off = walls_.follow(), most = walls::most_way_of_walls * smallest_radius_;
    if (off > most)
        complain(
            "a wall is " + std::to_string(off) +
            " m from where its last velocity would have brought it in a step, more than half the radius of a sphere, " +
            std::to_string(most) +
            " m, and may have passed through one. LIGGGHTS tells how fast a mesh moves once it has moved: give a "
            "shorter step, or let the mesh set out slowly");
}

void FixTdhs::tell_walls()
{
    if (!walls_.any_sums_forces()) return;
    for (const ContactSolver::WallPush& push : solver_.wall_pushes()) {
        const auto [wall, element] = element_of(push.key, walls_.all().size());
        const Vector centre = to_vector(bodies_.path[static_cast<std::size_t>(push.body)].place.centre);
        walls_.push(wall, element, centre + push.point, push.impulse);
    }
}

}  // namespace interphase::hard_sphere
