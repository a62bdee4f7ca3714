// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>

namespace interphase::mp_pic {

/// A number that the script gives behind `stress NAME`. Others than `least` to `most` are refused; where published
/// values have a range, LIGGGHTS's log warns of those outside of it.
struct StressNumber {
    const char* name;
    const char* unit;  ///< "" where it has none
    double least, most;
    double published_least = -DBL_MAX, published_most = DBL_MAX;
};
constexpr double above_zero = DBL_MIN, unbounded = DBL_MAX;

/// A stress of the solids is a class of this kind, without direction (a pressure); SI units:
///
///     struct Linear {
///         double pressure;       // what the script gives behind `stress NAME`, in the order of `numbers`
///         double close_packing;  // and, always the last, the fix's keyword of that name
///         static constexpr StressNumber numbers[] = {{"P", "Pa", above_zero, unbounded}};
///
///         double stress(double solid_fraction) const { return pressure * solid_fraction / close_packing; }
///     };
///
/// stress(): tau [Pa] of a solid fraction of 0 to 1. It is finite, not below 0, and does not fall; stress_check.hpp
/// looks. It is asked once for each gas cell and gas step. A stress without numbers has a std::array of none.

}  // namespace interphase::mp_pic
