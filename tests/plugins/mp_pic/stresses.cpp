// SPDX-License-Identifier: GPL-3.0-or-later
// Harris and Crighton's stress as one of one's own, and stresses that are none, each in one way.
#include <algorithm>
#include <array>
#include <cmath>

#include "mp_pic/fix_mp_pic_of.hpp"

using interphase::mp_pic::above_zero;
using interphase::mp_pic::StressNumber;
using interphase::mp_pic::unbounded;

namespace {

struct Rewritten {
    double pressure, exponent, close_packing;
    static constexpr StressNumber numbers[] = {{"P_s", "Pa", above_zero, unbounded},
                                               {"xi", "", above_zero, unbounded, 2, 5}};

    double stress(double solid_fraction) const
    {
        constexpr double alpha = 1e-7;
        const double phi = std::clamp(solid_fraction, 0.0, 1 - alpha);
        return pressure * std::pow(phi, exponent) / std::max(close_packing - phi, alpha * (1 - phi));
    }
};

/// Of no numbers: it pushes as an ideal gas.
struct Plain {
    double close_packing;
    static constexpr std::array<StressNumber, 0> numbers{};

    double stress(double solid_fraction) const { return 10 * solid_fraction / close_packing; }
};

struct Draws : Plain {
    double stress(double solid_fraction) const { return 10 * solid_fraction - 1; }
};

struct Falls : Plain {
    double stress(double solid_fraction) const { return 4 + std::sin(10 * solid_fraction); }
};

struct HasAPole : Plain {
    double stress(double solid_fraction) const { return solid_fraction / (close_packing - solid_fraction); }
};

struct HasNoNumber : Plain {
    double stress(double solid_fraction) const { return std::sqrt(0.63 - solid_fraction) * 0 + solid_fraction; }
};

}  // namespace

INTERPHASE_STRESSES("stresses", INTERPHASE_STRESS_STYLES("rewritten", Rewritten),
                    INTERPHASE_STRESS_STYLES("plain", Plain), INTERPHASE_STRESS_STYLES("draws", Draws),
                    INTERPHASE_STRESS_STYLES("falls", Falls), INTERPHASE_STRESS_STYLES("has_a_pole", HasAPole),
                    INTERPHASE_STRESS_STYLES("has_no_number", HasNoNumber))
