// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact_geometry.hpp"

#include <algorithm>

#include "hard_sphere/lanes.hpp"

namespace interphase::hard_sphere {

namespace {

constexpr std::size_t ahead = 4;  // batches

/// What forces added to the relative velocity along the normal.
template <class D>
INTERPHASE_INLINE D gained_along(const Push* push, const int* i, const int* j, const Three<D>& normal)
{
    constexpr int width = width_of<D>;
    const auto a = load_rows<float, width>([&](int k) __attribute__((always_inline)) { return push[i[k]].change; });
    const auto b = load_rows<float, width>([&](int k) __attribute__((always_inline)) { return push[j[k]].change; });
    const auto gained = [&](int axis) __attribute__((always_inline))
    {
        if constexpr (width == 1)
            return static_cast<double>(b.r[axis] - a.r[axis]);
        else
            return __builtin_convertvector(b.r[axis] - a.r[axis], D);
    };
    return dot(Three<D>{gained(0), gained(1), gained(2)}, normal);
}

/// `rolling`: of the batch, where the law resists rolling.
template <bool rolls, class D>
INTERPHASE_INLINE void start(Body* bodies, ContactBatch& batch, RollingBatch* rolling, int first, Side<D>& a,
                             Side<D>& b, const Three<D>& normal)
{
    const Three<D> last = wide<width_of<D>>(batch.tangential, first);
    const D zero{}, along = dot(last, normal), kept = larger(along, zero);
    const Three<D> across = last - along * normal, nothing{zero, zero, zero};
    const Three<D> tangential = if_positive(along, across, nothing), impulse = tangential + kept * normal;
    store(batch.impulse + first, kept);
    store(batch.tangential, first, tangential);
    exchange(batch, first, a, b, normal, impulse);
    if constexpr (rolls) {
        const Three<D> before = wide<width_of<D>>(rolling->couple, first);
        const Three<D> across_now = before - dot(before, normal) * normal;
        const Three<D> couple = if_positive(along, across_now, nothing);
        exchange_couple<D>(a, b, couple);
        store(rolling->couple, first, couple);
    }
    store(bodies, batch, first, a, b);
}

/// The contacts of a batch from `first` on.
template <int width, bool rolls>
INTERPHASE_INLINE void fill(Bodies& bodies, ContactBatch& batch, BatchNotes& notes, RollingBatch* rolling, int first,
                            const StepLimits& limits, Overlap*& overlaps)
{
    using D = Doubles<width>;
    const int *i = batch.i + first, *j = batch.j + first;
    const Path* path = bodies.path.data();
    const auto place = [&](const int* index) __attribute__((always_inline))
    {
        return load_rows<double, width>([&](int k)
                                            __attribute__((always_inline)) { return path[index[k]].place.centre; });
    };
    const auto velocity = [&](const int* index) __attribute__((always_inline))
    {
        const auto v =
            load_rows<double, width>([&](int k) __attribute__((always_inline)) { return path[index[k]].velocity; });
        return Three<D>{v.r[0], v.r[1], v.r[2]};
    };
    const auto at_i = place(i), at_j = place(j);
    const D radius_i = at_i.r[3], radius_j = at_j.r[3], touching = radius_i + radius_j, zero{};
    const Three<D> apart{at_j.r[0] - at_i.r[0], at_j.r[1] - at_i.r[1], at_j.r[2] - at_i.r[2]};
    const Three<D> meeting = velocity(j) - velocity(i);
    const Divisor<D> step(limits.step);
    const Encounter<D> met = encounter(apart, meeting, touching, limits.step);

    Side<D> a = load<width>(bodies.body.data(), i), b = load<width>(bodies.body.data(), j);
    const D inverse_mass = a.inverse_mass + b.inverse_mass;
    const D both = 1 / ((met.distance + tiny) * (inverse_mass + tiny));  // one division for two
    const Three<D> normal = D(both * inverse_mass) * met.apart;
    store(batch.normal, first, normal);
    store(batch.mass + first, if_positive(inverse_mass, D(both * met.distance), zero));

    const D speed = dot(meeting, normal);
    store(batch.closing + first, closing_speed(met, touching, speed, step, limits));

    const D gained = gained_along<D>(bodies.push.data(), i, j, normal);
    const Approach<D> fast = approach(met.time, speed, gained, step, limits);
    const D bounces = if_negative(D(fast.least - fast.speed), wide<width>(notes.speed + first), zero);
    store(notes.speed + first, D(met.touch * bounces * fast.speed));
    store(notes.touch_time + first, met.time);

    const D shorter = 0.5 * smaller(met.gap, zero);
    store(batch.arm_i + first, D(radius_i + shorter));
    store(batch.arm_j + first, D(radius_j + shorter));

    float gaps[width];
    store(gaps, met.gap);
    for (int k = 0; k < width; ++k) {
        const int lane = first + k;
        *overlaps = {i[k], j[k], {batch.normal[0][lane], batch.normal[1][lane], batch.normal[2][lane]}, gaps[k]};
        overlaps += gaps[k] < 0;
    }

    start<rolls>(bodies.body.data(), batch, rolling, first, a, b, normal);
}

/// Batches [first, last) of a cluster.
struct Range {
    Cluster& cluster;
    std::size_t first, last;
};

template <int width, bool rolls>
INTERPHASE_INLINE Overlap* fill_all(Bodies& bodies, const Range& range, const StepLimits& limits, Overlap* overlaps)
{
    std::vector<ContactBatch>& batches = range.cluster.batches;
    const std::size_t count = range.cluster.places.count();
    for (std::size_t k = range.first; k < range.last; ++k) {
        const ContactBatch& soon = batches[k + ahead < count ? k + ahead : k];
        fetch(bodies.path.data(), soon.i);
        fetch(bodies.path.data(), soon.j);
        fetch(bodies.body.data(), soon.i);
        fetch(bodies.body.data(), soon.j);
        fetch(bodies.push.data(), soon.j);
        RollingBatch* rolling = rolls ? &range.cluster.rolling[k] : nullptr;
        for (int first = 0; first < lanes; first += width)
            fill<width, rolls>(bodies, batches[k], range.cluster.notes[k], rolling, first, limits, overlaps);
    }
    return overlaps;
}

template <bool rolls>
INTERPHASE_WIDEST Overlap* by_eight(Bodies& bodies, const Range& range, const StepLimits& limits, Overlap* overlaps)
{
    return fill_all<8, rolls>(bodies, range, limits, overlaps);
}

template <bool rolls>
INTERPHASE_CLONES Overlap* by_four(Bodies& bodies, const Range& range, const StepLimits& limits, Overlap* overlaps)
{
    return fill_all<4, rolls>(bodies, range, limits, overlaps);
}

/// The scalar.
template <bool rolls>
Overlap* by_one(Bodies& bodies, const Range& range, const StepLimits& limits, Overlap* overlaps)
{
    return fill_all<1, rolls>(bodies, range, limits, overlaps);
}

template <bool rolls>
auto of_width(int width)
{
    return width == 8 ? by_eight<rolls> : width == 4 ? by_four<rolls> : by_one<rolls>;
}

template <bool rolls>
INTERPHASE_CLONES void start_all(Body* bodies, Cluster& cluster)
{
    constexpr int width = 4;
    for (std::size_t k = 0; k < cluster.places.count(); ++k)
        for (int first = 0; first < lanes; first += width) {
            ContactBatch& batch = cluster.batches[k];
            auto a = load<width>(bodies, batch.i + first), b = load<width>(bodies, batch.j + first);
            start<rolls>(bodies, batch, rolls ? &cluster.rolling[k] : nullptr, first, a, b,
                         wide<width>(batch.normal, first));
        }
}

}  // namespace

void make_ready(Bodies& bodies, Cluster& cluster, const AnyLaw& law, const StepLimits& limits,
                std::vector<Overlap>& overlaps, int width)
{
    if (width == 0) width = best_width();
    const auto fill = cluster.rolls ? of_width<true>(width) : of_width<false>(width);
    const std::size_t count = cluster.places.count();
    constexpr std::size_t at_a_time = 32;  // the law finds them still near the processor
    for (std::size_t first = 0; first < count; first += at_a_time) {
        const std::size_t last = std::min(first + at_a_time, count), before = overlaps.size();
        overlaps.resize(before + lanes * (last - first) + 1);  // one is written even where none is
        Overlap* end = fill(bodies, {cluster, first, last}, limits, overlaps.data() + before);
        overlaps.resize(static_cast<std::size_t>(end - overlaps.data()));
        law.respond(cluster, first, last, limits.step, width);
    }
}

void start_from_memory(std::vector<Body>& bodies, Cluster& cluster)
{
    const auto go = cluster.rolls ? start_all<true> : start_all<false>;
    go(bodies.data(), cluster);
}

}  // namespace interphase::hard_sphere
