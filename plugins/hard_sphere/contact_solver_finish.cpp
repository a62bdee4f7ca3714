// SPDX-License-Identifier: GPL-3.0-or-later
// What ContactSolver does once its passes are over.
#include <algorithm>

#include "hard_sphere/contact_solver.hpp"

namespace interphase::hard_sphere {

namespace {

constexpr int ahead = 12;  // overlaps

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

double ContactSolver::separate(const Bodies& bodies, double share, double tolerated)
{
    float deepest = 0;
    for (std::size_t k = 0; k < overlaps_.size(); ++k) {
        const Overlap& overlap = overlaps_[k];
        const Overlap& soon = overlaps_[std::min(k + ahead, overlaps_.size() - 1)];
        __builtin_prefetch(&bodies.body[at(soon.i)]);
        __builtin_prefetch(&bodies.body[at(soon.j)]);
        const Body &a = bodies.body[at(overlap.i)], &b = bodies.body[at(overlap.j)];
        Vector &shift_a = shift_[at(overlap.i)], &shift_b = shift_[at(overlap.j)];
        deepest = std::max(deepest, -overlap.gap);
        const Vector normal = to_vector(overlap.normal);
        const Vector moves = step_ * (to_vector(b.velocity) - to_vector(a.velocity)) + shift_b - shift_a;
        const double left = -tolerated - (overlap.gap + moves.dot(normal));
        if (left <= 0) continue;
        const double push = share * left / (a.inverse_mass + b.inverse_mass);
        shift_a -= push * a.inverse_mass * normal;
        shift_b += push * b.inverse_mass * normal;
    }
    return deepest;
}

void ContactSolver::finish(const Bodies& bodies, const std::vector<int>& particle, ImpulseMemory& memory)
{
    pushes_.assign(bodies.body.size(), 0);
    impacts_.clear();
    memory.forget();
    finish(walls_, particle, memory);
    finish(spheres_, particle, memory);
    for (const BinaryState& kept : binary_states_) {
        memory.add(particle[at(kept.keeper.owner)], Remembered{kept.keeper.partner});
        std::copy_n(kept.state.data(), walls_.state_count, memory.add_more() + (walls_.rolls ? 3 : 0));
    }
    delay_impacts(bodies);
}

void ContactSolver::finish(const Cluster& cluster, const std::vector<int>& particle, ImpulseMemory& memory)
{
    for (std::size_t k = 0; k < cluster.places.count(); ++k) {
        const ContactBatch& batch = cluster.batches[k];
        const BatchNotes& notes = cluster.notes[k];
        for (int lane = 0; lane < lanes; ++lane) {
            if (batch.impulse[lane] <= 0) continue;
            const bool impact = batch.bounce[lane] > 0;
            count_touch(pushes_[at(batch.i[lane])], 1);
            count_touch(pushes_[at(batch.j[lane])], 1);
            if (impact) impacts_.push_back({&batch, lane, notes.touch_time[lane]});
            // the next step finds the two of an impact at rest against each other, but not pressing
            const float sign = impact ? 0.0f : notes.owner[lane] == batch.i[lane] ? 1.0f : -1.0f;
            Remembered entry{notes.partner[lane]};
            for (int axis = 0; axis < 3; ++axis)
                entry.impulse[axis] =
                    sign * (batch.impulse[lane] * batch.normal[axis][lane] + batch.tangential[axis][lane]);
            memory.add(particle[at(notes.owner[lane])], entry);
            if (!cluster.rolls && cluster.state_count == 0) continue;
            float* more = memory.add_more();
            if (cluster.rolls)
                for (int axis = 0; axis < 3; ++axis)
                    *more++ = sign * cluster.rolling[k].couple[axis][lane];
            for (int s = 0; s < cluster.state_count; ++s)
                *more++ = cluster.state(k, s)[lane];
        }
    }
}

namespace {

/// On j.
Vector impulse_of(const ContactBatch& batch, int lane)
{
    Vector impulse;
    for (int axis = 0; axis < 3; ++axis)
        impulse[axis] = batch.impulse[lane] * batch.normal[axis][lane] + batch.tangential[axis][lane];
    return impulse;
}

}  // namespace

std::vector<ContactSolver::WallPush> ContactSolver::wall_pushes() const
{
    std::vector<WallPush> pushes = binary_pushes_;
    for (std::size_t k = 0; k < walls_.places.count(); ++k) {
        const ContactBatch& batch = walls_.batches[k];
        for (int lane = 0; lane < lanes; ++lane) {
            if (batch.impulse[lane] <= 0) continue;
            const Vector normal(batch.normal[0][lane], batch.normal[1][lane], batch.normal[2][lane]);
            pushes.push_back({batch.i[lane], walls_.notes[k].partner[lane],
                              static_cast<double>(batch.arm_i[lane]) * normal, impulse_of(batch, lane)});
        }
    }
    return pushes;
}

void ContactSolver::delay_impacts(const Bodies& bodies)
{
    for (const Impact& impact : impacts_) {
        const ContactBatch& batch = *impact.batch;
        const int lane = impact.lane;
        const Vector impulse = impulse_of(batch, lane);
        const std::size_t i = at(batch.i[lane]), j = at(batch.j[lane]);
        if (pushes_[i] == 1) shift_[i] += impact.touch_time * bodies.body[i].inverse_mass * impulse;
        if (pushes_[j] == 1) shift_[j] -= impact.touch_time * bodies.body[j].inverse_mass * impulse;
    }
}

}  // namespace interphase::hard_sphere
