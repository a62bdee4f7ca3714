// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/counter.hpp"

namespace interphase::mp_pic {

/// What fix mp_pic counts.
constexpr Counter counters[] = {{"put_out_of_walls", "parcels put out of a wall", "", OverRanks::sum, never_worry,
                                 "A parcel stood in a wall that it did not approach, as in a narrow corner or after "
                                 "the wall came to it, and was put "
                                 "back before it.",
                                 "It moves by less than its radius, and its velocity stays as it is.", ""}};

}  // namespace interphase::mp_pic
