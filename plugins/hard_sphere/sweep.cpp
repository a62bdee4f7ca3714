// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/sweep.hpp"

#include "hard_sphere/lanes.hpp"

namespace interphase::hard_sphere {

namespace {

/// min(1, limit/size), size given by its square.
template <class D>
INTERPHASE_INLINE D cone(const D& limit, const D& squared)
{
    constexpr double tiny = 1e-200;  // no lane may divide by zero
    return limit / (larger(square_root(squared), limit) + tiny);
}

/// For solid spheres, with and without a wall, the effective mass along the plane of contact is 2/7 of that along the
/// normal (Hoomans et al. 1996).
constexpr double tangential_share = 2.0 / 7.0;

/// The contacts of a batch from `first` on.
template <Phase phase, int width>
INTERPHASE_INLINE void resolve(Body* bodies, ContactBatch& batch, int first)
{
    using D = Doubles<width>;
    using Three = Triple<D>;
    Side<D> a = load<width>(bodies, batch.i + first), b = load<width>(bodies, batch.j + first);
    const Three normal = wide<width>(batch.normal, first);
    const Three turning = wide<width>(batch.arm_i + first) * a.spin + wide<width>(batch.arm_j + first) * b.spin;
    Three slip = b.velocity - a.velocity - cross(turning, normal);
    const D apart = dot(slip, normal);
    slip = slip - apart * normal;

    const D zero{}, mass = wide<width>(batch.mass + first), closing = wide<width>(batch.closing + first);
    const D old = wide<width>(batch.impulse + first), bounce = wide<width>(batch.bounce + first);
    // What keeps the surfaces from crossing. An impact acts before they meet: it stops the approach altogether, if but
    // for it they would cross.
    const D without = old - mass * (apart + closing);
    D along = if_positive(without, if_positive(bounce, D(without + mass * closing), without), zero);
    const Three before = wide<width>(batch.tangential, first);
    Three wanted = before - D(tangential_share * mass) * slip;
    if constexpr (phase != Phase::compression) {
        D least, kept = 1 + zero;
        if constexpr (phase == Phase::release) {
            least = old * bounce;
            store(batch.least + first, least);
            kept = wide<width>(batch.tangential_bounce + first);
        } else {
            least = wide<width>(batch.least + first);
        }
        along = larger(along, least);
        wanted = if_positive(bounce, kept * before, wanted);
    }

    const D limit = wide<width>(batch.friction + first) * along;
    const Three tangential = cone(limit, dot(wanted, wanted)) * wanted;
    store(batch.impulse + first, along);
    store(batch.tangential, first, tangential);
    give(bodies, batch, first, a, b, normal, tangential - before + D(along - old) * normal);
}

template <Phase phase, int width>
INTERPHASE_INLINE void each(Body* bodies, ContactBatch* batches, std::size_t count, Direction direction)
{
    constexpr std::size_t ahead = 4;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t now = direction == Direction::forward ? k : count - 1 - k;
        const std::size_t soon = direction == Direction::forward ? now + ahead : now - ahead;
        if (soon < count) {  // which no number below 0 is
            fetch(bodies, batches[soon].i);
            fetch(bodies, batches[soon].j);
        }
        for (int first = 0; first < lanes; first += width)
            resolve<phase, width>(bodies, batches[now], first);
    }
}

template <int width>
INTERPHASE_INLINE void pass(Body* bodies, ContactBatch* batches, std::size_t count, Direction direction, Phase phase)
{
    switch (phase) {
        case Phase::compression:
            each<Phase::compression, width>(bodies, batches, count, direction);
            break;
        case Phase::release:
            each<Phase::release, width>(bodies, batches, count, direction);
            break;
        case Phase::after_release:
            each<Phase::after_release, width>(bodies, batches, count, direction);
    }
}

INTERPHASE_WIDEST void by_eight(Body* bodies, ContactBatch* batches, std::size_t count, Direction direction,
                                Phase phase)
{
    pass<8>(bodies, batches, count, direction, phase);
}

INTERPHASE_CLONES void by_four(Body* bodies, ContactBatch* batches, std::size_t count, Direction direction, Phase phase)
{
    pass<4>(bodies, batches, count, direction, phase);
}

}  // namespace

void sweep(std::vector<Body>& bodies, std::vector<ContactBatch>& batches, std::size_t count, Direction direction,
           Phase phase)
{
    (has_widest() ? by_eight : by_four)(bodies.data(), batches.data(), count, direction, phase);
}

}  // namespace interphase::hard_sphere
