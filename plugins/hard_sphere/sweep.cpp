// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/sweep.hpp"

#include "hard_sphere/lanes.hpp"

namespace interphase::hard_sphere {

namespace {

/// min(1, limit/size), size given by its square.
INTERPHASE_INLINE Doubles cone(const Doubles& limit, const Doubles& squared)
{
    constexpr double tiny = 1e-200;  // no lane may divide by zero
    return limit / (larger(square_root(squared), limit) + tiny);
}

/// For solid spheres, with and without a wall, the effective mass along the plane of contact is 2/7 of that along the
/// normal (Hoomans et al. 1996).
constexpr double tangential_share = 2.0 / 7.0;

template <Phase phase>
INTERPHASE_INLINE void resolve(Body* bodies, ContactBatch& batch)
{
    Side a = load(bodies, batch.i), b = load(bodies, batch.j);
    const Triple normal = wide(batch.normal);
    Triple slip = b.velocity - a.velocity - cross(wide(batch.arm_i) * a.spin + wide(batch.arm_j) * b.spin, normal);
    const Doubles apart = dot(slip, normal);
    slip = slip - apart * normal;

    const Doubles zero{}, mass = wide(batch.mass), closing = wide(batch.closing), old = wide(batch.impulse);
    const Doubles bounce = wide(batch.bounce);
    const Picks impact = bounce > zero;
    // What keeps the surfaces from crossing. An impact acts before they meet: it stops the approach altogether, if but
    // for it they would cross.
    const Doubles without = old - mass * (apart + closing);
    Doubles along = without > zero ? (impact ? without + mass * closing : without) : zero;
    const Triple before = wide(batch.tangential);
    Triple wanted = before - tangential_share * mass * slip;
    if (phase != Phase::compression) {
        Doubles least;
        Doubles kept = 1 + zero;
        if (phase == Phase::release) {
            least = old * bounce;
            store(batch.least, least);
            kept = wide(batch.tangential_bounce);
        } else {
            least = wide(batch.least);
        }
        along = larger(along, least);
        wanted = {impact ? kept * before.x : wanted.x, impact ? kept * before.y : wanted.y,
                  impact ? kept * before.z : wanted.z};
    }

    const Triple tangential = cone(wide(batch.friction) * along, dot(wanted, wanted)) * wanted;
    store(batch.impulse, along);
    store(batch.tangential, tangential);
    give(bodies, batch, a, b, normal, tangential - before + (along - old) * normal);
}

template <Phase phase>
INTERPHASE_INLINE void each(Body* bodies, ContactBatch* batches, std::size_t count, Direction direction)
{
    constexpr std::size_t ahead = 4;
    const auto prepare = [&](std::size_t k) __attribute__((always_inline))
    {
        if (k >= count) return;  // also below 0
        fetch(bodies, batches[k].i);
        fetch(bodies, batches[k].j);
    };
    if (direction == Direction::forward)
        for (std::size_t k = 0; k < count; ++k) {
            prepare(k + ahead);
            resolve<phase>(bodies, batches[k]);
        }
    else
        for (std::size_t k = count; k-- > 0;) {
            prepare(k - ahead);
            resolve<phase>(bodies, batches[k]);
        }
}

}  // namespace

INTERPHASE_CLONES
void sweep(std::vector<Body>& bodies, std::vector<ContactBatch>& batches, std::size_t count, Direction direction,
           Phase phase)
{
    switch (phase) {
        case Phase::compression:
            each<Phase::compression>(bodies.data(), batches.data(), count, direction);
            break;
        case Phase::release:
            each<Phase::release>(bodies.data(), batches.data(), count, direction);
            break;
        case Phase::after_release:
            each<Phase::after_release>(bodies.data(), batches.data(), count, direction);
    }
}

}  // namespace interphase::hard_sphere
