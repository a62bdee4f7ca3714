// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/vector.hpp"

namespace interphase::hard_sphere {

template <class Number>
Vector vector(const Number (&v)[3])
{
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// Three numbers; std::copy_n would call memmove for them.
inline void copy_three(const double* from, double* to)
{
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
}

/// What the solver changes of a sphere, one cache line. A body that nothing moves has 0 in both inverses.
struct alignas(64) Body {
    double velocity[3] = {0, 0, 0};  ///< [m/s]
    double inverse_mass = 0;         ///< [1/kg]
    double spin[3] = {0, 0, 0};      ///< angular velocity [rad/s]
    double inverse_inertia = 0;      ///< 1/I, I = m d^2/10 [1/(kg m2)]
};

struct alignas(32) Place {
    double centre[3] = {0, 0, 0};  ///< [m]
    double radius = 0;             ///< [m]
};

/// Who a body is.
struct Label {
    int atom;   ///< its index in the particle engine
    int id;     ///< the same on every rank
    int type;   ///< of material, from 0
    int ghost;  ///< 1 where another rank owns it
};

/// The spheres of one rank, ghosts included, as structure of arrays. `body` has one more, of resting walls, and may
/// have those of moving walls behind it.
struct Bodies {
    std::vector<Body> body;
    std::vector<Place> place;
    std::vector<Label> label;
    std::vector<Vector> push;  ///< change of velocity by forces other than contacts in this step [m/s]; `body` has it

    std::size_t size() const { return place.size(); }
    void resize(std::size_t n)
    {
        body.resize(n);
        place.resize(n);
        label.resize(n);
        push.resize(n);
    }
};

}  // namespace interphase::hard_sphere
