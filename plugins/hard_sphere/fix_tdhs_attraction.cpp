// SPDX-License-Identifier: GPL-3.0-or-later
// The attraction of fix tdhs's law: a force over a range, whose impulse of a step is added with that of the other
// forces, before contacts are resolved. These keep apart what touches.
#include <mpi.h>

#include <cmath>

#include "atom.h"
#include "comm.h"
#include "hard_sphere/fix_tdhs.hpp"
#include "hard_sphere/impact.hpp"
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
        if (pair.j < 0) continue;
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

void FixTdhs::find_attractions()
{
    const int count = atom->nlocal + atom->nghost;
    if (count == 0) return;
    grid_.sort(atom->x[0], atom->radius, at(count), range_, up_axis_);
    const int* order = grid_.order().data();
    const auto look = [&](int i, int j) {
        const double reach = atom->radius[i] + atom->radius[j] + range_;
        const Vector apart = to_vector(atom->x[j]) - to_vector(atom->x[i]);
        const double squared = apart.squaredNorm();
        if (squared >= reach * reach || squared == 0) return;
        if (!((atom->mask[i] | atom->mask[j]) & groupbit)) return;
        if (!resolves(atom->tag[i], i >= atom->nlocal, atom->tag[j], j >= atom->nlocal)) return;
        const double distance = std::sqrt(squared);
        attractions_.push_back({i, j, law_->materials.between(atom->type[i] - 1, atom->type[j] - 1),
                                distance - atom->radius[i] - atom->radius[j],
                                effective_radius(atom->radius[i], atom->radius[j]), apart / distance, 0});
    };
    grid_.candidates([&](int i, CellGrid::Range a, CellGrid::Range b) {
        for (const CellGrid::Range& range : {a, b})
            for (int j = range.first; j < range.last; ++j)
                look(order[i], order[j]);
    });
}

void FixTdhs::find_attractions_of_walls()
{
    std::vector<walls::WallPoint> points;
    for (const auto& wall : walls_)
        for (int i = 0; i < atom->nlocal; ++i) {
            if (!(atom->mask[i] & groupbit)) continue;
            Place place;
            set(place.centre, to_vector(atom->x[i]));
            place.radius = atom->radius[i];
            if (!wall->may_touch(place, range_)) continue;
            points.clear();
            wall->near(place, range_, points);
            for (const walls::WallPoint& point : points)
                attractions_.push_back({i, -1, law_->materials.between(atom->type[i] - 1, wall->type()), point.gap,
                                        place.radius, point.normal, 0});
        }
}

}  // namespace interphase::hard_sphere
