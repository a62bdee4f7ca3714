// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "hard_sphere/batch_builder.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/contact.hpp"
#include "hard_sphere/impulse_memory.hpp"
#include "hard_sphere/pair_search.hpp"

namespace interphase::hard_sphere {

/// Resolves the contacts of one step. A pair that touches nothing else is a binary collision, resolved exactly, at the
/// moment at which it touches. Contacts that share bodies are solved for together (non-smooth contact dynamics: Jean,
/// CMAME 177 (1999) 235; Radjai and Richefeu, Mech. Mater. 41 (2009) 715), from the impulses of the last step.
class ContactSolver {
public:
    /// Counts what touches each body. Of ghosts, the owners know the count.
    std::vector<int>& count_touches(const Bodies& bodies, const PairSearch& pairs, const std::vector<Contact>& walls);

    /// Counts which bodies of clusters this rank is going to change in its passes: 1 or 0.
    std::vector<int>& count_users(const Bodies& bodies, const PairSearch& pairs, const std::vector<Contact>& walls);

    /// Resolves binary collisions and makes the others ready. A pair across two ranks is resolved by the one that owns
    /// the lower id. `memory` goes by Label::atom. `passes`, at least 2: how many will follow.
    void start(Bodies& bodies, const PairSearch& pairs, const std::vector<Contact>& walls, const Materials& materials,
               const StepLimits& limits, const ImpulseMemory& memory, int passes);

    /// One pass over the contacts of clusters. With ghosts, the changes of their velocities have to be collected, and
    /// shared, after each. Passes go to and fro through memory; `ends_forward`: the last one goes forward.
    void pass(std::vector<Body>& bodies, bool ends_forward);

    /// Pushes overlapping spheres apart by `share` of what is left of their overlap at the end of the step, without
    /// touching their velocities: no kinetic energy comes from it. `tolerated`: overlap that may stay [m].
    void separate(const Bodies& bodies, double share, double tolerated);

    /// Lets bodies that only an impact has changed move as they came until the moment of touching, as in a binary
    /// collision.
    void delay_impacts(const Bodies& bodies);

    /// Puts down the impulses of clusters for the next step.
    void remember(const Bodies& bodies, ImpulseMemory& memory);

    /// What moves a sphere in this step besides its velocity [m, bodies].
    const std::vector<Vector>& shift() const { return shift_; }
    void add_shift(std::size_t body, const Vector& shift) { shift_[body] += shift; }

    long binary_collisions() const { return binary_; }
    std::size_t cluster_contacts() const { return cluster_contacts_; }

private:
    struct Owner {
        int body = -1;  ///< that remembers the impulse
        int partner;
        float sign;  ///< +1: the impulse acts on the partner
    };
    struct Overlap {
        int i, j;
        Vector normal;
        double gap;
    };

    bool takes_part(const Bodies& bodies, const Pair& pair) const;
    bool has_one_touch(const Bodies& bodies, int body) const;
    bool in_cluster(const Bodies& bodies, int body) const;
    void resolve(Bodies& bodies, const Contact& contact, const ImpulseMemory& memory);
    void resolve_binary(Bodies& bodies, const Contact& contact);
    void add_impact(const Bodies& bodies, const Contact& contact, const Owner& owner);
    void add_to_cluster(Bodies& bodies, const Contact& contact, const ImpulseMemory& memory);
    void add_resting(Bodies& bodies, const Contact& contact, const Owner& owner, const Remembered* last);
    template <class Batch>
    void fill(Batch& batch, int lane, const Bodies& bodies, const Contact& contact);

    double step_ = 0;
    int passes_ = 0, all_passes_ = 0;
    long binary_ = 0;
    std::size_t cluster_contacts_ = 0;
    BatchBuilder impact_places_, resting_places_;
    std::vector<ImpactBatch> impacts_;  ///< grows only, as the next two: what is in use the builders know
    std::vector<ContactBatch> resting_;
    std::vector<std::array<Owner, lanes>> owners_, impact_owners_;
    std::vector<Overlap> overlaps_;
    std::vector<Vector> shift_;
    std::vector<int> touches_, users_;                   ///< of each body [bodies]
    std::vector<int> pushes_;                            ///< contacts that gave the body an impulse [bodies]
    std::vector<std::array<float, lanes>> touch_times_;  ///< of impacts [s]
    std::vector<int> counts_, particles_;
};

}  // namespace interphase::hard_sphere
