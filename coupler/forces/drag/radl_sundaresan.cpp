// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/radl_sundaresan.hpp"

#include <algorithm>
#include <array>

#include "forces/drag/beetstra.hpp"

namespace interphase {

namespace {

/// c0 + c1 x + c2 x^2 + c3 x^3 below `until`, x the solid fraction less `from`.
struct Piece {
    double until, from;
    std::array<double, 4> c;
};

template <std::size_t count>
double value_of(const std::array<Piece, count>& pieces, double phi)
{
    const auto last = pieces.end() - 1;
    const Piece& piece = *std::find_if(pieces.begin(), last, [&](const Piece& each) { return phi < each.until; });
    const double x = phi - piece.from;
    return piece.c[0] + x * (piece.c[1] + x * (piece.c[2] + x * piece.c[3]));
}

constexpr std::array<Piece, 6> of_a{{{0.016, 0, {21.51, 0, 0, 0}},
                                     {0.100, 0, {1.96, 29.40, 164.91, -1923}},
                                     {0.180, 0.10, {4.63, 4.68, -412.04, 2254}},
                                     {0.250, 0.18, {3.52, -17.99, 128.80, -603}},
                                     {0.400, 0.25, {2.68, -8.20, 2.18, 112.33}},
                                     {1, 0.40, {1.79, 0, 0, 0}}}};
constexpr std::array<Piece, 8> of_h{{{0.03, 0, {0, 7.97, 0, 0}},
                                     {0.08, 0.03, {0.239, 4.640, -4.410, 253.630}},
                                     {0.12, 0.08, {0.492, 6.100, 33.630, -789.600}},
                                     {0.18, 0.12, {0.739, 5.010, -61.100, 310.800}},
                                     {0.34, 0.18, {0.887, 1.030, -5.170, 5.990}},
                                     {0.48, 0.34, {0.943, -0.170, -2.290, -9.120}},
                                     {0.55, 0.48, {0.850, -1.350, -6.130, -132.600}},
                                     {1, 0.55, {0.680, -2.340, -225.200, 0}}}};

}  // namespace

double radl_sundaresan_correction(double solid_fraction, double filter_size)
{
    // the last cubic of h falls below 0 from phi = 0.6 on, where nothing clusters
    const double h = std::max(0.0, value_of(of_h, solid_fraction)), a = value_of(of_a, solid_fraction);
    return filter_size > 0 ? 1 - h / (1 + a / filter_size) : 1;
}

double radl_sundaresan(const DragState& state)
{
    return radl_sundaresan_correction(solid_fraction(state), state.filter_size) * beetstra(state);
}

}  // namespace interphase
