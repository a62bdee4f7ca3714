// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace interphase {

using Vector = Eigen::Vector3d;
using Scalars = std::vector<double>;
using Vectors = std::vector<Vector>;

/// Somebody else's vectors, one a column, not copied.
using VectorsView = Eigen::Map<const Eigen::Matrix3Xd>;
using ScalarsView = Eigen::Map<const Eigen::VectorXd>;

/// Three numbers as records and engines keep them, and back.
inline Vector to_vector(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

template <class Number>
Vector to_vector(const Number (&numbers)[3])
{
    return {numbers[0], numbers[1], numbers[2]};
}

template <class Number>
void set(Number (&numbers)[3], const Vector& value)
{
    for (int axis = 0; axis < 3; ++axis)
        numbers[axis] = static_cast<Number>(value[axis]);
}

/// Vector `i` of a flat field [n x 3].
inline Vector vector_at(const Scalars& flat, std::size_t i) { return to_vector(&flat[3 * i]); }
inline void set_vector_at(Scalars& flat, std::size_t i, const Vector& value)
{
    std::copy_n(value.data(), 3, &flat[3 * i]);
}

/// An axis-aligned box [m]; empty until a point was added.
using Box = Eigen::Matrix<double, 3, 2>;

inline Box empty_box()
{
    Box box;
    box.col(0).setConstant(1e300);
    box.col(1).setConstant(-1e300);
    return box;
}

inline void extend(Box& box, const Vector& point)
{
    box.col(0) = box.col(0).cwiseMin(point);
    box.col(1) = box.col(1).cwiseMax(point);
}

inline bool contains(const Box& box, const Vector& point)
{
    return (point.array() >= box.col(0).array()).all() && (point.array() <= box.col(1).array()).all();
}

inline bool overlap(const Box& a, const Box& b)
{
    return (a.col(0).array() <= b.col(1).array()).all() && (b.col(0).array() <= a.col(1).array()).all();
}

}  // namespace interphase
