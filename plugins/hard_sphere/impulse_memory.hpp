// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace interphase::hard_sphere {

/// An impulse that a contact passed on in the last step, remembered by one of its bodies.
struct Remembered {
    int partner = 0;               ///< id (above 0) of the other body, or the key (below 0) of a wall
    float impulse[3] = {0, 0, 0};  ///< on the partner [kg m/s]
    int next = 0;                  ///< the particle's next entry; 0: none
};

/// What each particle remembers of its contacts, for the next step to start from. Particles go by their index in the
/// particle engine, which may reorder and exchange them between two steps.
class ImpulseMemory {
public:
    /// `more`: numbers of each entry beside its impulse.
    explicit ImpulseMemory(std::size_t more = 0) : more_(more), numbers_(more, 0.0f) {}

    /// The particle's first entry; 0: none.
    int first(int particle) const { return first_[static_cast<std::size_t>(particle)]; }

    /// The entry under `partner` in the list that starts with `first`; 0 where the particle did not touch it.
    int find(int first, int partner) const
    {
        int k = first;
        while (k != 0 && entry(k).partner != partner)
            k = entry(k).next;
        return k;
    }

    /// Entry 0 has no partner and no impulse.
    const Remembered& entry(int k) const { return entries_[static_cast<std::size_t>(k)]; }

    /// What entry k has beside, of entry 0 zeros.
    const float* more(int k) const { return numbers_.data() + static_cast<std::size_t>(k) * more_; }

    /// Tells the processor that find() will be asked.
    void fetch(int first) const { __builtin_prefetch(entries_.data() + first); }

    /// Of all particles.
    void forget();

    void add(int particle, Remembered entry)
    {
        int& first = first_[static_cast<std::size_t>(particle)];
        entry.next = first;
        first = static_cast<int>(entries_.size());
        entries_.push_back(entry);
    }

    /// Where to write what the entry that was just added has beside: zeros so far.
    float* add_more()
    {
        numbers_.resize(entries_.size() * more_, 0.0f);
        return numbers_.data() + numbers_.size() - more_;
    }

    void grow(std::size_t particles) { first_.resize(particles, 0); }
    void copy(int from, int to) { first_[static_cast<std::size_t>(to)] = first_[static_cast<std::size_t>(from)]; }
    void forget(int particle) { first_[static_cast<std::size_t>(particle)] = 0; }

    /// As plain numbers; return how many were written or read. `room`: how many may be written, at least 1; `left_out`:
    /// entries for which that did not do.
    int pack(int particle, double* buffer, int room, int& left_out) const;
    int unpack(int particle, const double* buffer);
    /// How many pack() needs.
    int numbers(int particle) const;

private:
    std::size_t more_;
    std::vector<int> first_;
    std::vector<Remembered> entries_{1};  ///< the first one stands for none
    std::vector<float> numbers_;          ///< [entries x more]
};

}  // namespace interphase::hard_sphere
