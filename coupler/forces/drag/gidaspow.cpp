// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/gidaspow.hpp"

#include "forces/drag/ergun.hpp"
#include "forces/drag/wen_yu.hpp"

namespace interphase {

double gidaspow(const DragState& state)
{
    constexpr double dense_below = 0.8;
    return state.voidage < dense_below ? ergun(state) : wen_yu(state);
}

}  // namespace interphase
