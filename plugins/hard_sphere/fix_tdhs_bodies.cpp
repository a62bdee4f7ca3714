// SPDX-License-Identifier: GPL-3.0-or-later
// Between LIGGGHTS's particles and the bodies of the solver.
#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "hard_sphere/fix_tdhs.hpp"

namespace interphase::hard_sphere {

namespace {

constexpr int ahead = 8;  // spheres

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void FixTdhs::gather(double reach)
{
    const int count = atom->nlocal + atom->nghost;
    bodies_.resize(at(count));
    body_of_.resize(at(count));
    shared_.resize(at(count));
    grid_.sort(count > 0 ? atom->x[0] : nullptr, atom->radius, at(count), reach, up_axis_);
    bodies_.coarse.start(grid_.low(), grid_.high());
    constexpr int block = 256;  // what is read twice is still near the processor then
    for (int first = 0; first < count; first += block) {
        const int last = std::min(first + block, count);
        gather(first, last);
        bodies_.write_coarse(at(first), at(last));
    }
}

void FixTdhs::gather(int first, int last)
{
    const double *x = atom->x[0], *v = atom->v[0], *omega = atom->omega[0];
    const std::vector<int>& order = grid_.order();
    for (int b = first; b < last; ++b) {
        const int i = order[at(b)];
        // the engine's order and ours agree roughly only, so the processor cannot know what comes next
        const int soon = 3 * order[std::min(at(b + ahead), order.size() - 1)];
        __builtin_prefetch(x + soon);
        __builtin_prefetch(v + soon);
        __builtin_prefetch(omega + soon);
        __builtin_prefetch(&push_[at(soon)]);

        body_of_[at(i)] = b;
        const double r = atom->radius[i];
        const bool moves = atom->mask[i] & groupbit;
        Path& path = bodies_.path[at(b)];
        set(path.place.centre, to_vector(x + 3 * i));
        path.place.radius = r;
        set(path.velocity, to_vector(v + 3 * i));
        Body& body = bodies_.body[at(b)];
        set(body.velocity, to_vector(v + 3 * i));
        set(body.spin, to_vector(omega + 3 * i));
        body.inverse_mass = moves ? 1 / atom->rmass[i] : 0;
        body.inverse_inertia = 2.5 * body.inverse_mass / (r * r);
        bodies_.label[at(b)] = {atom->tag[i], static_cast<short>(atom->type[i] - 1), i >= atom->nlocal, !moves,
                                memory_.first(i)};
        set(bodies_.push[at(b)].change, to_vector(&push_[at(3 * i)]));
    }
}

void FixTdhs::scatter()
{
    if (has_ghosts()) {
        message_ = Message::shift;
        comm->reverse_comm_fix(this);
    }
    for (int i = 0; i < atom->nlocal; ++i) {
        const auto soon = at(body_of_[at(std::min(i + ahead, atom->nlocal - 1))]);
        __builtin_prefetch(&bodies_.body[soon]);
        __builtin_prefetch(&solver_.shift()[soon]);
        const auto b = at(body_of_[at(i)]);
        set(atom->v[i], to_vector(bodies_.body[b].velocity));
        set(atom->omega[i], to_vector(bodies_.body[b].spin));
        set(&shift_[at(3 * i)], solver_.shift()[b]);
    }
}

}  // namespace interphase::hard_sphere
