// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace interphase::hard_sphere {

/// An impulse that a contact passed on in the last step, remembered by one of its bodies.
struct Remembered {
    int partner;       ///< id of the other body, or the key (below 0) of a wall
    float impulse[3];  ///< on the partner [kg m/s]
};

/// What each particle remembers of its contacts, for the next step to start from. Particles go by their index in the
/// particle engine, which may reorder and exchange them between two steps.
class ImpulseMemory {
public:
    /// Null where the particle did not touch that partner.
    const Remembered* find(int particle, int partner) const;

    /// Starts anew with the given number of entries for each of some particles.
    void reset(const std::vector<int>& particles, const std::vector<int>& counts);
    void add(int particle, const Remembered& entry);

    void grow(std::size_t particles) { spans_.resize(particles); }
    void copy(int from, int to) { spans_[static_cast<std::size_t>(to)] = spans_[static_cast<std::size_t>(from)]; }
    void forget(int particle) { spans_[static_cast<std::size_t>(particle)] = {}; }

    /// As plain numbers; return how many were written or read.
    int pack(int particle, double* buffer) const;
    int unpack(int particle, const double* buffer);

private:
    struct Span {
        int first = 0, count = 0;
    };
    std::vector<Span> spans_;
    std::vector<Remembered> entries_;
};

}  // namespace interphase::hard_sphere
