// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase::hard_sphere {

/// Contacts resolved at once: no two of them share a body, so they do not wait for each other.
constexpr int lanes = 4;

/// Four contacts of clusters. Single precision: the same rounded impulse goes to both bodies, so linear momentum is
/// kept to double precision all the same, and memory traffic is what the passes cost. Empty lanes name a body that
/// nothing moves.
struct alignas(16) ContactBatch {
    int i[lanes], j[lanes];
    float normal[3][lanes];            ///< from i to j
    float arm_i[lanes], arm_j[lanes];  ///< from the centres to the point of contact [m]
    float mass[lanes];                 ///< effective, m_e [kg]
    float closing[lanes];              ///< gap / step: contact begins beyond this approach [m/s]
    float friction[lanes];
    float impulse[lanes];        ///< along the normal, on j [kg m/s]
    float tangential[3][lanes];  ///< [kg m/s]
};

/// What impacts have besides.
struct alignas(16) ImpactBatch : ContactBatch {
    float restitution[lanes];
    float tangential_restitution[lanes];
    float least[lanes];  ///< impulse that restitution gives at least, once compression is over [kg m/s]
};

}  // namespace interphase::hard_sphere
