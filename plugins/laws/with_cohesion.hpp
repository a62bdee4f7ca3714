// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laws/with_property.hpp"

namespace interphase::laws {

/// A law, and cohesion: spheres that touch take a force of 2 pi w r_e to part, w being the work of adhesion (Derjaguin,
/// Muller and Toporov, J. Colloid Interface Sci. 53 (1975) 314); it falls linearly to 0 over the range a, so that
/// parting them takes the work pi w r_e a.
template <class Law>
struct WithCohesion : Law {
    template <class D>
    struct Materials : Law::template Materials<D> {
        D work_of_adhesion;  ///< w [J/m2]
        D range;             ///< a [m]
    };
    static constexpr auto properties = properties_with<Law>(hard_sphere::MaterialProperty{"workOfAdhesion", 0, 1e30},
                                                            hard_sphere::MaterialProperty{"cohesionRange", 0, 1e30});

    static double attraction(const Materials<double>& materials, const hard_sphere::Separation& separation)
    {
        constexpr double pi = 3.14159265358979323846;
        const double touching = 2 * pi * materials.work_of_adhesion * separation.radius;
        return separation.gap <= 0 ? touching : touching * (1 - separation.gap / materials.range);
    }
    static double range(const Materials<double>& materials) { return materials.range; }
};

}  // namespace interphase::laws
