// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <cstring>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/contact_batch.hpp"
#include "hard_sphere/impact.hpp"
#include "hard_sphere/lane_numbers.hpp"
#include "hard_sphere/processor.hpp"

/// Contacts of a batch, 1, 4 or 8 of them at once (lane_numbers.hpp), from the batch and the bodies and back.
namespace interphase::hard_sphere {

template <int width>
INTERPHASE_INLINE Doubles<width> wide(const float* narrow)
{
    if constexpr (width == 1) {
        return *narrow;
    } else {
        Doubles<width> values;  // one by one: the compiler (gcc 12) converts a whole vector in halves
        for (int k = 0; k < width; ++k)
            values[k] = narrow[k];
        return values;
    }
}

template <int width>
INTERPHASE_INLINE Three<Doubles<width>> wide(const float (&narrow)[3][lanes], int first)
{
    return {wide<width>(narrow[0] + first), wide<width>(narrow[1] + first), wide<width>(narrow[2] + first)};
}

template <class D>
INTERPHASE_INLINE void store(float* narrow, const D& values)
{
    const auto rounded = __builtin_convertvector(values, Singles<width_of<D>>);
    std::memcpy(narrow, &rounded, sizeof rounded);
}

INTERPHASE_INLINE void store(float* narrow, double value) { *narrow = static_cast<float>(value); }

INTERPHASE_INLINE void store(float (&narrow)[3][lanes], int first, const Vector& values)
{
    for (int axis = 0; axis < 3; ++axis)
        store(narrow[axis] + first, values[axis]);
}

template <class D>
INTERPHASE_INLINE void store(float (&narrow)[3][lanes], int first, const Triple<D>& values)
{
    store(narrow[0] + first, values.x);
    store(narrow[1] + first, values.y);
    store(narrow[2] + first, values.z);
}

/// Of each four numbers of the vectors.
template <class V>
INTERPHASE_INLINE void transpose(V& a, V& b, V& c, V& d)
{
    using Order = decltype(a < b);
    if constexpr (sizeof(V) == 4 * sizeof(a[0])) {
        const V ab_low = __builtin_shuffle(a, b, Order{0, 4, 2, 6}),
                ab_high = __builtin_shuffle(a, b, Order{1, 5, 3, 7});
        const V cd_low = __builtin_shuffle(c, d, Order{0, 4, 2, 6}),
                cd_high = __builtin_shuffle(c, d, Order{1, 5, 3, 7});
        a = __builtin_shuffle(ab_low, cd_low, Order{0, 1, 4, 5});
        b = __builtin_shuffle(ab_high, cd_high, Order{0, 1, 4, 5});
        c = __builtin_shuffle(ab_low, cd_low, Order{2, 3, 6, 7});
        d = __builtin_shuffle(ab_high, cd_high, Order{2, 3, 6, 7});
    } else {
        constexpr Order low{0, 8, 2, 10, 4, 12, 6, 14}, high{1, 9, 3, 11, 5, 13, 7, 15};
        constexpr Order front{0, 1, 8, 9, 4, 5, 12, 13}, back{2, 3, 10, 11, 6, 7, 14, 15};
        const V ab_low = __builtin_shuffle(a, b, low), ab_high = __builtin_shuffle(a, b, high);
        const V cd_low = __builtin_shuffle(c, d, low), cd_high = __builtin_shuffle(c, d, high);
        a = __builtin_shuffle(ab_low, cd_low, front);
        b = __builtin_shuffle(ab_high, cd_high, front);
        c = __builtin_shuffle(ab_low, cd_low, back);
        d = __builtin_shuffle(ab_high, cd_high, back);
    }
}

/// Four numbers of each contact, `row(k)` pointing to those of contact k, as vectors over the contacts.
template <class Number, int width, class Row>
INTERPHASE_INLINE auto load_rows(const Row& row)
{
    if constexpr (width == 1) {
        struct {
            Number r[4];
        } rows;
        std::memcpy(rows.r, row(0), sizeof rows.r);
        return rows;
    } else {
        typedef Number Four __attribute__((vector_size(4 * sizeof(Number))));
        typedef Number All __attribute__((vector_size(width * sizeof(Number))));
        struct {
            All r[4];
        } rows;
        for (int k = 0; k < 4; ++k) {
            Four low;
            std::memcpy(&low, row(k), sizeof low);
            if constexpr (width == 4) {
                rows.r[k] = low;
            } else {
                Four high;
                std::memcpy(&high, row(k + 4), sizeof high);
                rows.r[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
            }
        }
        transpose(rows.r[0], rows.r[1], rows.r[2], rows.r[3]);
        return rows;
    }
}

/// The reverse.
template <class D, class Row>
INTERPHASE_INLINE void store_rows(const Three<D>& three, const D& fourth, const Row& row)
{
    if constexpr (width_of<D> == 1) {
        const double r[4] = {three[0], three[1], three[2], fourth};
        std::memcpy(row(0), r, sizeof r);
    } else {
        D r[4] = {three.x, three.y, three.z, fourth};
        transpose(r[0], r[1], r[2], r[3]);
        for (int k = 0; k < 4; ++k) {
            if constexpr (width_of<D> == 4) {
                std::memcpy(row(k), &r[k], sizeof r[k]);
            } else {
                const Doubles<4> low = __builtin_shufflevector(r[k], r[k], 0, 1, 2, 3),
                                 high = __builtin_shufflevector(r[k], r[k], 4, 5, 6, 7);
                std::memcpy(row(k), &low, sizeof low);
                std::memcpy(row(k + 4), &high, sizeof high);
            }
        }
    }
}

/// Bodies are too many for the processor's near caches, and contacts name them in no order that it could foresee.
template <class Item>
INTERPHASE_INLINE void fetch(const Item* items, const int (&index)[lanes])
{
    for (int k = 0; k < lanes; ++k)
        __builtin_prefetch(items + index[k]);
}

/// The bodies on one side of the contacts.
template <class D>
struct Side {
    Three<D> velocity, spin;
    D inverse_mass, inverse_inertia;
};

template <int width>
INTERPHASE_INLINE Side<Doubles<width>> load(const Body* bodies, const int* index)
{
    const auto v =
        load_rows<double, width>([&](int k) __attribute__((always_inline)) { return bodies[index[k]].velocity; });
    const auto w =
        load_rows<double, width>([&](int k) __attribute__((always_inline)) { return bodies[index[k]].spin; });
    return {{v.r[0], v.r[1], v.r[2]}, {w.r[0], w.r[1], w.r[2]}, v.r[3], w.r[3]};
}

template <class D>
INTERPHASE_INLINE void store(Body* bodies, const int* index, const Side<D>& side)
{
    store_rows(
        side.velocity,
        side.inverse_mass, [&](int k) __attribute__((always_inline)) { return bodies[index[k]].velocity; });
    store_rows(
        side.spin, side.inverse_inertia, [&](int k) __attribute__((always_inline)) { return bodies[index[k]].spin; });
}

/// The bodies on side b got `impulse`, those on side a its opposite; of the contacts from `first` on.
template <class D>
INTERPHASE_INLINE void exchange(const ContactBatch& batch, int first, Side<D>& a, Side<D>& b, const Three<D>& normal,
                                const Three<D>& impulse)
{
    constexpr int width = width_of<D>;
    exchange_impulse(a, b, wide<width>(batch.arm_i + first), wide<width>(batch.arm_j + first), normal, impulse);
}

template <class D>
INTERPHASE_INLINE void store(Body* bodies, const ContactBatch& batch, int first, const Side<D>& a, const Side<D>& b)
{
    store(bodies, batch.i + first, a);
    store(bodies, batch.j + first, b);
}

/// How many contacts at once this processor takes best.
/// How many contacts the solver takes at once. The variable INTERPHASE_LANES says fewer than the processor could, to
/// measure what that costs.
inline int best_width()
{
    static const int width = [] {
        const char* said = std::getenv("INTERPHASE_LANES");
        const int wanted = said ? std::atoi(said) : 0, most = has_widest() ? 8 : 4;
        return wanted == 1 || wanted == 4 ? wanted : most;
    }();
    return width;
}

}  // namespace interphase::hard_sphere
