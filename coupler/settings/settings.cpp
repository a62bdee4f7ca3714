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
    }
    return "";
}

}  // namespace interphase
