// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hard_sphere/any_law.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/cluster.hpp"
#include "hard_sphere/contact.hpp"
#include "hard_sphere/impulse_memory.hpp"
#include "hard_sphere/pair_search.hpp"
#include "hard_sphere/sweep.hpp"

namespace interphase::hard_sphere {

/// Resolves the contacts of one step. A pair that touches nothing else is a binary collision, resolved exactly, at the
/// moment at which it touches. Contacts that share bodies are solved for together (non-smooth contact dynamics: Jean,
/// CMAME 177 (1999) 235; Radjai and Richefeu, Mech. Mater. 41 (2009) 715), from the impulses of the last step.
class ContactSolver {
public:
    /// Counts what touches each body, 2 standing for more. Of ghosts, the owners know the count.
    std::vector<std::uint8_t>& count_touches(const PairSearch& pairs, const std::vector<Contact>& walls);

    /// Tells from these counts which bodies are in clusters.
    void classify(const Bodies& bodies);

    /// Counts which bodies of clusters this rank is going to change in its passes: 1 or 0.
    std::vector<std::uint8_t>& count_users(const Bodies& bodies, const PairSearch& pairs,
                                           const std::vector<Contact>& walls);

    /// Resolves binary collisions and makes the others ready. A pair across two ranks is resolved by the one that owns
    /// the lower id. `passes`, at least 2: how many will follow.
    void start(Bodies& bodies, const PairSearch& pairs, std::vector<Contact>& walls, const AnyLaw& law,
               const StepLimits& limits, const ImpulseMemory& memory, int passes);

    /// One pass over the contacts of clusters. With ghosts, the changes of their velocities have to be collected, and
    /// shared, after each. Passes go to and fro through memory; `ends_forward`: the last one goes forward.
    void pass(std::vector<Body>& bodies, bool ends_forward);

    /// Pushes overlapping spheres apart by `share` of what is left of their overlap at the end of the step, without
    /// touching their velocities: no kinetic energy comes from it. `tolerated`: overlap that may stay [m]. Returns the
    /// deepest overlap of spheres at the start of the step [m].
    double separate(const Bodies& bodies, double share, double tolerated);

    /// Puts down the impulses of clusters for the next step; `particle[b]` is the body's index in `memory`. Bodies that
    /// only an impact has changed move as they came until the moment of touching, as in a binary collision.
    void finish(const Bodies& bodies, const std::vector<int>& particle, ImpulseMemory& memory);

    /// A body's push on a wall in this step.
    struct WallPush {
        int body, key;   ///< Contact::key
        Vector point;    ///< of contact, from the body's centre [m]
        Vector impulse;  ///< on the wall [kg m/s]
    };
    /// All of them, once the passes are over.
    std::vector<WallPush> wall_pushes() const;

    /// What moves a sphere in this step besides its velocity [m, bodies].
    const std::vector<Vector>& shift() const { return shift_; }
    void add_shift(std::size_t body, const Vector& shift) { shift_[body] += shift; }

    long binary_collisions() const { return binary_; }
    std::size_t cluster_contacts() const { return cluster_contacts_; }

private:
    struct Impact {
        const ContactBatch* batch;
        int lane;
        float touch_time;
    };

    /// Of a body; a fixed one may be in a cluster and touch one body only at the same time.
    enum Role : std::uint8_t { ghost_or_fixed = 1, touches_one = 2, in_cluster = 4 };

    bool has(Role role, int body) const { return (roles_[static_cast<std::size_t>(body)] & role) != 0; }
    bool both_have(Role role, const Pair& pair) const { return has(role, pair.i) & has(role, pair.j); }
    bool takes_part(const Bodies& bodies, const Pair& pair) const;
    void add_pairs(Bodies& bodies, const PairSearch& pairs, const AnyLaw& law, const StepLimits& limits,
                   const ImpulseMemory& memory);
    void resolve_binary(Bodies& bodies, const Pair* first, const Pair* last, const AnyLaw& law,
                        const StepLimits& limits, const ImpulseMemory& memory);

    /// Which of the two bodies remembers their contact, and under what.
    struct Keeper {
        int owner, partner;
    };
    static Keeper keeper(const Bodies& bodies, int i, int j, int key);

    /// Fills in what the contacts' states were in the last step.
    void recall(const Bodies& bodies, std::vector<Contact>& contacts, const AnyLaw& law,
                const ImpulseMemory& memory) const;
    void resolve_binary(Bodies& bodies, const Contact& contact);
    BatchPlace add(Cluster& cluster, const Bodies& bodies, int i, int j, int key, int materials,
                   const ImpulseMemory& memory);
    void add_wall(const Bodies& bodies, const Contact& contact, const ImpulseMemory& memory);
    void finish(const Cluster& cluster, const std::vector<int>& particle, ImpulseMemory& memory);
    void delay_impacts(const Bodies& bodies);

    double step_ = 0;
    int passes_ = 0, all_passes_ = 0;
    long binary_ = 0;
    std::size_t cluster_contacts_ = 0;
    Cluster walls_, spheres_;
    std::vector<Overlap> overlaps_;
    std::vector<Vector> shift_;
    std::vector<std::uint8_t> touches_, roles_, users_;  ///< of each body; small, for these are asked at random
    std::vector<std::uint8_t> pushes_;                   ///< contacts that gave the body an impulse, at most 2
    std::vector<Pair> cluster_pairs_, binary_pairs_;     ///< of spheres, those that take part
    std::vector<Contact> binary_contacts_;
    struct BinaryState {
        Keeper keeper;
        std::array<double, most_states> state;
    };
    std::vector<WallPush> binary_pushes_;     ///< on walls
    std::vector<BinaryState> binary_states_;  ///< of those that last
    std::vector<Impact> impacts_;
};

}  // namespace interphase::hard_sphere
