// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/sweep.hpp"

#include <cmath>
#include <cstring>

#include "hard_sphere/processor.hpp"

namespace interphase::hard_sphere {

namespace {

// vectors of the compiler: one value of each of the four contacts
using Four = double __attribute__((vector_size(32)));
using FourFloats = float __attribute__((vector_size(16)));
using Picks = long long __attribute__((vector_size(32)));

struct Triple {
    Four x, y, z;
};

INTERPHASE_INLINE Four wide(const float (&narrow)[lanes])
{
    FourFloats values;
    std::memcpy(&values, narrow, sizeof values);
    return __builtin_convertvector(values, Four);
}

INTERPHASE_INLINE void store(float (&narrow)[lanes], const Four& values)
{
    const FourFloats rounded = __builtin_convertvector(values, FourFloats);
    std::memcpy(narrow, &rounded, sizeof rounded);
}

INTERPHASE_INLINE Four rounded(const Four& values)
{
    return __builtin_convertvector(__builtin_convertvector(values, FourFloats), Four);
}

INTERPHASE_INLINE Triple wide(const float (&narrow)[3][lanes])
{
    return {wide(narrow[0]), wide(narrow[1]), wide(narrow[2])};
}

INTERPHASE_INLINE void transpose(Four& a, Four& b, Four& c, Four& d)
{
    const Four ab_low = __builtin_shuffle(a, b, Picks{0, 4, 2, 6}),
               ab_high = __builtin_shuffle(a, b, Picks{1, 5, 3, 7});
    const Four cd_low = __builtin_shuffle(c, d, Picks{0, 4, 2, 6}),
               cd_high = __builtin_shuffle(c, d, Picks{1, 5, 3, 7});
    a = __builtin_shuffle(ab_low, cd_low, Picks{0, 1, 4, 5});
    b = __builtin_shuffle(ab_high, cd_high, Picks{0, 1, 4, 5});
    c = __builtin_shuffle(ab_low, cd_low, Picks{2, 3, 6, 7});
    d = __builtin_shuffle(ab_high, cd_high, Picks{2, 3, 6, 7});
}

/// The bodies on one side of the contacts.
struct Side {
    Triple velocity, spin;
    Four inverse_mass, inverse_inertia;
};

INTERPHASE_INLINE Side load(const Body* bodies, const int (&index)[lanes])
{
    Four v[4], w[4];
    for (int k = 0; k < lanes; ++k) {
        std::memcpy(&v[k], bodies[index[k]].velocity, sizeof(Four));
        std::memcpy(&w[k], bodies[index[k]].spin, sizeof(Four));
    }
    transpose(v[0], v[1], v[2], v[3]);
    transpose(w[0], w[1], w[2], w[3]);
    return {{v[0], v[1], v[2]}, {w[0], w[1], w[2]}, v[3], w[3]};
}

INTERPHASE_INLINE void store(Body* bodies, const int (&index)[lanes], const Side& side)
{
    Four v[4] = {side.velocity.x, side.velocity.y, side.velocity.z, side.inverse_mass};
    Four w[4] = {side.spin.x, side.spin.y, side.spin.z, side.inverse_inertia};
    transpose(v[0], v[1], v[2], v[3]);
    transpose(w[0], w[1], w[2], w[3]);
    for (int k = 0; k < lanes; ++k) {
        std::memcpy(bodies[index[k]].velocity, &v[k], sizeof(Four));
        std::memcpy(bodies[index[k]].spin, &w[k], sizeof(Four));
    }
}

INTERPHASE_INLINE Triple cross(const Triple& a, const Triple& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

INTERPHASE_INLINE Four dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

INTERPHASE_INLINE void add(Triple& sum, const Four& factor, const Triple& term)
{
    sum.x += factor * term.x;
    sum.y += factor * term.y;
    sum.z += factor * term.z;
}

/// min(1, limit/size), size given by its square.
INTERPHASE_INLINE Four cone(const Four& limit, const Four& squared)
{
    const FourFloats square = __builtin_convertvector(squared, FourFloats);
    const FourFloats bound = __builtin_convertvector(limit, FourFloats);
    FourFloats factor;
    for (int k = 0; k < lanes; ++k)
        factor[k] = square[k] > bound[k] * bound[k] ? bound[k] / std::sqrt(square[k]) : 1.0f;
    return __builtin_convertvector(factor, Four);
}

/// For solid spheres, with and without a wall, the effective mass along the plane of contact is 2/7 of that along the
/// normal (Hoomans et al. 1996).
constexpr double tangential_share = 2.0 / 7.0;

/// What contacts of any kind have in common: the bodies, and their velocity at the point of contact.
struct Meeting {
    Side a, b;
    Triple normal;
    Four arm_a, arm_b;
    Triple slip;  ///< relative velocity, its normal part taken out
    Four apart;   ///< normal part
};

INTERPHASE_INLINE Meeting meet(const Body* bodies, const ContactBatch& batch)
{
    Meeting m{
        load(bodies, batch.i), load(bodies, batch.j), wide(batch.normal), wide(batch.arm_i), wide(batch.arm_j), {}, {}};
    const Triple rolling =
        cross({m.arm_a * m.a.spin.x + m.arm_b * m.b.spin.x, m.arm_a * m.a.spin.y + m.arm_b * m.b.spin.y,
               m.arm_a * m.a.spin.z + m.arm_b * m.b.spin.z},
              m.normal);
    m.slip = {m.b.velocity.x - m.a.velocity.x - rolling.x, m.b.velocity.y - m.a.velocity.y - rolling.y,
              m.b.velocity.z - m.a.velocity.z - rolling.z};
    m.apart = dot(m.slip, m.normal);
    add(m.slip, -m.apart, m.normal);
    return m;
}

INTERPHASE_INLINE bool all_zero(const Four& a, const Four& b)
{
    const Picks set = (a != 0) | (b != 0);
    return (set[0] | set[1] | set[2] | set[3]) == 0;
}

/// Replaces the impulses of the contacts and gives the difference to the bodies.
INTERPHASE_INLINE void give(Body* bodies, ContactBatch& batch, Meeting& m, const Four& normal, const Triple& wanted)
{
    const Four old_normal = wide(batch.impulse);
    const Triple old = wide(batch.tangential);
    const Four factor = cone(wide(batch.friction) * normal, dot(wanted, wanted));
    const Triple tangential{rounded(factor * wanted.x), rounded(factor * wanted.y), rounded(factor * wanted.z)};
    store(batch.impulse, normal);
    store(batch.tangential[0], tangential.x);
    store(batch.tangential[1], tangential.y);
    store(batch.tangential[2], tangential.z);

    Triple impulse{tangential.x - old.x, tangential.y - old.y, tangential.z - old.z};
    add(impulse, normal - old_normal, m.normal);
    const Triple twist = cross(m.normal, impulse);
    add(m.a.velocity, -m.a.inverse_mass, impulse);
    add(m.b.velocity, m.b.inverse_mass, impulse);
    add(m.a.spin, -m.arm_a * m.a.inverse_inertia, twist);
    add(m.b.spin, -m.arm_b * m.b.inverse_inertia, twist);
    store(bodies, batch.i, m.a);
    store(bodies, batch.j, m.b);
}

INTERPHASE_INLINE void resolve(Body* bodies, ContactBatch& batch)
{
    Meeting m = meet(bodies, batch);
    const Four mass = wide(batch.mass), old = wide(batch.impulse), zero{};
    Four normal = old - mass * (m.apart + wide(batch.closing));
    normal = rounded(normal > zero ? normal : zero);
    if (all_zero(normal, old)) return;
    Triple tangential = wide(batch.tangential);
    add(tangential, -tangential_share * mass, m.slip);
    give(bodies, batch, m, normal, tangential);
}

INTERPHASE_INLINE void resolve(Body* bodies, ImpactBatch& batch, Phase phase)
{
    Meeting m = meet(bodies, batch);
    const Four mass = wide(batch.mass), old = wide(batch.impulse), zero{};
    const Four without = mass * (m.apart + wide(batch.closing)) - old;  // below 0: they touch, but for this contact
    const Four stopping = old - mass * m.apart;
    Four least{};
    Triple tangential = wide(batch.tangential);
    if (phase == Phase::release) {
        least = old * (1 + wide(batch.restitution));
        store(batch.least, least);
        const Four more = 1 + wide(batch.tangential_restitution);
        tangential = {more * tangential.x, more * tangential.y, more * tangential.z};
    } else if (phase == Phase::compression) {
        add(tangential, -tangential_share * mass, m.slip);
    } else {
        least = wide(batch.least);
    }
    Four normal = without < zero ? stopping : zero;
    normal = rounded(normal > least ? normal : least);
    if (all_zero(normal, old)) return;
    give(bodies, batch, m, normal, tangential);
}

template <class Resolve>
INTERPHASE_INLINE void each(std::size_t count, Direction direction, const Resolve& resolve_batch)
{
    if (direction == Direction::forward)
        for (std::size_t k = 0; k < count; ++k)
            resolve_batch(k);
    else
        for (std::size_t k = count; k > 0; --k)
            resolve_batch(k - 1);
}

}  // namespace

INTERPHASE_CLONES
void sweep(std::vector<Body>& bodies, std::vector<ContactBatch>& batches, std::size_t count, Direction direction)
{
    Body* body = bodies.data();
    ContactBatch* batch = batches.data();
    each(
        count, direction, [=](std::size_t k) __attribute__((always_inline)) { resolve(body, batch[k]); });
}

INTERPHASE_CLONES
void sweep(std::vector<Body>& bodies, std::vector<ImpactBatch>& batches, std::size_t count, Direction direction,
           Phase phase)
{
    Body* body = bodies.data();
    ImpactBatch* batch = batches.data();
    each(
        count, direction, [=](std::size_t k) __attribute__((always_inline)) { resolve(body, batch[k], phase); });
}

}  // namespace interphase::hard_sphere
