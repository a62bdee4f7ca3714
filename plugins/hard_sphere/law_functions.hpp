// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <utility>

#include "hard_sphere/law.hpp"

namespace interphase::hard_sphere {

/// A law's functions, those that it leaves out, too.
template <class Law>
struct LawFunctions {
    template <class D>
    using Materials = typename Law::template Materials<D>;

private:
    /// Whether a law has a state, and what it is; without one it is empty.
    template <class T, class = void>
    struct StateOf {
        static constexpr bool there = false;
        template <class D>
        struct Type {};
    };
    template <class T>
    struct StateOf<T, std::void_t<typename T::template State<double>>> {
        static constexpr bool there = true;
        template <class D>
        using Type = typename T::template State<D>;
    };

public:
    static constexpr bool has_state = StateOf<Law>::there;
    template <class D>
    using State = typename StateOf<Law>::template Type<D>;

private:
#define INTERPHASE_LAW_MAY_HAVE(Trait, ...) \
    template <class T, class = void>        \
    struct Trait : std::false_type {};      \
    template <class T>                      \
    struct Trait<T, std::void_t<decltype(__VA_ARGS__)>> : std::true_type {}

    static const Materials<double>& materials();
    static const Meeting<double>& meeting();
    static const State<double>& state();
    INTERPHASE_LAW_MAY_HAVE(HasTangentialRestitution, T::tangential_restitution(materials(), meeting()));
    INTERPHASE_LAW_MAY_HAVE(HasTangentialRestitutionByState,
                            T::tangential_restitution(materials(), meeting(), state()));
    INTERPHASE_LAW_MAY_HAVE(HasFriction, T::friction(materials(), meeting()));
    INTERPHASE_LAW_MAY_HAVE(HasFrictionByState, T::friction(materials(), meeting(), state()));
    INTERPHASE_LAW_MAY_HAVE(HasRollingFriction, T::rolling_friction(materials(), meeting()));
    INTERPHASE_LAW_MAY_HAVE(HasRollingFrictionByState, T::rolling_friction(materials(), meeting(), state()));
    INTERPHASE_LAW_MAY_HAVE(HasRestitutionByState, T::restitution(materials(), meeting(), state()));
    INTERPHASE_LAW_MAY_HAVE(HasAttraction, T::attraction(materials(), std::declval<Separation>()));
    INTERPHASE_LAW_MAY_HAVE(HasRange, T::range(materials()));
#undef INTERPHASE_LAW_MAY_HAVE

public:
    static constexpr bool rolls = HasRollingFriction<Law>::value || HasRollingFrictionByState<Law>::value;
    static constexpr bool attracts = HasAttraction<Law>::value;
    static_assert(HasRange<Law>::value == attracts,
                  "a law with `attraction` has `range`, which says how far it reaches, and one without has none");

    template <class D>
    INTERPHASE_INLINE static D restitution(const Materials<D>& between, const Meeting<D>& how, const State<D>& now)
    {
        if constexpr (HasRestitutionByState<Law>::value)
            return Law::restitution(between, how, now);
        else
            return Law::restitution(between, how);
    }
    template <class D>
    INTERPHASE_INLINE static D tangential_restitution(const Materials<D>& between, const Meeting<D>& how,
                                                      const State<D>& now)
    {
        if constexpr (HasTangentialRestitutionByState<Law>::value)
            return Law::tangential_restitution(between, how, now);
        else if constexpr (HasTangentialRestitution<Law>::value)
            return Law::tangential_restitution(between, how);
        else
            return D{};
    }
    template <class D>
    INTERPHASE_INLINE static D friction(const Materials<D>& between, const Meeting<D>& how, const State<D>& now)
    {
        if constexpr (HasFrictionByState<Law>::value)
            return Law::friction(between, how, now);
        else if constexpr (HasFriction<Law>::value)
            return Law::friction(between, how);
        else
            return D{};
    }
    template <class D>
    INTERPHASE_INLINE static D rolling_friction(const Materials<D>& between, const Meeting<D>& how, const State<D>& now)
    {
        if constexpr (HasRollingFrictionByState<Law>::value)
            return Law::rolling_friction(between, how, now);
        else if constexpr (HasRollingFriction<Law>::value)
            return Law::rolling_friction(between, how);
        else
            return D{};
    }
    template <class D>
    INTERPHASE_INLINE static State<D> next(const State<D>& last, const Materials<D>& between, const Meeting<D>& how,
                                           double step)
    {
        if constexpr (has_state)
            return Law::next(last, between, how, step);
        else
            return last;
    }
    static double attraction(const Materials<double>& between, const Separation& separation)
    {
        if constexpr (attracts)
            return Law::attraction(between, separation);
        else
            return 0;
    }
    static double range(const Materials<double>& between)
    {
        if constexpr (attracts)
            return Law::range(between);
        else
            return 0;
    }
};

}  // namespace interphase::hard_sphere
