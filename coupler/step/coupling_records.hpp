// SPDX-License-Identifier: GPL-3.0-or-later
// What travels between particles and cells in a coupling step, as its parts read and write it.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/vector.hpp"

namespace interphase {

/// What a particle brings to its gas cell. One-way scenes send the first nine entries only, those with solid stress
/// four more at the end: momentum and mass.
enum VisitorEntry {
    position = 0,
    velocity = 3,  // with which it begins the step
    diameter = 6,  // of the real particle
    volume = 7,    // of solids in the tracked one
    mass = 8,
    one_way_record = 9,
    pending = 9,
    by_contacts = 12,       // what the last step changed in its momentum
    without_contacts = 15,  // and would have
    weight = 18,            // and gravity alone, with drag
    two_way_record = 19,
};
constexpr std::size_t held_record = two_way_record - by_contacts;
constexpr std::size_t momentum_record = 4;

/// What it takes home: drag rate, gas velocity, pressure gradient, what the gas solve assumed of its impulse, and what
/// a StressExchange adds.
constexpr std::size_t homeward_record = 10;

/// What goes to the cells of a particle: kappa, source (3), following, moving, mobility, flux (3).
constexpr std::size_t demand_record = 10;

/// What a particle sees of the gas before it is solved: voidage and velocity, and in long steps how contacts hold the
/// solids here, in doubt or not, and the last pressure gradient.
constexpr std::size_t seen_record = 4;
constexpr std::size_t seen_in_long_steps = 9;

inline Vector vector_at(const Scalars& flat, std::size_t start) { return to_vector(&flat[start]); }

inline void put(double* start, const Vector& v) { std::copy_n(v.data(), 3, start); }

struct GasSeen {
    GasSeen(const double* record, bool in_long_step) : voidage(record[0]), velocity(to_vector(record + 1))
    {
        if (!in_long_step) return;
        held = record[4];
        doubt = record[5];
        pressure_gradient = to_vector(record + 6);
    }

    double voidage;
    Vector velocity;  ///< [m/s]
    double held = 0, doubt = 0;
    Vector pressure_gradient = Vector::Zero();  ///< [Pa/m]
};

}  // namespace interphase
