// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstring>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/contact_batch.hpp"
#include "hard_sphere/processor.hpp"

/// Contacts of a batch side by side, in vectors of the compiler: `width` of them, 4 or 8, as the processor takes them.
/// They stay within a translation unit.
namespace interphase::hard_sphere {

template <int width>
struct Vectors {
    typedef double Doubles __attribute__((vector_size(8 * width)));
    typedef float Singles __attribute__((vector_size(4 * width)));
};
template <int width>
using Doubles = typename Vectors<width>::Doubles;
template <int width>
using Singles = typename Vectors<width>::Singles;

template <class D>
inline constexpr int width_of = sizeof(D) / sizeof(double);

template <class D>
struct Triple {
    D x, y, z;
};

template <int width>
INTERPHASE_INLINE Doubles<width> wide(const float* narrow)
{
    Doubles<width> values;  // one by one: the compiler (gcc 12) converts a whole vector in halves
    for (int k = 0; k < width; ++k)
        values[k] = narrow[k];
    return values;
}

template <int width>
INTERPHASE_INLINE Triple<Doubles<width>> wide(const float (&narrow)[3][lanes], int first)
{
    return {wide<width>(narrow[0] + first), wide<width>(narrow[1] + first), wide<width>(narrow[2] + first)};
}

template <class D>
INTERPHASE_INLINE void store(float* narrow, const D& values)
{
    const auto rounded = __builtin_convertvector(values, Singles<width_of<D>>);
    std::memcpy(narrow, &rounded, sizeof rounded);
}

template <class D>
INTERPHASE_INLINE void store(float (&narrow)[3][lanes], int first, const Triple<D>& values)
{
    store(narrow[0] + first, values.x);
    store(narrow[1] + first, values.y);
    store(narrow[2] + first, values.z);
}

/// `yes` where `value` is below zero, else `no`, by its sign. The compiler (gcc 12) takes comparisons of vectors apart,
/// number by number, once two of them meet.
template <class D>
INTERPHASE_INLINE D if_negative(const D& value, const D& yes, const D& no)
{
    using Bits = decltype(value < value);
    const Bits negative = (Bits)(value + 0.0) >> 63;  // the sign of a zero does not count
    return (D)(((Bits)yes & negative) | ((Bits)no & ~negative));
}

template <class D>
INTERPHASE_INLINE D if_positive(const D& value, const D& yes, const D& no)
{
    return if_negative(D(-value), yes, no);
}

template <class D>
INTERPHASE_INLINE Triple<D> if_positive(const D& value, const Triple<D>& yes, const Triple<D>& no)
{
    return {if_positive(value, yes.x, no.x), if_positive(value, yes.y, no.y), if_positive(value, yes.z, no.z)};
}

template <class D>
INTERPHASE_INLINE D smaller(const D& a, const D& b)
{
    return a < b ? a : b;
}

template <class D>
INTERPHASE_INLINE D larger(const D& a, const D& b)
{
    return a > b ? a : b;
}

template <class D>
INTERPHASE_INLINE D square_root(const D& values)
{
    D roots;
    for (int k = 0; k < width_of<D>; ++k)
        roots[k] = std::sqrt(values[k]);
    return roots;
}

template <class D>
INTERPHASE_INLINE Triple<D> operator+(const Triple<D>& a, const Triple<D>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class D>
INTERPHASE_INLINE Triple<D> operator-(const Triple<D>& a, const Triple<D>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class D>
INTERPHASE_INLINE Triple<D> operator*(const D& s, const Triple<D>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

template <class D>
INTERPHASE_INLINE D dot(const Triple<D>& a, const Triple<D>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class D>
INTERPHASE_INLINE Triple<D> cross(const Triple<D>& a, const Triple<D>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
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

/// The reverse.
template <class D, class Row>
INTERPHASE_INLINE void store_rows(const Triple<D>& three, const D& fourth, const Row& row)
{
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
    Triple<D> velocity, spin;
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

/// Gives `impulse` to the bodies on side b, its opposite to those on side a; of the contacts from `first` on.
template <class D>
INTERPHASE_INLINE void give(Body* bodies, const ContactBatch& batch, int first, Side<D>& a, Side<D>& b,
                            const Triple<D>& normal, const Triple<D>& impulse)
{
    constexpr int width = width_of<D>;
    const Triple<D> twist = cross(normal, impulse);
    a.velocity = a.velocity - a.inverse_mass * impulse;
    b.velocity = b.velocity + b.inverse_mass * impulse;
    a.spin = a.spin - (wide<width>(batch.arm_i + first) * a.inverse_inertia) * twist;
    b.spin = b.spin - (wide<width>(batch.arm_j + first) * b.inverse_inertia) * twist;
    store(bodies, batch.i + first, a);
    store(bodies, batch.j + first, b);
}

}  // namespace interphase::hard_sphere
