// SPDX-License-Identifier: GPL-3.0-or-later
#include "drag/gidaspow.hpp"

#include "drag/ergun.hpp"
#include "drag/wen_yu.hpp"

namespace interphase {

double gidaspow(const DragState& state)
{
    constexpr double dense_below = 0.8;
    return state.voidage < dense_below ? ergun(state) : wen_yu(state);
}

}  // namespace interphase
