// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "hard_sphere/any_law.hpp"
#include "hard_sphere/lanes.hpp"
#include "hard_sphere/law_check.hpp"
#include "hard_sphere/law_functions.hpp"

namespace interphase::hard_sphere {

/// The law as the solver asks it, compiled into loops over contacts.
template <class Law>
class LawOf final : public AnyLaw {
    using F = LawFunctions<Law>;
    template <class D>
    using Of = typename Law::template Materials<D>;
    static constexpr int property_count = std::size(Law::properties);
    template <class D>
    using State = typename F::template State<D>;
    static constexpr int states = F::has_state ? sizeof(State<double>) / sizeof(double) : 0;
    static_assert(states <= most_states, "a State of a law has at most most_states numbers");
    static_assert(sizeof(Of<double>) == property_count * sizeof(double),
                  "Materials of a law has one number for each of its properties");

public:
    const std::vector<MaterialProperty>& properties() const override
    {
        static const std::vector<MaterialProperty> all(std::begin(Law::properties), std::end(Law::properties));
        return all;
    }

    void respond(const Bodies& bodies, Contact* first, const Contact* last, double step) const override
    {
        for (Contact* contact = first; contact != last; ++contact) {
            const auto i = static_cast<std::size_t>(contact->i), j = static_cast<std::size_t>(contact->j);
            const double r_i = bodies.path[i].place.radius;
            const double r_j = contact->key < 0 ? 0 : bodies.path[j].place.radius;
            const Meeting<double> meeting{contact->impact ? contact->speed : 0,
                                          1 / (bodies.body[i].inverse_mass + bodies.body[j].inverse_mass),
                                          effective_radius(r_i, r_j)};
            const auto between = load<1>(materials.numbers(), &contact->materials);
            State<double> state;
            if constexpr (F::has_state) std::memcpy(&state, contact->state.data(), sizeof state);
            state = F::next(state, between, meeting, step);
            if constexpr (F::has_state) std::memcpy(contact->state.data(), &state, sizeof state);
            contact->response = {
                F::restitution(between, meeting, state), F::tangential_restitution(between, meeting, state),
                F::friction(between, meeting, state), meeting.radius * F::rolling_friction(between, meeting, state)};
        }
    }

    void respond(Cluster& cluster, std::size_t first, std::size_t last, double step, int width) const override
    {
        const auto all = width == 8 ? by_eight : width == 4 ? by_four : by_one;
        all(materials.numbers(), cluster, first, last, step);
    }

    int state_count() const override { return states; }

    bool rolls() const override { return F::rolls; }

    double longest_range() const override
    {
        double longest = 0;
        for (int pair = 0; pair < materials.types() * materials.types(); ++pair)
            longest = std::max(longest, F::range(load<1>(materials.numbers(), &pair)));
        return longest;
    }

    void attract(std::vector<Attraction>& attractions) const override
    {
        for (Attraction& pair : attractions) {
            const auto between = load<1>(materials.numbers(), &pair.materials);
            pair.force = pair.gap < F::range(between) ? F::attraction(between, {pair.gap, pair.radius}) : 0;
        }
    }

    std::string complaint(const Sizes& sizes) const override
    {
        for (int a = 0; a < materials.types(); ++a)
            for (int b = a; b < materials.types(); ++b) {
                const int pair = materials.between(a, b);
                const std::string wrong = complaint_of<Law>(load<1>(materials.numbers(), &pair), sizes);
                if (!wrong.empty())
                    return "between types " + std::to_string(a + 1) + " and " + std::to_string(b + 1) +
                           " the law answers a " + wrong;
            }
        return "";
    }

private:
    /// What materials are of the contacts whose pairs of types are `pairs`.
    template <int width>
    INTERPHASE_INLINE static Of<Doubles<width>> load(const double* numbers, const int* pairs)
    {
        using D = Doubles<width>;
        D values[property_count];
        for (int p = 0; p < property_count; ++p) {
            if constexpr (width == 1)
                values[p] = numbers[*pairs * property_count + p];
            else
                for (int k = 0; k < width; ++k)
                    values[p][k] = numbers[pairs[k] * property_count + p];
        }
        Of<D> between;
        std::memcpy(&between, values, sizeof between);
        return between;
    }

    template <int width>
    INTERPHASE_INLINE static State<Doubles<width>> renew(Cluster& cluster, std::size_t k, int lane,
                                                         const Of<Doubles<width>>& between,
                                                         const Meeting<Doubles<width>>& meeting, double step)
    {
        using D = Doubles<width>;
        State<D> state;
        if constexpr (F::has_state) {
            D values[states];
            for (int s = 0; s < states; ++s)
                values[s] = wide<width>(cluster.state(k, s) + lane);
            std::memcpy(&state, values, sizeof state);
            state = F::next(state, between, meeting, step);
            std::memcpy(values, &state, sizeof state);
            for (int s = 0; s < states; ++s)
                store(cluster.state(k, s) + lane, values[s]);
        }
        return state;
    }

    /// The contacts of batch `k` from `lane` on.
    template <int width>
    INTERPHASE_INLINE static void respond(const double* numbers, Cluster& cluster, std::size_t k, int lane, double step)
    {
        using D = Doubles<width>;
        ContactBatch& batch = cluster.batches[k];
        const BatchNotes& notes = cluster.notes[k];
        const D zero{}, one = zero + 1, mass = wide<width>(batch.mass + lane);
        const D radius = effective_radius<D>(wide<width>(batch.arm_i + lane), wide<width>(batch.arm_j + lane));
        // empty lanes have no mass, and a law may divide by it
        const Meeting<D> meeting{wide<width>(notes.speed + lane), if_positive(mass, mass, one),
                                 if_positive(mass, radius, one)};
        const auto between = load<width>(numbers, notes.materials + lane);
        const State<D> state = renew<width>(cluster, k, lane, between, meeting, step);
        const D bounce = 1 + F::restitution(between, meeting, state);
        store(batch.bounce + lane, if_positive(meeting.speed, bounce, zero));
        store(batch.tangential_bounce + lane, D(1 + F::tangential_restitution(between, meeting, state)));
        store(batch.friction + lane, F::friction(between, meeting, state));
        if constexpr (F::rolls)
            store(cluster.rolling[k].arm + lane, D(meeting.radius * F::rolling_friction(between, meeting, state)));
    }

    template <int width>
    INTERPHASE_INLINE static void each(const double* numbers, Cluster& cluster, std::size_t first, std::size_t last,
                                       double step)
    {
        for (std::size_t k = first; k < last; ++k)
            for (int lane = 0; lane < lanes; lane += width)
                respond<width>(numbers, cluster, k, lane, step);
    }

    // A law's functions have to become part of these, whatever the author said of inlining: called from outside, they
    // would take and return vectors in the registers of another processor.
    INTERPHASE_WIDEST INTERPHASE_FLATTEN static void by_eight(const double* numbers, Cluster& cluster,
                                                              std::size_t first, std::size_t last, double step)
    {
        each<8>(numbers, cluster, first, last, step);
    }

    INTERPHASE_CLONES INTERPHASE_FLATTEN static void by_four(const double* numbers, Cluster& cluster, std::size_t first,
                                                             std::size_t last, double step)
    {
        each<4>(numbers, cluster, first, last, step);
    }

    static void by_one(const double* numbers, Cluster& cluster, std::size_t first, std::size_t last, double step)
    {
        each<1>(numbers, cluster, first, last, step);
    }
};

}  // namespace interphase::hard_sphere
