// SPDX-License-Identifier: GPL-3.0-or-later
// Friction that grows with the time that a contact has lasted.
#include "hard_sphere/fix_tdhs_of.hpp"

using interphase::hard_sphere::MaterialProperty;
using interphase::hard_sphere::Meeting;

struct Aging {
    template <class D>
    struct Materials {
        D restitution, friction, growth;  ///< growth: of mu, by time [1/s]
    };
    static constexpr MaterialProperty properties[] = {
        {"coefficientRestitution", 0, 1}, {"coefficientFriction", 0, 1e30}, {"frictionGrowth", 0, 1e30}};
    template <class D>
    struct State {
        D age;  ///< [s]
    };

    template <class D>
    static State<D> next(const State<D>& last, const Materials<D>&, const Meeting<D>&, double step)
    {
        return {last.age + step};
    }
    template <class D>
    static D restitution(const Materials<D>& between, const Meeting<D>&)
    {
        return between.restitution;
    }
    template <class D>
    static D friction(const Materials<D>& between, const Meeting<D>&, const State<D>& now)
    {
        return between.friction + between.growth * now.age;
    }
};

INTERPHASE_LAW("aging", Aging)
