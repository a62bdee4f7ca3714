// SPDX-License-Identifier: GPL-3.0-or-later
// What fix tdhs keeps of each particle, and what it tells the ranks that hold a particle as a ghost.
#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "contacts/exchange_room.hpp"
#include "hard_sphere/fix_tdhs.hpp"
#include "hard_sphere/messages.hpp"

namespace interphase::hard_sphere {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void FixTdhs::pre_exchange()
{
    room_ = contacts::ask_for_room(*comm, world, atom->nlocal,
                                   [&](int i) { return numbers_in<ShiftMessage> + memory_.numbers(i); });
}

void FixTdhs::grow_arrays(int count)
{
    push_.resize(3 * at(count));
    shift_.resize(3 * at(count));
    memory_.grow(at(count));
}

void FixTdhs::copy_arrays(int from, int to, int)
{
    set(&shift_[at(3 * to)], to_vector(&shift_[at(3 * from)]));
    memory_.copy(from, to);
}

void FixTdhs::set_arrays(int i)
{
    set(&shift_[at(3 * i)], Vector::Zero());
    memory_.forget(i);
}

int FixTdhs::pack_exchange(int i, double* buffer)
{
    ShiftMessage message;
    set(message.shift, to_vector(&shift_[at(3 * i)]));
    const int told = pack(message, buffer);
    // A checkpoint packs between two exchanges, when there may be more contacts than at the last one; LIGGGHTS has
    // `spare` numbers more than it was asked for, for all that packs.
    constexpr int spare = 800;
    int left_out = 0;
    const int remembered = memory_.pack(i, buffer + told, room_ - told + spare, left_out);
    counted_[impulses_left_out] += left_out;
    return told + remembered;
}

int FixTdhs::unpack_exchange(int i, double* buffer)
{
    ShiftMessage message;
    const int read = unpack(message, buffer);
    set(&shift_[at(3 * i)], to_vector(message.shift));
    return read + memory_.unpack(i, buffer + read);
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
    message_ = Message::motion;
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
        set(before.velocity, to_vector(body.velocity));
        set(before.spin, to_vector(body.spin));
    }
    comm->forward_comm_fix(this);
    cost_.switch_to(Part::contacts);
}

PullMessage FixTdhs::pull_of(std::size_t body) const
{
    PullMessage message;
    set(message.impulse, pulls_[body]);
    return message;
}

int FixTdhs::pack_comm(int n, int* list, double* buffer, int, int*)
{
    if (message_ == Message::start)
        return pack_each(n, buffer, [&](int k) {
            const int i = list[k];
            StartMessage message;
            set(message.velocity, to_vector(atom->v[i]));
            set(message.spin, to_vector(atom->omega[i]));
            set(message.push, to_vector(&push_[at(3 * i)]));
            return message;
        });
    if (message_ == Message::sizes)
        return pack_each(n, buffer, [&](int k) { return SizeMessage{atom->radius[list[k]], atom->rmass[list[k]]}; });
    const auto body_of = [&](int k) { return at(body_of_[at(list[k])]); };
    if (message_ == Message::pulls) return pack_each(n, buffer, [&](int k) { return pull_of(body_of(k)); });
    if (message_ == Message::counts)
        return pack_each(n, buffer, [&](int k) { return CountMessage{static_cast<double>((*counts_)[body_of(k)])}; });
    return pack_each(n, buffer, [&](int k) {
        const Body& body = bodies_.body[body_of(k)];
        MotionMessage message;
        set(message.velocity, to_vector(body.velocity));
        set(message.spin, to_vector(body.spin));
        return message;
    });
}

void FixTdhs::unpack_comm(int n, int first, double* buffer)
{
    if (message_ == Message::start)
        return unpack_each<StartMessage>(n, buffer, [&](int k, const StartMessage& message) {
            const int i = first + k;
            set(atom->v[i], to_vector(message.velocity));
            set(atom->omega[i], to_vector(message.spin));
            set(&push_[at(3 * i)], to_vector(message.push));
        });
    if (message_ == Message::sizes)
        return unpack_each<SizeMessage>(n, buffer, [&](int k, const SizeMessage& message) {
            atom->radius[first + k] = message.radius;
            atom->rmass[first + k] = message.mass;
        });
    const auto body_of = [&](int k) { return at(body_of_[at(first + k)]); };
    if (message_ == Message::pulls)
        return unpack_each<PullMessage>(
            n, buffer, [&](int k, const PullMessage& message) { pulls_[body_of(k)] = to_vector(message.impulse); });
    if (message_ == Message::counts)
        return unpack_each<CountMessage>(n, buffer, [&](int k, const CountMessage& message) {
            (*counts_)[body_of(k)] = static_cast<std::uint8_t>(message.count);
        });
    unpack_each<MotionMessage>(n, buffer, [&](int k, const MotionMessage& message) {
        for (Body* body : {&bodies_.body[body_of(k)], &shared_[body_of(k)]}) {
            set(body->velocity, to_vector(message.velocity));
            set(body->spin, to_vector(message.spin));
        }
    });
}

int FixTdhs::pack_reverse_comm(int n, int first, double* buffer)
{
    const auto body_of = [&](int k) { return at(body_of_[at(first + k)]); };
    if (message_ == Message::pulls) return pack_each(n, buffer, [&](int k) { return pull_of(body_of(k)); });
    if (message_ == Message::counts)
        return pack_each(n, buffer, [&](int k) { return CountMessage{static_cast<double>((*counts_)[body_of(k)])}; });
    if (message_ == Message::shift)
        return pack_each(n, buffer, [&](int k) {
            ShiftMessage message;
            set(message.shift, solver_.shift()[body_of(k)]);
            return message;
        });
    return pack_each(n, buffer, [&](int k) {
        const Body &body = bodies_.body[body_of(k)], &before = shared_[body_of(k)];
        MotionMessage message;
        set(message.velocity, to_vector(body.velocity) - to_vector(before.velocity));
        set(message.spin, to_vector(body.spin) - to_vector(before.spin));
        return message;
    });
}

void FixTdhs::unpack_reverse_comm(int n, int* list, double* buffer)
{
    const auto body_of = [&](int k) { return at(body_of_[at(list[k])]); };
    if (message_ == Message::pulls)
        return unpack_each<PullMessage>(
            n, buffer, [&](int k, const PullMessage& message) { pulls_[body_of(k)] += to_vector(message.impulse); });
    if (message_ == Message::counts)
        return unpack_each<CountMessage>(n, buffer, [&](int k, const CountMessage& message) {
            // ranks that share a sphere; of 255 and more, which none will be, the last share its mass too thin
            std::uint8_t& count = (*counts_)[body_of(k)];
            count = static_cast<std::uint8_t>(std::min(count + message.count, 255.0));
        });
    if (message_ == Message::shift)
        return unpack_each<ShiftMessage>(n, buffer, [&](int k, const ShiftMessage& message) {
            solver_.add_shift(body_of(k), to_vector(message.shift));
        });
    unpack_each<MotionMessage>(n, buffer, [&](int k, const MotionMessage& message) {
        Body& body = bodies_.body[body_of(k)];
        set(body.velocity, to_vector(body.velocity) + to_vector(message.velocity));
        set(body.spin, to_vector(body.spin) + to_vector(message.spin));
    });
}

}  // namespace interphase::hard_sphere
