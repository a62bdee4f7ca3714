// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstring>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/contact_batch.hpp"
#include "hard_sphere/processor.hpp"

/// The contacts of a batch side by side, in vectors of the compiler. They stay within a translation unit.
namespace interphase::hard_sphere {

using Doubles = double __attribute__((vector_size(8 * lanes)));
using Singles = float __attribute__((vector_size(4 * lanes)));
using Picks = long long __attribute__((vector_size(8 * lanes)));

struct Triple {
    Doubles x, y, z;
};

INTERPHASE_INLINE Doubles wide(const float (&narrow)[lanes])
{
    Doubles values;  // one by one: the compiler (gcc 12) converts a whole vector in halves
    for (int k = 0; k < lanes; ++k)
        values[k] = narrow[k];
    return values;
}

INTERPHASE_INLINE Triple wide(const float (&narrow)[3][lanes])
{
    return {wide(narrow[0]), wide(narrow[1]), wide(narrow[2])};
}

INTERPHASE_INLINE void store(float (&narrow)[lanes], const Doubles& values)
{
    const Singles rounded = __builtin_convertvector(values, Singles);
    std::memcpy(narrow, &rounded, sizeof rounded);
}

INTERPHASE_INLINE void store(float (&narrow)[3][lanes], const Triple& values)
{
    store(narrow[0], values.x);
    store(narrow[1], values.y);
    store(narrow[2], values.z);
}

INTERPHASE_INLINE Doubles smaller(const Doubles& a, const Doubles& b) { return a < b ? a : b; }
INTERPHASE_INLINE Doubles larger(const Doubles& a, const Doubles& b) { return a > b ? a : b; }

template <class Vectors>
INTERPHASE_INLINE Vectors square_root(const Vectors& values)
{
    Vectors roots;
    for (int k = 0; k < lanes; ++k)
        roots[k] = std::sqrt(values[k]);
    return roots;
}

INTERPHASE_INLINE Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
INTERPHASE_INLINE Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
INTERPHASE_INLINE Triple operator*(const Doubles& s, const Triple& a) { return {s * a.x, s * a.y, s * a.z}; }
INTERPHASE_INLINE Doubles dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

INTERPHASE_INLINE Triple cross(const Triple& a, const Triple& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Vectors>
INTERPHASE_INLINE void transpose(Vectors& a, Vectors& b, Vectors& c, Vectors& d)
{
    using Order = decltype(a < b);
    const Vectors ab_low = __builtin_shuffle(a, b, Order{0, 4, 2, 6}),
                  ab_high = __builtin_shuffle(a, b, Order{1, 5, 3, 7});
    const Vectors cd_low = __builtin_shuffle(c, d, Order{0, 4, 2, 6}),
                  cd_high = __builtin_shuffle(c, d, Order{1, 5, 3, 7});
    a = __builtin_shuffle(ab_low, cd_low, Order{0, 1, 4, 5});
    b = __builtin_shuffle(ab_high, cd_high, Order{0, 1, 4, 5});
    c = __builtin_shuffle(ab_low, cd_low, Order{2, 3, 6, 7});
    d = __builtin_shuffle(ab_high, cd_high, Order{2, 3, 6, 7});
}

/// Three numbers and a fourth behind them of each contact's body.
struct Quadruple {
    Triple three;
    Doubles fourth;
};

template <class Row>
INTERPHASE_INLINE Quadruple load_rows(const Row& row)
{
    Doubles r[lanes];
    for (int k = 0; k < lanes; ++k)
        std::memcpy(&r[k], row(k), sizeof(Doubles));
    transpose(r[0], r[1], r[2], r[3]);
    return {{r[0], r[1], r[2]}, r[3]};
}

/// Bodies are too many for the processor's near caches, and contacts name them in no order that it could foresee.
template <class Item>
INTERPHASE_INLINE void fetch(const Item* items, const int (&index)[lanes])
{
    for (int k = 0; k < lanes; ++k)
        __builtin_prefetch(items + index[k]);
}

/// The bodies on one side of the contacts.
struct Side {
    Triple velocity, spin;
    Doubles inverse_mass, inverse_inertia;
};

INTERPHASE_INLINE Side load(const Body* bodies, const int (&index)[lanes])
{
    const Quadruple v = load_rows([&](int k) __attribute__((always_inline)) { return bodies[index[k]].velocity; });
    const Quadruple w = load_rows([&](int k) __attribute__((always_inline)) { return bodies[index[k]].spin; });
    return {v.three, w.three, v.fourth, w.fourth};
}

INTERPHASE_INLINE void store(Body* bodies, const int (&index)[lanes], const Side& side)
{
    Doubles v[4] = {side.velocity.x, side.velocity.y, side.velocity.z, side.inverse_mass};
    Doubles w[4] = {side.spin.x, side.spin.y, side.spin.z, side.inverse_inertia};
    transpose(v[0], v[1], v[2], v[3]);
    transpose(w[0], w[1], w[2], w[3]);
    for (int k = 0; k < lanes; ++k) {
        std::memcpy(bodies[index[k]].velocity, &v[k], sizeof(Doubles));
        std::memcpy(bodies[index[k]].spin, &w[k], sizeof(Doubles));
    }
}

/// Gives `impulse` to the bodies on side b, its opposite to those on side a.
INTERPHASE_INLINE void give(Body* bodies, const ContactBatch& batch, Side& a, Side& b, const Triple& normal,
                            const Triple& impulse)
{
    const Triple twist = cross(normal, impulse);
    a.velocity = a.velocity - a.inverse_mass * impulse;
    b.velocity = b.velocity + b.inverse_mass * impulse;
    a.spin = a.spin - (wide(batch.arm_i) * a.inverse_inertia) * twist;
    b.spin = b.spin - (wide(batch.arm_j) * b.inverse_inertia) * twist;
    store(bodies, batch.i, a);
    store(bodies, batch.j, b);
}

}  // namespace interphase::hard_sphere
