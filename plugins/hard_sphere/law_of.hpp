// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <iterator>
#include <utility>
#include <vector>

#include "hard_sphere/any_law.hpp"
#include "hard_sphere/lanes.hpp"

namespace interphase::hard_sphere {

/// Which of the functions that it may leave out a law has.
template <class Law, class = void>
struct HasTangentialRestitution : std::false_type {};
template <class Law, class = void>
struct HasFriction : std::false_type {};

#define INTERPHASE_LAW_MAY_HAVE(Trait, function)                                                                   \
    template <class Law>                                                                                           \
    struct Trait<Law, std::void_t<decltype(Law::function(std::declval<typename Law::template Materials<double>>(), \
                                                         std::declval<Meeting<double>>()))>> : std::true_type {};
INTERPHASE_LAW_MAY_HAVE(HasTangentialRestitution, tangential_restitution)
INTERPHASE_LAW_MAY_HAVE(HasFriction, friction)
#undef INTERPHASE_LAW_MAY_HAVE

/// The law as the solver asks it, compiled into loops over contacts.
template <class Law>
class LawOf final : public AnyLaw {
    template <class D>
    using Of = typename Law::template Materials<D>;
    static constexpr int property_count = std::size(Law::properties);
    static_assert(sizeof(Of<double>) == property_count * sizeof(double),
                  "Materials of a law has one number for each of its properties");

public:
    const std::vector<Property>& properties() const override
    {
        static const std::vector<Property> all(std::begin(Law::properties), std::end(Law::properties));
        return all;
    }

    void respond(const Bodies& bodies, Contact* first, const Contact* last) const override
    {
        for (Contact* contact = first; contact != last; ++contact) {
            const auto i = static_cast<std::size_t>(contact->i), j = static_cast<std::size_t>(contact->j);
            const double r_i = bodies.path[i].place.radius;
            const double r_j = contact->key < 0 ? 0 : bodies.path[j].place.radius;
            const Meeting<double> meeting{contact->impact ? contact->speed : 0,
                                          1 / (bodies.body[i].inverse_mass + bodies.body[j].inverse_mass),
                                          effective_radius(r_i, r_j)};
            const auto between = load<1>(materials.numbers(), &contact->materials);
            contact->response = {Law::restitution(between, meeting), tangential_restitution(between, meeting),
                                 friction(between, meeting)};
        }
    }

    void respond(ContactBatch* batches, const BatchNotes* notes, std::size_t count, int width) const override
    {
        const auto all = width == 8 ? by_eight : width == 4 ? by_four : by_one;
        all(materials.numbers(), batches, notes, count);
    }

private:
    template <class D>
    INTERPHASE_INLINE static D tangential_restitution(const Of<D>& between, const Meeting<D>& meeting)
    {
        if constexpr (HasTangentialRestitution<Law>::value)
            return Law::tangential_restitution(between, meeting);
        else
            return D{};
    }

    template <class D>
    INTERPHASE_INLINE static D friction(const Of<D>& between, const Meeting<D>& meeting)
    {
        if constexpr (HasFriction<Law>::value)
            return Law::friction(between, meeting);
        else
            return D{};
    }

    template <class D>
    INTERPHASE_INLINE static D effective_radius(const D& a, const D& b)
    {
        return if_positive(b, D(a * b / (a + b + tiny)), a);
    }

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

    /// The contacts of a batch from `first` on.
    template <int width>
    INTERPHASE_INLINE static void respond(const double* numbers, ContactBatch& batch, const BatchNotes& notes,
                                          int first)
    {
        using D = Doubles<width>;
        const D zero{}, one = zero + 1, mass = wide<width>(batch.mass + first);
        const D radius = effective_radius<D>(wide<width>(batch.arm_i + first), wide<width>(batch.arm_j + first));
        // empty lanes have no mass, and a law may divide by it
        const Meeting<D> meeting{wide<width>(notes.speed + first), if_positive(mass, mass, one),
                                 if_positive(mass, radius, one)};
        const auto between = load<width>(numbers, notes.materials + first);
        const D bounce = 1 + Law::restitution(between, meeting);
        store(batch.bounce + first, if_positive(meeting.speed, bounce, zero));
        store(batch.tangential_bounce + first, D(1 + tangential_restitution(between, meeting)));
        store(batch.friction + first, friction(between, meeting));
    }

    template <int width>
    INTERPHASE_INLINE static void each(const double* numbers, ContactBatch* batches, const BatchNotes* notes,
                                       std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k)
            for (int first = 0; first < lanes; first += width)
                respond<width>(numbers, batches[k], notes[k], first);
    }

    // A law's functions have to become part of these, whatever the author said of inlining: called from outside, they
    // would take and return vectors in the registers of another processor.
    INTERPHASE_WIDEST INTERPHASE_FLATTEN static void by_eight(const double* numbers, ContactBatch* batches,
                                                              const BatchNotes* notes, std::size_t count)
    {
        each<8>(numbers, batches, notes, count);
    }

    INTERPHASE_CLONES INTERPHASE_FLATTEN static void by_four(const double* numbers, ContactBatch* batches,
                                                             const BatchNotes* notes, std::size_t count)
    {
        each<4>(numbers, batches, notes, count);
    }

    static void by_one(const double* numbers, ContactBatch* batches, const BatchNotes* notes, std::size_t count)
    {
        each<1>(numbers, batches, notes, count);
    }
};

}  // namespace interphase::hard_sphere
