// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <iterator>

#include "hard_sphere/law.hpp"

namespace interphase::laws {

/// The properties of a law and one or more behind them.
template <class Law, class... More>
constexpr auto properties_with(const More&... more)
{
    std::array<hard_sphere::MaterialProperty, std::size(Law::properties) + sizeof...(More)> all{};
    std::size_t k = 0;
    for (const hard_sphere::MaterialProperty& property : Law::properties)
        all[k++] = property;
    ((all[k++] = more), ...);
    return all;
}

}  // namespace interphase::laws
