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
    template <class T, class = void>
    struct HasTangentialRestitution : std::false_type {};
    template <class T>
    struct HasTangentialRestitution<T, std::void_t<decltype(T::tangential_restitution(
                                           std::declval<Materials<double>>(), std::declval<Meeting<double>>()))>>
        : std::true_type {};
    template <class T, class = void>
    struct HasFriction : std::false_type {};
    template <class T>
    struct HasFriction<
        T, std::void_t<decltype(T::friction(std::declval<Materials<double>>(), std::declval<Meeting<double>>()))>>
        : std::true_type {};
    template <class T, class = void>
    struct HasRollingFriction : std::false_type {};
    template <class T>
    struct HasRollingFriction<T, std::void_t<decltype(T::rolling_friction(std::declval<Materials<double>>(),
                                                                          std::declval<Meeting<double>>()))>>
        : std::true_type {};
    template <class T, class = void>
    struct HasAttraction : std::false_type {};
    template <class T>
    struct HasAttraction<
        T, std::void_t<decltype(T::attraction(std::declval<Materials<double>>(), std::declval<Separation>()))>>
        : std::true_type {};
    template <class T, class = void>
    struct HasRange : std::false_type {};
    template <class T>
    struct HasRange<T, std::void_t<decltype(T::range(std::declval<Materials<double>>()))>> : std::true_type {};

public:
    static constexpr bool rolls = HasRollingFriction<Law>::value;
    static constexpr bool attracts = HasAttraction<Law>::value;
    static_assert(HasRange<Law>::value == attracts,
                  "a law with `attraction` has `range`, which says how far it reaches, and one without has none");

    template <class D>
    INTERPHASE_INLINE static D restitution(const Materials<D>& materials, const Meeting<D>& meeting)
    {
        return Law::restitution(materials, meeting);
    }
    template <class D>
    INTERPHASE_INLINE static D tangential_restitution(const Materials<D>& materials, const Meeting<D>& meeting)
    {
        if constexpr (HasTangentialRestitution<Law>::value)
            return Law::tangential_restitution(materials, meeting);
        else
            return D{};
    }
    template <class D>
    INTERPHASE_INLINE static D friction(const Materials<D>& materials, const Meeting<D>& meeting)
    {
        if constexpr (HasFriction<Law>::value)
            return Law::friction(materials, meeting);
        else
            return D{};
    }
    template <class D>
    INTERPHASE_INLINE static D rolling_friction(const Materials<D>& materials, const Meeting<D>& meeting)
    {
        if constexpr (rolls)
            return Law::rolling_friction(materials, meeting);
        else
            return D{};
    }
    static double attraction(const Materials<double>& materials, const Separation& separation)
    {
        if constexpr (attracts)
            return Law::attraction(materials, separation);
        else
            return 0;
    }
    static double range(const Materials<double>& materials)
    {
        if constexpr (attracts)
            return Law::range(materials);
        else
            return 0;
    }
};

}  // namespace interphase::hard_sphere
