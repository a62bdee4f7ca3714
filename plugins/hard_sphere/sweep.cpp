// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/sweep.hpp"

#include "hard_sphere/lanes.hpp"

namespace interphase::hard_sphere {

namespace {

/// For solid spheres, with and without a wall, the effective mass along the plane of contact is 2/7 of that along the
/// normal (Hoomans et al. 1996).
constexpr double tangential_share = 2.0 / 7.0;

/// The contacts of a batch from `first` on.
template <Phase phase, int width, bool rolls>
INTERPHASE_INLINE void resolve(Body* bodies, ContactBatch& batch, RollingBatch* rolling, int first)
{
    using D = Doubles<width>;
    Side<D> a = load<width>(bodies, batch.i + first), b = load<width>(bodies, batch.j + first);
    const Three<D> normal = wide<width>(batch.normal, first);
    const auto [apart, slip] = in_parts(
        surface_velocity(a, b, wide<width>(batch.arm_i + first), wide<width>(batch.arm_j + first), normal), normal);

    const D zero{}, mass = wide<width>(batch.mass + first), closing = wide<width>(batch.closing + first);
    const D old = wide<width>(batch.impulse + first), bounce = wide<width>(batch.bounce + first);
    // An impact acts before the surfaces meet: it stops the approach altogether, if but for it they would cross.
    const D without = normal_impulse(old, mass, apart, closing);
    D along = if_positive(without, if_positive(bounce, D(without + mass * closing), without), zero);
    const Three<D> before = wide<width>(batch.tangential, first);
    Three<D> wanted = before - D(tangential_share * mass) * slip;
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
        const Three<D> returned = kept * before;
        wanted = if_positive(bounce, returned, wanted);
    }

    const D limit = wide<width>(batch.friction + first) * along, size = square_root(dot(wanted, wanted));
    const Three<D> tangential = within_cone(wanted, size, size, limit);
    const Three<D> impulse = tangential - before + D(along - old) * normal;
    store(batch.impulse + first, along);
    store(batch.tangential, first, tangential);
    exchange(batch, first, a, b, normal, impulse);
    if constexpr (rolls) {
        const Three<D> last = wide<width>(rolling->couple, first);
        const Three<D> couple = rolling_couple(a, b, normal, last, D(wide<width>(rolling->arm + first) * along));
        exchange_couple<D>(a, b, couple - last);
        store(rolling->couple, first, couple);
    }
    store(bodies, batch, first, a, b);
}

template <Phase phase, int width, bool rolls>
INTERPHASE_INLINE void each(Body* bodies, Cluster& cluster, Direction direction)
{
    constexpr std::size_t ahead = 4;
    const std::size_t count = cluster.places.count();
    ContactBatch* batches = cluster.batches.data();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t now = direction == Direction::forward ? k : count - 1 - k;
        const std::size_t soon = direction == Direction::forward ? now + ahead : now - ahead;
        if (soon < count) {  // which no number below 0 is
            fetch(bodies, batches[soon].i);
            fetch(bodies, batches[soon].j);
        }
        for (int first = 0; first < lanes; first += width)
            resolve<phase, width, rolls>(bodies, batches[now], rolls ? &cluster.rolling[now] : nullptr, first);
    }
}

template <int width, bool rolls>
INTERPHASE_INLINE void pass(Body* bodies, Cluster& cluster, Direction direction, Phase phase)
{
    switch (phase) {
        case Phase::compression:
            each<Phase::compression, width, rolls>(bodies, cluster, direction);
            break;
        case Phase::release:
            each<Phase::release, width, rolls>(bodies, cluster, direction);
            break;
        case Phase::after_release:
            each<Phase::after_release, width, rolls>(bodies, cluster, direction);
    }
}

template <bool rolls>
INTERPHASE_WIDEST void by_eight(Body* bodies, Cluster& cluster, Direction direction, Phase phase)
{
    pass<8, rolls>(bodies, cluster, direction, phase);
}

template <bool rolls>
INTERPHASE_CLONES void by_four(Body* bodies, Cluster& cluster, Direction direction, Phase phase)
{
    pass<4, rolls>(bodies, cluster, direction, phase);
}

/// The scalar.
template <bool rolls>
void by_one(Body* bodies, Cluster& cluster, Direction direction, Phase phase)
{
    pass<1, rolls>(bodies, cluster, direction, phase);
}

template <bool rolls>
auto of_width(int width)
{
    return width == 8 ? by_eight<rolls> : width == 4 ? by_four<rolls> : by_one<rolls>;
}

}  // namespace

void sweep(std::vector<Body>& bodies, Cluster& cluster, Direction direction, Phase phase, int width)
{
    if (width == 0) width = best_width();
    const auto go = cluster.rolls ? of_width<true>(width) : of_width<false>(width);
    go(bodies.data(), cluster, direction, phase);
}

}  // namespace interphase::hard_sphere
