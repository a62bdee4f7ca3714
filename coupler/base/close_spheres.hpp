// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace interphase {

/// Finds the pairs of spheres that overlap, in a time that grows with the number of spheres: sorted into cells as wide
/// as the largest of their class of size, in which no sphere is twice another.
class CloseSpheres {
public:
    /// `centre`: [n x 3] in m, `radius`: [n] in m, finite and above 0.
    CloseSpheres(const double* centre, const double* radius, std::size_t n);

    /// Calls visit(i, j, depth) once for each pair whose overlap `depth` [m] is above 0, in no order.
    template <class Visit>
    void for_each_overlap(const Visit& visit) const
    {
        for (std::size_t k = 0; k < classes_.size(); ++k)
            for (std::size_t s = 0; s < classes_[k].spheres.size(); ++s) {
                const Sphere& sphere = classes_[k].spheres[s];
                classes_[k].for_later_near(s, [&](const Sphere& other) { look(sphere, other, visit); });
                for (std::size_t l = k + 1; l < classes_.size(); ++l)
                    classes_[l].for_near(sphere.at, [&](const Sphere& other) { look(sphere, other, visit); });
            }
    }

private:
    struct Sphere {
        std::array<double, 3> at;
        double radius;
        std::int64_t cell;
        std::size_t number;
    };

    template <class Visit>
    static void look(const Sphere& a, const Sphere& b, const Visit& visit)
    {
        const double x = a.at[0] - b.at[0], y = a.at[1] - b.at[1], z = a.at[2] - b.at[2];
        const double reach = a.radius + b.radius, square = x * x + y * y + z * z;
        if (square >= reach * reach) return;
        const double depth = reach - std::sqrt(square);
        if (depth > 0) visit(a.number, b.number, depth);
    }

    /// Spheres of one class, sorted by cell. Far cells may share a place in the table: a sphere knows its own.
    struct SizeClass {
        double width = 0;
        std::array<double, 3> low{};
        std::array<std::int64_t, 3> stride{};
        std::size_t mask = 0;
        std::vector<Sphere> spheres;
        std::vector<std::uint32_t> first;  ///< of each place in the table, and one past the last

        std::int64_t index(double x, std::size_t axis) const
        {
            return static_cast<std::int64_t>(std::floor((x - low[axis]) / width));
        }
        std::int64_t cell_of(const std::array<double, 3>& at) const
        {
            return index(at[0], 0) * stride[0] + index(at[1], 1) * stride[1] + index(at[2], 2) * stride[2];
        }
        std::size_t place(std::int64_t cell) const { return static_cast<std::size_t>(cell) & mask; }
        void sort();

        template <class Visit>
        void in_cell(std::int64_t cell, const Visit& visit) const
        {
            for (std::uint32_t n = first[place(cell)]; n < first[place(cell) + 1]; ++n)
                if (spheres[n].cell == cell) visit(spheres[n]);
        }
        template <class Visit>
        void for_near(const std::array<double, 3>& at, const Visit& visit) const
        {
            const std::int64_t middle = cell_of(at);
            for (int z = -1; z <= 1; ++z)
                for (int y = -1; y <= 1; ++y)
                    for (int x = -1; x <= 1; ++x)
                        in_cell(middle + x * stride[0] + y * stride[1] + z * stride[2], visit);
        }
        /// Near sphere `s`, so that of two near each other one finds the other.
        template <class Visit>
        void for_later_near(std::size_t s, const Visit& visit) const
        {
            const std::int64_t own = spheres[s].cell;
            for (std::size_t n = s + 1; n < first[place(own) + 1]; ++n)
                if (spheres[n].cell == own) visit(spheres[n]);
            in_cell(own + stride[0], visit);
            for (int x = -1; x <= 1; ++x)
                in_cell(own + x * stride[0] + stride[1], visit);
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    in_cell(own + x * stride[0] + y * stride[1] + stride[2], visit);
        }
    };

    std::vector<SizeClass> classes_;  ///< small ones first
};

}  // namespace interphase
