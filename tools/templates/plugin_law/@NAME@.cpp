// SPDX-License-Identifier: GPL-3.0-or-later
// Hard spheres that yield: the restitution is a number of the materials up to an approach at which they begin to deform for
// good, and falls with the fourth root of the approach beyond it (Johnson, Contact Mechanics, Cambridge 1985, ch. 11.5).
#include <interphase/hard_sphere/fix_tdhs_of.hpp>

using namespace interphase::hard_sphere;

struct @CLASS@ {
    /// What the script says of two materials, in the order of `properties`.
    template <class D>
    struct Materials {
        D restitution, yield_speed, friction;
    };
    static constexpr MaterialProperty properties[] = {
        {"coefficientRestitution", 0, 1}, {"yieldSpeed", 1e-6, 1e6}, {"coefficientFriction", 0, 1e30}};

    /// e_n, 0 to 1. D is the number of one contact, or of several side by side: no `if`, but `larger`, `power`,
    /// `if_positive` and so on (<interphase/hard_sphere/lane_numbers.hpp>).
    template <class D>
    static D restitution(const Materials<D>& between, const Meeting<D>& meeting)
    {
        const D one = D{} + 1, beyond = meeting.speed / between.yield_speed;
        return between.restitution * power(larger(beyond, one), -0.25);
    }

    /// mu. <interphase/hard_sphere/law.hpp> says what else a law may have: e_t, rolling friction, an attraction.
    template <class D>
    static D friction(const Materials<D>& between, const Meeting<D>&)
    {
        return between.friction;
    }
};

INTERPHASE_LAW("@NAME@", @CLASS@)
INTERPHASE_METHODS(interphase::method("@METHOD@", "impulses between hard spheres that yield").steps_per_collision(1))
