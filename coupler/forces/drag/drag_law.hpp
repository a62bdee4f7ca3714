// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// A drag law's dimensionless drag factor F [-], defined by
///
///     beta = 18 mu eps (1 - eps) F / d^2,
///     force on one particle = V_p ( -grad p + beta / (1 - eps) (u_g - v) ),
///
/// so that F -> 1 is Stokes drag on an isolated sphere. F is the drag without the pressure gradient's share: where
/// a paper gives the whole force F_t that a particle takes from a uniform flow, n F_t = -grad p leaves F = eps F_t.
/// Papers also differ in what their Reynolds number is made of; each law converts to DragState inside.
///
/// Finite and free of floating-point exceptions for 0.01 <= eps <= 1 and 0 <= Re < 1e9, inside the law's range of
/// validity or not.
using DragFactor = double (*)(const DragState&);

/// What of a DragState a law looks at beside voidage and Reynolds number.
enum class DragLooksAt { flow, mean_diameter, cell_size };

struct DragLaw {
    /// As a case names it.
    std::string_view name;
    DragFactor factor;
    /// The range that the law's source claims for it. Outside, the formula is evaluated as it stands.
    double voidage_min, voidage_max, reynolds_max;
    std::string_view reference;
    DragLooksAt looks_at = DragLooksAt::flow;

    bool holds_at(double voidage, double reynolds) const
    {
        return voidage >= voidage_min && voidage <= voidage_max && reynolds <= reynolds_max;
    }
};

/// Every law there is, the default one first.
const std::vector<DragLaw>& drag_laws();

/// The law of this name; nullptr where there is none.
const DragLaw* find_drag_law(std::string_view name);

/// Re = eps rho |u_g - v| d / mu [-], what laws see and their ranges are given in.
inline double superficial_reynolds(double voidage, double slip_speed, double diameter, double gas_density,
                                   double gas_viscosity)
{
    return voidage * gas_density * slip_speed * diameter / gas_viscosity;
}

/// beta / (1 - eps) = 18 mu eps F / d^2 [kg/(m3 s)]: times V_p, the drag rate of one particle [kg/s]. Finite at
/// voidage 1 and at slip 0.
/// @param slip_speed     |u_g - v| [m/s], the gas velocity being the one between the particles (not superficial)
/// @param diameter       of the real particle [m], also where it stands for others in a parcel
/// @param gas_density    [kg/m3]
/// @param gas_viscosity  dynamic [Pa s]
/// @param state          diameter ratio and filter size, for laws that look at them
double drag_rate_per_volume(const DragLaw& law, double voidage, double slip_speed, double diameter, double gas_density,
                            double gas_viscosity, DragState state = {});

}  // namespace interphase
