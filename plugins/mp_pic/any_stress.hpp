// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#include "mp_pic/stress.hpp"

namespace interphase::mp_pic {

/// tau [Pa] of a solid fraction of 0 to 1.
using StressFunction = std::function<double(double)>;

/// A stress as the fix sees it, whatever its class.
struct AnyStress {
    std::string name;  ///< in the script, behind `stress`
    std::vector<StressNumber> numbers;
    StressFunction (*of)(const std::vector<double>& values);  ///< of its numbers and, behind them, the close packing
};

/// That of a class as in stress.hpp.
template <class Stress>
AnyStress any_stress(const std::string& name)
{
    static_assert(
        std::is_trivially_copyable_v<Stress> && sizeof(Stress) == (std::size(Stress::numbers) + 1) * sizeof(double),
        "a stress holds its numbers, in their order, and then close_packing, all of them double, and no more");
    return {name, {std::begin(Stress::numbers), std::end(Stress::numbers)}, [](const std::vector<double>& values) {
                Stress stress;
                std::memcpy(static_cast<void*>(&stress), values.data(), sizeof stress);
                return StressFunction([stress](double solid_fraction) { return stress.stress(solid_fraction); });
            }};
}

}  // namespace interphase::mp_pic
