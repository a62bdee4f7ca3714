// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "base/vector.hpp"
#include "hard_sphere/processor.hpp"

/// Numbers and three-vectors that formulas of contacts are written with: of one contact (width 1: `double` and
/// `Vector`), or of several side by side, in vectors of the compiler (width 4 or 8, as the processor takes them). The
/// latter stay within a translation unit. A width's own order of additions, and whether it divides or multiplies by an
/// inverse, stand here and nowhere else.
namespace interphase::hard_sphere {

template <int width>
struct Vectors {
    typedef double Doubles __attribute__((vector_size(8 * width)));
    typedef float Singles __attribute__((vector_size(4 * width)));
};
template <>
struct Vectors<1> {
    using Doubles = double;
    using Singles = float;
};
template <int width>
using Doubles = typename Vectors<width>::Doubles;
template <int width>
using Singles = typename Vectors<width>::Singles;

template <class D>
inline constexpr int width_of = sizeof(D) / sizeof(double);

template <class D>
struct Triple {
    D x, y, z;
};

template <class D>
struct ThreeOf {
    using Type = Triple<D>;
};
template <>
struct ThreeOf<double> {
    using Type = Vector;
};
/// A three-vector of each contact.
template <class D>
using Three = typename ThreeOf<D>::Type;

template <class D>
INTERPHASE_INLINE Triple<D> operator+(const Triple<D>& a, const Triple<D>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class D>
INTERPHASE_INLINE Triple<D> operator-(const Triple<D>& a, const Triple<D>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class D>
INTERPHASE_INLINE Triple<D> operator*(const D& s, const Triple<D>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

template <class D>
INTERPHASE_INLINE D dot(const Triple<D>& a, const Triple<D>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

INTERPHASE_INLINE double dot(const Vector& a, const Vector& b) { return a.dot(b); }

template <class D>
INTERPHASE_INLINE Triple<D> cross(const Triple<D>& a, const Triple<D>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

INTERPHASE_INLINE Vector cross(const Vector& a, const Vector& b) { return a.cross(b); }

/// `yes` where `value` is below zero, else `no`, by its sign. The compiler (gcc 12) takes comparisons of vectors apart,
/// number by number, once two of them meet.
template <class D>
INTERPHASE_INLINE D if_negative(const D& value, const D& yes, const D& no)
{
    using Bits = decltype(value < value);             // NOLINT(misc-redundant-expression): only its type
    const Bits negative = (Bits)(value + 0.0) >> 63;  // the sign of a zero does not count
    return (D)(((Bits)yes & negative) | ((Bits)no & ~negative));
}

INTERPHASE_INLINE double if_negative(double value, double yes, double no) { return value < 0 ? yes : no; }

template <class D>
INTERPHASE_INLINE D if_positive(const D& value, const D& yes, const D& no)
{
    return if_negative(D(-value), yes, no);
}

template <class D>
INTERPHASE_INLINE Triple<D> if_positive(const D& value, const Triple<D>& yes, const Triple<D>& no)
{
    return {if_positive(value, yes.x, no.x), if_positive(value, yes.y, no.y), if_positive(value, yes.z, no.z)};
}

INTERPHASE_INLINE Vector if_positive(double value, const Vector& yes, const Vector& no) { return value > 0 ? yes : no; }

template <class D>
INTERPHASE_INLINE D smaller(const D& a, const D& b)
{
    return a < b ? a : b;
}

template <class D>
INTERPHASE_INLINE D larger(const D& a, const D& b)
{
    return a > b ? a : b;
}

template <class D>
INTERPHASE_INLINE D square_root(const D& values)
{
    D roots;
    for (int k = 0; k < width_of<D>; ++k)
        roots[k] = std::sqrt(values[k]);
    return roots;
}

INTERPHASE_INLINE double square_root(double value) { return std::sqrt(value); }

/// values^exponent, of a zero or less 0.
template <class D>
INTERPHASE_INLINE D power(const D& values, double exponent)
{
    D powers{};
    for (int k = 0; k < width_of<D>; ++k)
        if (values[k] > 0) powers[k] = std::pow(values[k], exponent);
    return powers;
}

INTERPHASE_INLINE double power(double value, double exponent) { return value > 0 ? std::pow(value, exponent) : 0; }

/// A positive number that others are divided by, the same for all contacts [s]. Contacts side by side share one
/// division.
template <class D>
class Divisor {
public:
    INTERPHASE_INLINE explicit Divisor(double value) : inverse_(1 / value) {}
    /// a b / value
    INTERPHASE_INLINE D part(const D& a, const D& b) const { return a * (inverse_ * b); }
    INTERPHASE_INLINE D part(const D& a) const { return inverse_ * a; }

private:
    double inverse_;
};
template <>
class Divisor<double> {
public:
    explicit Divisor(double value) : value_(value) {}
    double part(double a, double b) const { return a * b / value_; }
    double part(double a) const { return a / value_; }

private:
    double value_;
};

}  // namespace interphase::hard_sphere
