// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact_geometry.hpp"

#include "hard_sphere/lanes.hpp"

namespace interphase::hard_sphere {

namespace {

constexpr std::size_t ahead = 4;  // batches
constexpr double tiny = 1e-100;   // no lane may divide by zero: the gas engine may have made that an error

/// What forces added to the relative velocity along the normal.
template <class D>
INTERPHASE_INLINE D gained_along(const Push* push, const int* i, const int* j, const Triple<D>& normal)
{
    constexpr int width = width_of<D>;
    const auto a = load_rows<float, width>([&](int k) __attribute__((always_inline)) { return push[i[k]].change; });
    const auto b = load_rows<float, width>([&](int k) __attribute__((always_inline)) { return push[j[k]].change; });
    const auto gained = [&](int axis) __attribute__((always_inline))
    {
        return __builtin_convertvector(b.r[axis] - a.r[axis], D);
    };
    return dot({gained(0), gained(1), gained(2)}, normal);
}

template <class D>
INTERPHASE_INLINE void start(Body* bodies, ContactBatch& batch, int first, Side<D>& a, Side<D>& b,
                             const Triple<D>& normal)
{
    const Triple<D> last = wide<width_of<D>>(batch.tangential, first);
    const D zero{}, along = dot(last, normal), kept = larger(along, zero);
    const Triple<D> tangential = if_positive(along, last - along * normal, {zero, zero, zero});
    store(batch.impulse + first, kept);
    store(batch.tangential, first, tangential);
    give(bodies, batch, first, a, b, normal, tangential + kept * normal);
}

/// The contacts of a batch from `first` on.
template <int width>
INTERPHASE_INLINE void fill(Bodies& bodies, ContactBatch& batch, BatchNotes& notes, int first, const StepLimits& limits,
                            Overlap*& overlaps)
{
    using D = Doubles<width>;
    using Three = Triple<D>;
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
        return Three{v.r[0], v.r[1], v.r[2]};
    };
    const auto at_i = place(i), at_j = place(j);
    const D radius_i = at_i.r[3], radius_j = at_j.r[3], touching = radius_i + radius_j;
    const Three apart{at_j.r[0] - at_i.r[0], at_j.r[1] - at_i.r[1], at_j.r[2] - at_i.r[2]};
    const Three meeting = velocity(j) - velocity(i);
    const D zero{}, one = zero + 1, step = zero + limits.step;
    const double per_step = 1 / limits.step;
    const D squared = dot(apart, apart), gap = square_root(squared) - touching;

    // when they touch, or are nearest
    const D closing = dot(apart, meeting), beyond = squared - touching * touching;
    const D speed2 = dot(meeting, meeting), discriminant = closing * closing - speed2 * beyond;
    const D size = larger(closing, D(-closing)), root = square_root(larger(discriminant, zero));
    const D when = if_negative(discriminant, size, beyond) / (if_negative(discriminant, speed2, D(root + size)) + tiny);
    // 1 where they touch, else 0
    const D reached = if_negative(D(when - step), if_negative(discriminant, zero, one), zero);
    const D touch = if_negative(closing, if_negative(beyond, one, reached), zero);
    const D time = if_negative(closing, if_negative(beyond, zero, smaller(step, when)), zero);
    const Three then = apart + time * meeting;
    const D distance = square_root(dot(then, then));

    Side<D> a = load<width>(bodies.body.data(), i), b = load<width>(bodies.body.data(), j);
    const D inverse_mass = a.inverse_mass + b.inverse_mass;
    const D both = 1 / ((distance + tiny) * (inverse_mass + tiny));  // one division for two
    const Three normal = D(both * inverse_mass) * then;
    store(batch.normal, first, normal);
    store(batch.mass + first, if_positive(inverse_mass, D(both * distance), zero));

    const D speed = dot(meeting, normal), phase = per_step * time;
    const D open = per_step * (distance - touching) - if_positive(time, speed, zero);
    const D relieving = smaller(zero, D(limits.relief * per_step * (gap + limits.tolerated)));
    store(batch.closing + first, if_negative(gap, relieving, if_positive(touch, D(-speed * phase), open)));

    const D gained = gained_along(bodies.push.data(), i, j, normal);
    const D fast = -(speed + (phase - 0.5) * gained);
    const D pushed = resting_pushes * larger(gained, D(-gained)), slow = larger(D(zero + limits.resting_speed), pushed);
    store(batch.bounce + first, D(touch * if_negative(D(slow - fast), wide<width>(batch.bounce + first), zero)));
    store(notes.touch_time + first, time);

    const D shorter = 0.5 * smaller(gap, zero);
    store(batch.arm_i + first, D(radius_i + shorter));
    store(batch.arm_j + first, D(radius_j + shorter));

    float gaps[width];
    store(gaps, gap);
    for (int k = 0; k < width; ++k) {
        const int lane = first + k;
        *overlaps = {i[k], j[k], {batch.normal[0][lane], batch.normal[1][lane], batch.normal[2][lane]}, gaps[k]};
        overlaps += gaps[k] < 0;
    }

    start(bodies.body.data(), batch, first, a, b, normal);
}

template <int width>
INTERPHASE_INLINE Overlap* fill_all(Bodies& bodies, ContactBatch* batches, BatchNotes* notes, std::size_t count,
                                    const StepLimits& limits, Overlap* overlaps)
{
    for (std::size_t k = 0; k < count; ++k) {
        const ContactBatch& soon = batches[k + ahead < count ? k + ahead : k];
        fetch(bodies.path.data(), soon.i);
        fetch(bodies.path.data(), soon.j);
        fetch(bodies.body.data(), soon.i);
        fetch(bodies.body.data(), soon.j);
        fetch(bodies.push.data(), soon.j);
        for (int first = 0; first < lanes; first += width)
            fill<width>(bodies, batches[k], notes[k], first, limits, overlaps);
    }
    return overlaps;
}

INTERPHASE_WIDEST Overlap* by_eight(Bodies& bodies, ContactBatch* batches, BatchNotes* notes, std::size_t count,
                                    const StepLimits& limits, Overlap* overlaps)
{
    return fill_all<8>(bodies, batches, notes, count, limits, overlaps);
}

INTERPHASE_CLONES Overlap* by_four(Bodies& bodies, ContactBatch* batches, BatchNotes* notes, std::size_t count,
                                   const StepLimits& limits, Overlap* overlaps)
{
    return fill_all<4>(bodies, batches, notes, count, limits, overlaps);
}

}  // namespace

void make_ready(Bodies& bodies, std::vector<ContactBatch>& batches, std::vector<BatchNotes>& notes, std::size_t count,
                const StepLimits& limits, std::vector<Overlap>& overlaps)
{
    const std::size_t before = overlaps.size();
    overlaps.resize(before + lanes * count + 1);  // one is written even where none is
    Overlap* end = (has_widest() ? by_eight : by_four)(bodies, batches.data(), notes.data(), count, limits,
                                                       overlaps.data() + before);
    overlaps.resize(static_cast<std::size_t>(end - overlaps.data()));
}

INTERPHASE_CLONES
void start_from_memory(std::vector<Body>& bodies, std::vector<ContactBatch>& batches, std::size_t count)
{
    constexpr int width = 4;
    for (std::size_t k = 0; k < count; ++k)
        for (int first = 0; first < lanes; first += width) {
            ContactBatch& batch = batches[k];
            auto a = load<width>(bodies.data(), batch.i + first), b = load<width>(bodies.data(), batch.j + first);
            start(bodies.data(), batch, first, a, b, wide<width>(batch.normal, first));
        }
}

}  // namespace interphase::hard_sphere
