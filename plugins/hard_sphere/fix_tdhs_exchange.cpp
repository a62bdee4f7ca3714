// SPDX-License-Identifier: GPL-3.0-or-later
// What fix tdhs keeps of each particle, and what it tells the ranks that hold a particle as a ghost.
#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "hard_sphere/fix_tdhs.hpp"

namespace interphase::hard_sphere {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void FixTdhs::grow_arrays(int count)
{
    push_.resize(3 * at(count));
    shift_.resize(3 * at(count));
    memory_.grow(at(count));
}

void FixTdhs::copy_arrays(int from, int to, int)
{
    std::copy_n(&shift_[at(3 * from)], 3, &shift_[at(3 * to)]);
    memory_.copy(from, to);
}

void FixTdhs::set_arrays(int i)
{
    std::fill_n(&shift_[at(3 * i)], 3, 0.0);
    memory_.forget(i);
}

int FixTdhs::pack_exchange(int i, double* buffer)
{
    std::copy_n(&shift_[at(3 * i)], 3, buffer);
    return 3 + memory_.pack(i, buffer + 3);
}

int FixTdhs::unpack_exchange(int i, double* buffer)
{
    std::copy_n(buffer, 3, &shift_[at(3 * i)]);
    return 3 + memory_.unpack(i, buffer + 3);
}

double FixTdhs::memory_usage()
{
    return static_cast<double>((push_.size() + shift_.size()) * sizeof(double) +
                               bodies_.size() * (sizeof(Body) + sizeof(Path) + sizeof(Label) + sizeof(Push)));
}

void FixTdhs::tell_counts()
{
    cost_.switch_to(Part::communication);
    message_ = Message::counts;
    comm->forward_comm_fix(this);
    cost_.switch_to(Part::contacts);
}

void FixTdhs::split_masses()
{
    cost_.switch_to(Part::communication);
    message_ = Message::counts;
    counts_ = &solver_.count_users(bodies_, pairs_, wall_contacts_);
    comm->reverse_comm_fix(this);
    comm->forward_comm_fix(this);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        shared_[b] = bodies_.body[b];
        const int users = std::max<int>(1, (*counts_)[b]);
        bodies_.body[b].inverse_mass *= users;
        bodies_.body[b].inverse_inertia *= users;
    }
    cost_.switch_to(Part::contacts);
}

void FixTdhs::join_masses()
{
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        bodies_.body[b].inverse_mass = shared_[b].inverse_mass;
        bodies_.body[b].inverse_inertia = shared_[b].inverse_inertia;
    }
}

void FixTdhs::share_changes()
{
    if (!has_ghosts()) return;
    cost_.switch_to(Part::communication);
    message_ = Message::changes;
    comm->reverse_comm_fix(this);
    // a body in parts has the mean velocity of its parts
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_.label[b].ghost) continue;
        const double share = 1.0 / std::max<int>(1, (*counts_)[b]);
        Body &body = bodies_.body[b], &before = shared_[b];
        for (int axis = 0; axis < 3; ++axis) {
            body.velocity[axis] = before.velocity[axis] + share * (body.velocity[axis] - before.velocity[axis]);
            body.spin[axis] = before.spin[axis] + share * (body.spin[axis] - before.spin[axis]);
        }
        copy_three(body.velocity, before.velocity);
        copy_three(body.spin, before.spin);
    }
    comm->forward_comm_fix(this);
    cost_.switch_to(Part::contacts);
}

int FixTdhs::pack_comm(int n, int* list, double* buffer, int, int*)
{
    double* next = buffer;
    for (int k = 0; k < n; ++k) {
        const int i = list[k];
        if (message_ == Message::counts) {
            *next++ = (*counts_)[at(body_of_[at(i)])];
        } else if (message_ == Message::start) {
            next = std::copy_n(atom->v[i], 3, next);
            next = std::copy_n(atom->omega[i], 3, next);
            next = std::copy_n(&push_[at(3 * i)], 3, next);
        } else {
            const Body& body = bodies_.body[at(body_of_[at(i)])];
            next = std::copy_n(body.velocity, 3, next);
            next = std::copy_n(body.spin, 3, next);
        }
    }
    return message_ == Message::counts ? 1 : message_ == Message::start ? 9 : 6;
}

void FixTdhs::unpack_comm(int n, int first, double* buffer)
{
    const double* next = buffer;
    for (int i = first; i < first + n; ++i) {
        if (message_ == Message::counts) {
            (*counts_)[at(body_of_[at(i)])] = static_cast<std::uint8_t>(*next++);
        } else if (message_ == Message::start) {
            std::copy_n(next, 3, atom->v[i]);
            std::copy_n(next + 3, 3, atom->omega[i]);
            std::copy_n(next + 6, 3, &push_[at(3 * i)]);
            next += 9;
        } else {
            const auto b = at(body_of_[at(i)]);
            std::copy_n(next, 3, bodies_.body[b].velocity);
            std::copy_n(next + 3, 3, bodies_.body[b].spin);
            copy_three(next, shared_[b].velocity);
            copy_three(next + 3, shared_[b].spin);
            next += 6;
        }
    }
}

int FixTdhs::pack_reverse_comm(int n, int first, double* buffer)
{
    double* next = buffer;
    for (int i = first; i < first + n; ++i) {
        const auto b = at(body_of_[at(i)]);
        if (message_ == Message::counts) {
            *next++ = (*counts_)[b];
            continue;
        }
        if (message_ == Message::shift) {
            next = std::copy_n(solver_.shift()[b].data(), 3, next);
            continue;
        }
        for (int axis = 0; axis < 3; ++axis)
            *next++ = bodies_.body[b].velocity[axis] - shared_[b].velocity[axis];
        for (int axis = 0; axis < 3; ++axis)
            *next++ = bodies_.body[b].spin[axis] - shared_[b].spin[axis];
    }
    return message_ == Message::counts ? 1 : message_ == Message::shift ? 3 : 6;
}

void FixTdhs::unpack_reverse_comm(int n, int* list, double* buffer)
{
    const double* next = buffer;
    for (int k = 0; k < n; ++k) {
        const auto b = at(body_of_[at(list[k])]);
        if (message_ == Message::counts) {
            // ranks that share a sphere; of 255 and more, which none will be, the last share its mass too thin
            (*counts_)[b] = static_cast<std::uint8_t>(std::min((*counts_)[b] + *next++, 255.0));
            continue;
        }
        if (message_ == Message::shift) {
            solver_.add_shift(b, Vector(next[0], next[1], next[2]));
            next += 3;
            continue;
        }
        for (int axis = 0; axis < 3; ++axis) {
            bodies_.body[b].velocity[axis] += next[axis];
            bodies_.body[b].spin[axis] += next[3 + axis];
        }
        next += 6;
    }
}

}  // namespace interphase::hard_sphere
