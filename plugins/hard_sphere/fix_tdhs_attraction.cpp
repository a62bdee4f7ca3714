// SPDX-License-Identifier: GPL-3.0-or-later
// The attraction of fix tdhs's law: a force over a range, whose impulse of a step is added with that of the other
// forces, before contacts are resolved. These keep apart what touches.
#include "atom.h"
#include "comm.h"
#include "hard_sphere/fix_tdhs.hpp"
#include "hard_sphere/impact.hpp"
#include "hard_sphere/wall_contacts.hpp"
#include "update.h"

namespace interphase::hard_sphere {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void FixTdhs::attract()
{
    if (has_ghosts() && sizes_change_) {
        cost_.switch_to(Part::communication);
        message_ = Message::sizes;
        comm->forward_comm_fix(this);
    }
    attractions_.clear();
    cost_.switch_to(Part::search);
    find_attractions();
    cost_.switch_to(Part::walls);
    find_attractions_of_walls();

    cost_.switch_to(Part::contacts);
    law_->attract(attractions_);
    pulls_.assign(3 * at(atom->nlocal + atom->nghost), 0.0);
    for (const Attraction& pair : attractions_) {
        const Vector impulse = update->dt * pair.force * pair.normal;
        double* of_i = &pulls_[at(3 * pair.i)];
        set(of_i, to_vector(of_i) + impulse);
        if (pair.j < 0) {
            const auto [wall, element] = element_of(pair.j, walls_.all().size());
            walls_.push(wall, element, to_vector(atom->x[pair.i]) + atom->radius[pair.i] * pair.normal, -impulse);
            continue;
        }
        double* of_j = &pulls_[at(3 * pair.j)];
        set(of_j, to_vector(of_j) - impulse);
    }
    if (has_ghosts()) {
        cost_.switch_to(Part::communication);
        message_ = Message::pulls;
        comm->reverse_comm_fix(this);
    }
    cost_.switch_to(Part::integration);
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit)) continue;
        for (int k = 3 * i; k < 3 * i + 3; ++k) {
            const double gained = pulls_[at(k)] / atom->rmass[i];
            atom->v[0][k] += gained;
            push_[at(k)] += gained;
        }
    }
}

/// Of spheres where they are now: the search for pairs that meet, in a step of no time.
void FixTdhs::find_attractions()
{
    gather(range_);
    pairs_.find(bodies_, grid_, 0, range_, range_);
    const std::vector<int>& particle = grid_.order();
    for (const Pair& pair : pairs_) {
        const Label &a = bodies_.label[at(pair.i)], &b = bodies_.label[at(pair.j)];
        if ((a.fixed && b.fixed) || !resolves(a.id, a.ghost, b.id, b.ghost)) continue;
        const Place &from = bodies_.path[at(pair.i)].place, &to = bodies_.path[at(pair.j)].place;
        const Vector apart = to_vector(to.centre) - to_vector(from.centre);
        const double distance = apart.norm(), gap = distance - from.radius - to.radius;
        if (gap >= range_ || distance == 0) continue;
        attractions_.push_back({particle[at(pair.i)], particle[at(pair.j)], law_->materials.between(a.type, b.type),
                                gap, effective_radius(from.radius, to.radius), apart / distance, 0});
    }
}

void FixTdhs::find_attractions_of_walls()
{
    std::vector<walls::WallPoint> points;
    for (std::size_t w = 0; w < walls_.all().size(); ++w) {
        const walls::Wall& wall = *walls_.all()[w];
        for (int i = 0; i < atom->nlocal; ++i) {
            if (!(atom->mask[i] & groupbit)) continue;
            Place place;
            set(place.centre, to_vector(atom->x[i]));
            place.radius = atom->radius[i];
            if (!wall.may_touch(place, range_)) continue;
            points.clear();
            wall.near(place, range_, points);
            for (const walls::WallPoint& point : points)
                attractions_.push_back({i, wall_key(w, point.element, walls_.all().size()),
                                        law_->materials.between(atom->type[i] - 1, wall.type()), point.gap,
                                        place.radius, point.normal, 0});
        }
    }
}

}  // namespace interphase::hard_sphere
