// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/method.hpp"

namespace interphase {

std::string or_with_parcels(const std::string& otherwise, const Method& method)
{
    return otherwise + (method.with_parcels.empty() ? "" : ", or take method " + method.with_parcels);
}

}  // namespace interphase
