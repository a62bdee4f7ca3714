// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/drag_law.hpp"

#include <algorithm>

#include "forces/drag/beetstra.hpp"
#include "forces/drag/beetstra_polydisperse.hpp"
#include "forces/drag/di_felice.hpp"
#include "forces/drag/ergun.hpp"
#include "forces/drag/gidaspow.hpp"
#include "forces/drag/koch_hill.hpp"
#include "forces/drag/radl_sundaresan.hpp"
#include "forces/drag/schiller_naumann.hpp"
#include "forces/drag/syamlal_obrien.hpp"
#include "forces/drag/wen_yu.hpp"

namespace interphase {

const std::vector<DragLaw>& drag_laws()
{
    static const std::vector<DragLaw> laws = {
        {"BVK", beetstra, 0.4, 0.9, 1000.0, "Beetstra, van der Hoef, Kuipers, AIChE J. 53 (2007) 489"},
        {"WenYu", wen_yu, 0.4, 1.0, 2e5, "Wen, Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100"},
        {"Ergun", ergun, 0.35, 0.55, 1500.0, "Ergun, Chem. Eng. Prog. 48 (1952) 89"},
        {"Gidaspow", gidaspow, 0.35, 1.0, 1500.0, "Gidaspow, Multiphase Flow and Fluidization, Academic Press (1994)"},
        {"DiFelice", di_felice, 0.4, 1.0, 1e4, "Di Felice, Int. J. Multiphase Flow 20 (1994) 153"},
        {"KochHill", koch_hill, 0.36, 0.9, 200.0, "Hill, Koch, Ladd, J. Fluid Mech. 448 (2001) 213 and 243"},
        {"SyamlalOBrien", syamlal_obrien, 0.4, 1.0, 3e4, "Syamlal, O'Brien, AIChE Symp. Ser. 85 (1989) 22"},
        {"BVKPolydisperse", beetstra_polydisperse, 0.4, 0.9, 1000.0,
         "Beetstra, van der Hoef, Kuipers, AIChE J. 53 (2007) 489", DragLooksAt::mean_diameter},
        {"RadlSundaresan", radl_sundaresan, 0.4, 1.0, 1000.0, "Radl, Sundaresan, Chem. Eng. Sci. 117 (2014) 416",
         DragLooksAt::cell_size},
        {"SchillerNaumann", schiller_naumann, 0.99, 1.0, 2e5, "Schiller, Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318"},
    };
    return laws;
}

const DragLaw* find_drag_law(std::string_view name)
{
    const auto& laws = drag_laws();
    const auto law = std::find_if(laws.begin(), laws.end(), [&](const DragLaw& each) { return each.name == name; });
    return law == laws.end() ? nullptr : &*law;
}

double drag_rate_per_volume(const DragLaw& law, double voidage, double slip_speed, double diameter, double gas_density,
                            double gas_viscosity, DragState state)
{
    state.voidage = voidage;
    state.reynolds = superficial_reynolds(voidage, slip_speed, diameter, gas_density, gas_viscosity);
    return 18.0 * gas_viscosity * voidage * law.factor(state) / (diameter * diameter);
}

}  // namespace interphase
