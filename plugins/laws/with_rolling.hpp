// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laws/with_property.hpp"

namespace interphase::laws {

/// A law, and rolling resistance: a couple that opposes the difference of two spheres' spins across the normal, up to
/// mu_r r_e times the normal force. Of the models that Ai et al., Powder Technol. 206 (2011) 269, compare it is A, with
/// a couple at rest that is whatever keeps the two from rolling, as Coulomb's friction holds what does not slip.
template <class Law>
struct WithRolling : Law {
    template <class D>
    struct Materials : Law::template Materials<D> {
        D rolling_friction;  ///< mu_r, of the effective radius
    };
    static constexpr auto properties =
        properties_with<Law>(hard_sphere::MaterialProperty{"coefficientRollingFriction", 0, 1e30});

    template <class D>
    static D rolling_friction(const Materials<D>& materials, const hard_sphere::Meeting<D>&)
    {
        return materials.rolling_friction;
    }
};

}  // namespace interphase::laws
