// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings.hpp"

namespace interphase {

std::string name_of(Method method)
{
    switch (method) {
        case Method::dem:
            return "DEM";
        case Method::cgpm:
            return "CGPM";
        case Method::tdhs:
            return "TDHS";
        case Method::cghs:
            return "CGHS";
        case Method::mp_pic:
            return "MPPIC";
        case Method::plugin:
            return "PLUGIN";
    }
    return "";
}

bool resolves_contacts(Method method) { return method == Method::dem || method == Method::cgpm; }

bool tracks_parcels(Method method) { return method != Method::dem && method != Method::tdhs; }

bool is_hard_sphere(Method method) { return method == Method::tdhs || method == Method::cghs; }

}  // namespace interphase
