// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_subdivision.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace interphase {

namespace {

/// Of a face's or an edge's extent: as near to its end as that a point is still on it.
constexpr double tie = 1e-9;

std::array<double, 8> products(double a, double b, double c)
{
    const double ab = a * b, ac = a * c, bc = b * c, abc = ab * c;
    return {1 - a - b - c + ab + ac + bc - abc,
            a - ab - ac + abc,
            b - ab - bc + abc,
            ab - abc,
            c - ac - bc + abc,
            ac - abc,
            bc - abc,
            abc};
}

/// b and c on the face.
std::array<double, 8> cones(double a, double b, double c)
{
    return {1 - a, a * (1 - b) * (1 - c), 0, a * b * (1 - c), 0, a * (1 - b) * c, 0, a * b * c};
}

/// Means over 1 >= A >= B >= C >= 0 of eight functions that are polynomials of degree 11 at most in A, B/A and C/B: by
/// Gauss's rule of eight points in each.
template <class Functions>
std::array<double, 8> means_of(Functions&& functions)
{
    constexpr std::array<double, 4> node{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                         0.9602898564975363};
    constexpr std::array<double, 4> weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                           0.1012285362903763};
    const auto at = [&](std::size_t n) { return 0.5 + (n % 2 ? 0.5 : -0.5) * node[n / 2]; };
    std::array<double, 8> mean{};
    double whole = 0;
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t j = 0; j < 8; ++j)
            for (std::size_t k = 0; k < 8; ++k) {
                const double out = at(i), aside = at(j), along = at(k);
                const double volume = weight[i / 2] * weight[j / 2] * weight[k / 2] * out * out * aside;
                const std::array<double, 8> here = functions(out, aside, along);
                for (std::size_t m = 0; m < 8; ++m)
                    mean[m] += volume * here[m];
                whole += volume;
            }
    for (double& value : mean)
        value /= whole;
    return mean;
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

const std::array<double, 8>& CellSubdivision::means_of_products()
{
    static const std::array<double, 8> means = means_of([](double out, double aside, double along) {
        return products(smoothed(out), smoothed(out * aside), smoothed(out * aside * along));
    });
    return means;
}

const std::array<double, 8>& CellSubdivision::means_of_cones()
{
    static const std::array<double, 8> means = means_of([](double out, double aside, double along) {
        return cones(smoothed(out), smoothed(aside), smoothed(aside * along));
    });
    return means;
}

CellSubdivision::OnFace CellSubdivision::seen_from_face(const Vector& y, std::size_t side) const
{
    OnFace at{side, 0, 1, 0, 0};
    const auto face = static_cast<std::size_t>(sides_[side].face);
    const auto along = [&](std::size_t edge, double aside) {
        return aside > 0 ? edges_[edge].along.dot(y) / aside - edges_[edge].middle : 0.0;
    };
    at.edge = first_edge_[face];
    for (std::size_t e = first_edge_[face]; e < first_edge_[face + 1]; ++e) {
        const double reached = edges_[e].gauge.dot(y);
        if (reached > at.aside) {
            at.aside = reached;
            at.edge = e;
        }
    }
    at.along = along(at.edge, at.aside);
    if (std::abs(at.along) <= 1 + tie) return at;
    // beside the edge: another one in the same line, or a face that is not convex
    for (std::size_t e = first_edge_[face]; e < first_edge_[face + 1]; ++e) {
        const double reached = edges_[e].gauge.dot(y);
        if (!(reached > 0) || !(std::abs(along(e, reached)) < std::abs(at.along))) continue;
        at.edge = e;
        at.aside = reached;
        at.along = along(e, reached);
    }
    return at;
}

CellSubdivision::OnFace CellSubdivision::seen_from_cell(const Vector& x, std::size_t side) const
{
    const double out = sides_[side].gauge.dot(x);
    OnFace at = seen_from_face(x / out - sides_[side].to_face, side);
    at.out = out;
    return at;
}

std::array<double, 8> CellSubdivision::Place::functions() const
{
    const auto [a, b, c] = smoothed;
    return products ? interphase::products(a, b, c) : cones(a, b, c);
}

CellSubdivision::OnFace CellSubdivision::met_by_ray(const Vector& x, std::size_t cell) const
{
    double out = 0;
    std::size_t side = first_side_[cell];
    for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
        const double reached = sides_[s].gauge.dot(x);
        if (reached > out) {
            out = reached;
            side = s;
        }
    }
    if (!(out > 0)) return {side, 0, 0, 0, 0};

    OnFace on = seen_from_cell(x, side);
    if (on.aside > 1 + tie)
        // beside the face: another one in the same plane, or a cell that is not convex
        for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
            if (!(sides_[s].gauge.dot(x) > 0)) continue;
            const OnFace other = seen_from_cell(x, s);
            if (other.aside < on.aside) on = other;
        }
    return on;
}

CellSubdivision::Place CellSubdivision::place_in_tetrahedron(const Vector& x, std::size_t cell) const
{
    const OnFace on = met_by_ray(x, cell);
    Place place{wedges_[sides_[on.side].first_wedge].corner[0], has_simple_corners_[cell] != 0, {}};
    if (!(on.out > 0)) return place;

    const double aside = std::min(on.aside, 1.0), along = std::min(std::abs(on.along), 1.0);
    const double out = std::min(on.out, 1.0);
    const std::size_t end = on.along > 0 ? 1 : 0;
    const Wedge& wedge = wedges_[sides_[on.side].first_wedge + on.edge - first_edge_[at(sides_[on.side].face)]];
    place.corner = wedge.corner[end];
    const double from = place.products ? out : 1.0;
    const std::array<double, 3> sorted{smoothed(out), smoothed(from * aside), smoothed(from * aside * along)};
    for (std::size_t i = 0; i < 3; ++i)
        place.smoothed[wedge.order[end][i]] = sorted[i];
    return place;
}

}  // namespace interphase
