// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact_geometry.hpp"

#include "hard_sphere/lanes.hpp"

namespace interphase::hard_sphere {

namespace {

constexpr std::size_t ahead = 4;  // batches
constexpr double tiny = 1e-100;   // no lane may divide by zero: the gas engine may have made that an error

/// `gained`: what forces added to the relative velocity along the normal.
INTERPHASE_INLINE Doubles gained_along(const Push* push, const ContactBatch& batch, const Triple& normal)
{
    Singles difference[lanes];
    for (int k = 0; k < lanes; ++k) {
        Singles a, b;
        std::memcpy(&a, push[batch.i[k]].change, sizeof a);
        std::memcpy(&b, push[batch.j[k]].change, sizeof b);
        difference[k] = b - a;
    }
    transpose(difference[0], difference[1], difference[2], difference[3]);
    return dot({__builtin_convertvector(difference[0], Doubles), __builtin_convertvector(difference[1], Doubles),
                __builtin_convertvector(difference[2], Doubles)},
               normal);
}

INTERPHASE_INLINE void start(Body* bodies, ContactBatch& batch, Side& a, Side& b, const Triple& normal)
{
    const Triple last = wide(batch.tangential);
    const Doubles zero{}, along = dot(last, normal);
    const Picks pushes = along > zero;
    const Doubles kept = pushes ? along : zero;
    const Triple across = last - along * normal;
    const Triple tangential{pushes ? across.x : zero, pushes ? across.y : zero, pushes ? across.z : zero};
    store(batch.impulse, kept);
    store(batch.tangential, tangential);
    give(bodies, batch, a, b, normal, tangential + kept * normal);
}

INTERPHASE_INLINE void fill(Bodies& bodies, ContactBatch& batch, BatchNotes& notes, const StepLimits& limits,
                            Overlap*& overlaps)
{
    const Path* path = bodies.path.data();
    const auto place = [&](const int(&index)[lanes]) __attribute__((always_inline))
    {
        return load_rows([&](int k) __attribute__((always_inline)) { return path[index[k]].place.centre; });
    };
    const auto velocity = [&](const int(&index)[lanes]) __attribute__((always_inline))
    {
        return load_rows([&](int k) __attribute__((always_inline)) { return path[index[k]].velocity; }).three;
    };
    const Quadruple place_i = place(batch.i), place_j = place(batch.j);
    const Triple apart = place_j.three - place_i.three, meeting = velocity(batch.j) - velocity(batch.i);
    const Doubles zero{}, step = zero + limits.step;
    const double per_step = 1 / limits.step;
    const Doubles touching = place_i.fourth + place_j.fourth;
    const Doubles squared = dot(apart, apart), gap = square_root(squared) - touching;

    // when they touch, or are nearest
    const Doubles closing = dot(apart, meeting), beyond = squared - touching * touching;
    const Doubles speed2 = dot(meeting, meeting), discriminant = closing * closing - speed2 * beyond;
    const Picks approach = closing < zero;
    const Picks overlap = beyond <= zero;
    const Picks hit = discriminant > zero;
    const Doubles size = larger(closing, -closing);
    const Doubles when =
        (hit ? beyond : size) / ((hit ? square_root(larger(discriminant, zero)) + size : speed2) + tiny);
    const Picks touch = approach & (overlap | (hit & (when < step)));
    const Doubles time = approach & ~overlap ? smaller(step, when) : zero;
    const Triple then = apart + time * meeting;
    const Doubles distance = square_root(dot(then, then));

    Side a = load(bodies.body.data(), batch.i), b = load(bodies.body.data(), batch.j);
    const Doubles inverse_mass = a.inverse_mass + b.inverse_mass;
    const Doubles both = 1 / ((distance + tiny) * (inverse_mass + tiny));  // one division for two
    const Triple normal = both * inverse_mass * then;
    store(batch.normal, normal);
    store(batch.mass, inverse_mass > zero ? both * distance : zero);

    const Doubles speed = dot(meeting, normal), phase = per_step * time;
    const Doubles open = per_step * (distance - touching) - (time > zero ? speed : zero);
    const Doubles relieving = smaller(zero, limits.relief * per_step * (gap + limits.tolerated));
    store(batch.closing, gap < zero ? relieving : touch ? -speed * phase : open);

    const Doubles gained = gained_along(bodies.push.data(), batch, normal);
    const Doubles fast = -(speed + (phase - 0.5) * gained);
    const Doubles pushed = resting_pushes * larger(gained, -gained);
    const Picks impact = touch & (fast > larger(zero + limits.resting_speed, pushed));
    store(batch.bounce, impact ? wide(batch.bounce) : zero);
    store(notes.touch_time, time);

    const Doubles shorter = 0.5 * smaller(gap, zero);
    store(batch.arm_i, place_i.fourth + shorter);
    store(batch.arm_j, place_j.fourth + shorter);

    float gaps[lanes];
    store(gaps, gap);
    for (int k = 0; k < lanes; ++k) {
        *overlaps = {batch.i[k], batch.j[k], {batch.normal[0][k], batch.normal[1][k], batch.normal[2][k]}, gaps[k]};
        overlaps += gaps[k] < 0;
    }

    start(bodies.body.data(), batch, a, b, normal);
}

}  // namespace

INTERPHASE_CLONES
void make_ready(Bodies& bodies, std::vector<ContactBatch>& batches, std::vector<BatchNotes>& notes, std::size_t count,
                const StepLimits& limits, std::vector<Overlap>& overlaps)
{
    const std::size_t before = overlaps.size();
    overlaps.resize(before + lanes * (count + 1));
    Overlap* next = overlaps.data() + before;
    for (std::size_t k = 0; k < count; ++k) {
        const ContactBatch& soon = batches[k + ahead < count ? k + ahead : k];
        fetch(bodies.path.data(), soon.i);
        fetch(bodies.path.data(), soon.j);
        fetch(bodies.body.data(), soon.i);
        fetch(bodies.body.data(), soon.j);
        fetch(bodies.push.data(), soon.j);
        fill(bodies, batches[k], notes[k], limits, next);
    }
    overlaps.resize(static_cast<std::size_t>(next - overlaps.data()));
}

INTERPHASE_CLONES
void start_from_memory(std::vector<Body>& bodies, std::vector<ContactBatch>& batches, std::size_t count)
{
    for (std::size_t k = 0; k < count; ++k) {
        Side a = load(bodies.data(), batches[k].i), b = load(bodies.data(), batches[k].j);
        start(bodies.data(), batches[k], a, b, wide(batches[k].normal));
    }
}

}  // namespace interphase::hard_sphere
