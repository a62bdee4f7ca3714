// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mp_pic/any_stress.hpp"

namespace interphase::mp_pic {

/// The solid fractions at which a stress is looked at before a run: 0, 0.0001, ... 1, and close packing. Rising.
std::vector<double> looked_at(double close_packing);

/// What of a stress at these is none, with the value and the solid fraction, or nothing: it is a finite number, not
/// below 0, and does not fall.
std::string complaint_of(const StressFunction& stress, const std::vector<double>& solid_fractions);

}  // namespace interphase::mp_pic
