// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "base/vector.hpp"

namespace interphase::contacts {

/// A `State` for each contact of each particle while it lasts; each of two spheres has its own. Particles go by their
/// index in LIGGGHTS, which may reorder and exchange them between two steps.
///
/// A contact with a wall is known by the wall and by its direction, so that a sphere that slides from one triangle of a
/// mesh to the next keeps what it knows, and one in a corner keeps its sides apart.
template <class State>
class ContactMemory {
    static_assert(std::is_trivially_copyable_v<State>,
                  "the state of a contact travels between ranks as plain bytes: "
                  "give it numbers and arrays of numbers, no pointers");

public:
    using Partner = std::int64_t;  ///< above 0: a sphere's id, below 0: a wall

    /// The state of a contact, State{} where it has just begun. Belongs to the caller until the next call.
    State& recall(int particle, Partner partner, const Vector& normal)
    {
        std::vector<Entry>& entries = of_[at(particle)].entries;
        Entry* found = nullptr;
        double nearest = partner > 0 ? -2 : least_alike;
        for (Entry& entry : entries) {
            if (entry.partner != partner || entry.touched) continue;
            const double alike = to_vector(entry.normal).dot(normal);
            if (alike < nearest) continue;
            nearest = alike;
            found = &entry;
        }
        if (!found) {
            entries.emplace_back();
            found = &entries.back();
            found->partner = partner;
        }
        found->touched = 1;
        set(found->normal, normal);
        return found->state;
    }

    /// After all contacts of a step: those that were not recalled have ended. Returns the most numbers that a particle
    /// packs. `ids`: of the particles [n].
    int end_step(const int* ids, int n)
    {
        std::size_t most = 0;
        for (int i = 0; i < n; ++i) {
            Particle& particle = of_[at(i)];
            std::size_t kept = 0;
            for (const Entry& entry : particle.entries)
                if (entry.touched) {
                    particle.entries[kept] = entry;
                    particle.entries[kept++].touched = 0;
                }
            particle.entries.resize(kept);
            particle.id = ids[i];
            most = std::max(most, kept);
        }
        return static_cast<int>(head + most * numbers);
    }

    /// The particle's id when its contacts were remembered; 0 where it has none.
    int id(int particle) const { return of_[at(particle)].entries.empty() ? 0 : of_[at(particle)].id; }

    /// Where ids have been given anew: `now` has the new one under the old one; contacts with those who are not in it
    /// end.
    void rename(const std::unordered_map<int, int>& now, int n)
    {
        for (int i = 0; i < n; ++i)
            for (Entry& entry : of_[at(i)].entries) {
                if (entry.partner < 0) continue;
                const auto found = now.find(static_cast<int>(entry.partner));
                entry.partner = found == now.end() ? nobody : found->second;
            }
    }

    void grow(int particles) { of_.resize(at(particles)); }
    void copy(int from, int to)
    {
        if (from != to) of_[at(to)] = of_[at(from)];
    }
    void forget(int particle) { of_[at(particle)].entries.clear(); }

    /// As plain numbers; return how many were written or read.
    int pack(int particle, double* buffer) const
    {
        const Particle& packed = of_[at(particle)];
        buffer[0] = static_cast<double>(packed.entries.size());
        buffer[1] = packed.id;
        if (!packed.entries.empty())
            std::memcpy(buffer + head, packed.entries.data(), packed.entries.size() * sizeof(Entry));
        return size(particle);
    }
    int unpack(int particle, const double* buffer)
    {
        Particle& unpacked = of_[at(particle)];
        unpacked.entries.resize(static_cast<std::size_t>(buffer[0]));
        unpacked.id = static_cast<int>(buffer[1]);
        if (!unpacked.entries.empty())
            std::memcpy(static_cast<void*>(unpacked.entries.data()), buffer + head,
                        unpacked.entries.size() * sizeof(Entry));
        return size(particle);
    }
    int size(int particle) const { return static_cast<int>(head + of_[at(particle)].entries.size() * numbers); }

private:
    static constexpr double least_alike =
        0.5;  ///< cosine: a wall that has turned by more than 60 degrees is another one
    static constexpr Partner nobody = 0;

    struct alignas(double) Entry {
        Partner partner = nobody;
        double normal[3] = {0, 0, 0};  ///< of the last step
        double touched = 0;
        State state{};
    };
    static_assert(sizeof(Entry) % sizeof(double) == 0);
    static constexpr std::size_t numbers = sizeof(Entry) / sizeof(double), head = 2;

    struct Particle {
        int id = 0;
        std::vector<Entry> entries;
    };

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    std::vector<Particle> of_;
};

}  // namespace interphase::contacts
