// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase::hard_sphere {

/// Contacts resolved at once: no two of them share a body, so they do not wait for each other.
constexpr int lanes = 8;  // of AVX-512; others take them in two halves

/// Contacts of clusters. Single precision, for less memory traffic: what a pass changes goes to both bodies
/// in double precision before it is kept, so linear momentum is conserved to that. Empty lanes name a body that
/// nothing moves.
struct alignas(32) ContactBatch {
    int i[lanes], j[lanes];
    float normal[3][lanes];            ///< from i to j
    float arm_i[lanes], arm_j[lanes];  ///< from the centres to the point of contact [m]
    float mass[lanes];                 ///< effective, m_e [kg]
    float closing[lanes];              ///< gap / step: contact begins beyond this approach [m/s]
    float friction[lanes];
    float impulse[lanes];            ///< along the normal, on j [kg m/s]
    float tangential[3][lanes];      ///< [kg m/s]
    float bounce[lanes];             ///< of impacts 1 + e_n; 0: no impact, restitution does not apply
    float tangential_bounce[lanes];  ///< of impacts 1 + e_t
    float least[lanes];  ///< of impacts: impulse that restitution gives at least, once compression is over [kg m/s]
};

/// What a batch has besides where the law resists rolling.
struct alignas(32) RollingBatch {
    float arm[lanes];        ///< Response::rolling_arm [m]
    float couple[3][lanes];  ///< on j [kg m2/s]
};

/// What the passes do not need.
struct BatchNotes {
    int owner[lanes];         ///< body that remembers the impulse; any, in an empty lane
    int partner[lanes];       ///< what it remembers it under
    float touch_time[lanes];  ///< of impacts: when within the step [s]
    int materials[lanes];     ///< which pair of types, Materials::between
    float speed[lanes];  ///< of impacts: approach at the moment of touching; 0: no impact [m/s]. Before contacts are
                         ///< ready: 1 where there may be an impact
};

/// Two bodies that overlap at the start of the step.
struct Overlap {
    int i, j;
    float normal[3];
    float gap;  ///< below 0 [m]
};

}  // namespace interphase::hard_sphere
