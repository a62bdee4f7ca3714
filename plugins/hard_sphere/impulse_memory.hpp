// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace interphase::hard_sphere {

/// An impulse that a contact passed on in the last step, remembered by one of its bodies.
struct Remembered {
    int partner;       ///< id of the other body, or the key (below 0) of a wall
    float impulse[3];  ///< on the partner [kg m/s]
    int next = -1;     ///< the particle's next entry; below 0: none
};

/// What each particle remembers of its contacts, for the next step to start from. Particles go by their index in the
/// particle engine, which may reorder and exchange them between two steps.
class ImpulseMemory {
public:
    /// The particle's first entry; below 0: none.
    int first(int particle) const { return first_[static_cast<std::size_t>(particle)]; }

    /// In the list that starts with the entry `first`; null where the particle did not touch that partner.
    const Remembered* find(int first, int partner) const
    {
        for (int k = first; k >= 0; k = entries_[static_cast<std::size_t>(k)].next)
            if (entries_[static_cast<std::size_t>(k)].partner == partner) return &entries_[static_cast<std::size_t>(k)];
        return nullptr;
    }

    /// Tells the processor that find() will be asked.
    void fetch(int first) const { __builtin_prefetch(entries_.data() + (first < 0 ? 0 : first)); }

    /// Of all particles.
    void forget();
    void add(int particle, Remembered entry)
    {
        int& first = first_[static_cast<std::size_t>(particle)];
        entry.next = first;
        first = static_cast<int>(entries_.size());
        entries_.push_back(entry);
    }

    void grow(std::size_t particles) { first_.resize(particles, -1); }
    void copy(int from, int to) { first_[static_cast<std::size_t>(to)] = first_[static_cast<std::size_t>(from)]; }
    void forget(int particle) { first_[static_cast<std::size_t>(particle)] = -1; }

    /// As plain numbers; return how many were written or read.
    int pack(int particle, double* buffer) const;
    int unpack(int particle, const double* buffer);

private:
    std::vector<int> first_;
    std::vector<Remembered> entries_;
};

}  // namespace interphase::hard_sphere
