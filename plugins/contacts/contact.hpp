// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vector.hpp"

namespace interphase::contacts {

/// A contact of a sphere with another one or with a wall, as the sphere sees it. The other sphere sees the same with
/// opposite signs, to the last bit.
struct Contact {
    Vector normal;   ///< unit vector, to the sphere from what it touches
    double overlap;  ///< [m], above 0
    Vector
        velocity;  ///< of the sphere's surface against that of the other one, at the contact: motion and rotation [m/s]
    Vector spin;   ///< of the sphere against the other one [rad/s]
    double mass;   ///< reduced: m_1 m_2/(m_1 + m_2); the sphere's own at a wall [kg]
    double radius;   ///< reduced: r_1 r_2/(r_1 + r_2); the sphere's own at a wall [m]
    int type;        ///< of the sphere's material, from 0
    int other_type;  ///< of the other one's
    double
        step;  ///< time since the last call for this contact; 0 where forces are only made again, at a run's start [s]
};

/// What a law answers.
struct Push {
    Vector force;                    ///< on the sphere, at the contact [N]
    Vector moment = Vector::Zero();  ///< on the sphere, beside the force's own [N m]
};

/// A property between two materials.
class BetweenTypes {
public:
    explicit BetweenTypes(int types = 0) : types_(types), values_(static_cast<std::size_t>(types * types)) {}
    double& between(int a, int b) { return values_[static_cast<std::size_t>(a * types_ + b)]; }
    double operator()(const Contact& contact) const
    {
        return values_[static_cast<std::size_t>(contact.type * types_ + contact.other_type)];
    }

private:
    int types_;
    std::vector<double> values_;
};

}  // namespace interphase::contacts
