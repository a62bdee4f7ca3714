// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/triangle_wall.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace interphase::walls {

namespace {

struct Candidate {
    Vector point;
    double distance;
    int triangle;
};

/// Of a flat or hollow surface the inner edges are none to bump into: a point that does not rise above the plane of
/// contact at a nearer one is the same surface.
bool hidden_by(const Candidate& nearer, const Candidate& other, const Vector& centre, double radius)
{
    const Vector outwards = (centre - nearer.point) / std::max(nearer.distance, 1e-300);
    return (other.point - nearer.point).dot(outwards) < 1e-6 * radius;
}

}  // namespace

Vector nearest_point(const Triangle& triangle, const Vector& point)
{
    const Vector &a = triangle[0], &b = triangle[1], &c = triangle[2];
    const Vector ab = b - a, ac = c - a, ap = point - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return a;
    const Vector bp = point - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
    const Vector cp = point - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    const double sum = va + vb + vc;
    return a + vb / sum * ab + vc / sum * ac;
}

Vector velocity_at(const Triangle& triangle, const Triangle& velocity, const Vector& point)
{
    // shares of the corners: areas of the parts into which the point cuts the triangle
    const Vector ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0], ap = point - triangle[0];
    const Vector normal = ab.cross(ac);
    const double twice_area2 = normal.squaredNorm();
    if (twice_area2 == 0) return (velocity[0] + velocity[1] + velocity[2]) / 3;
    const double of_b = ap.cross(ac).dot(normal) / twice_area2, of_c = ab.cross(ap).dot(normal) / twice_area2;
    return (1 - of_b - of_c) * velocity[0] + of_b * velocity[1] + of_c * velocity[2];
}

TriangleWall::TriangleWall(int type, Surface surface) : Wall(type), surface_(std::move(surface)) { sort_into_cells(); }

double TriangleWall::fastest() const
{
    double fastest2 = 0;
    if (surface_.travels)
        for (const Triangle& velocity : surface_.velocity)
            for (const Vector& corner : velocity)
                fastest2 = std::max(fastest2, corner.squaredNorm());
    return std::sqrt(fastest2);
}

void TriangleWall::travel(double time)
{
    if (!surface_.travels) return;
    for (std::size_t t = 0; t < surface_.velocity.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
            surface_.triangles[t][corner] += time * surface_.velocity[t][corner];
    sort_into_cells();
}

double TriangleWall::away_from(const Wall& before) const
{
    const auto* other = dynamic_cast<const TriangleWall*>(&before);
    double distance2 = 0;
    for (std::size_t t = 0; other && t < std::min(surface_.triangles.size(), other->surface_.triangles.size()); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
            distance2 = std::max(distance2,
                                 (surface_.triangles[t][corner] - other->surface_.triangles[t][corner]).squaredNorm());
    return std::sqrt(distance2);
}

void TriangleWall::sort_into_cells()
{
    const std::vector<Triangle>& triangles = surface_.triangles;
    bounds_ = empty_box();
    double shortest = 0;
    for (const Triangle& t : triangles) {
        for (const Vector& corner : t)
            extend(bounds_, corner);
        shortest += std::min({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    }
    if (triangles.empty()) return;
    // cells about as wide as the triangles' shortest edges: of the long sides of a drum a sphere then sees few
    size_ = std::max(shortest / static_cast<double>(triangles.size()), 1e-300);
    while (!lay_cells())
        size_ *= 1.26;

    const auto each = [&](const auto& visit) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const Range range = cells_of(triangles[t]);
            for (int z = range.low[2]; z <= range.high[2]; ++z)
                for (int y = range.low[1]; y <= range.high[1]; ++y)
                    for (int x = range.low[0]; x <= range.high[0]; ++x)
                        visit(static_cast<std::size_t>(cell(x, y, z)), static_cast<int>(t));
        }
    };
    start_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    each([&](std::size_t c, int) { ++start_[c + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    members_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<int> next(start_.begin(), start_.end() - 1);
    each([&](std::size_t c, int t) { members_[static_cast<std::size_t>(next[c]++)] = t; });
}

/// Returns whether there are not many more cells than triangles, nor places of triangles in them.
bool TriangleWall::lay_cells()
{
    const double most = 64.0 * static_cast<double>(surface_.triangles.size()) + 64;
    const Vector extent = bounds_.col(1) - bounds_.col(0);
    double cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double count = std::floor(extent[axis] / size_) + 1;
        cells *= count;
        if (cells > most) return false;
        cells_[axis] = static_cast<int>(count);
    }
    double places = 0;
    for (const Triangle& triangle : surface_.triangles) {
        const Range range = cells_of(triangle);
        double covered = 1;
        for (int axis = 0; axis < 3; ++axis)
            covered *= range.high[axis] - range.low[axis] + 1;
        places += covered;
    }
    return places <= most;
}

TriangleWall::Range TriangleWall::cells_of(const Triangle& triangle) const
{
    const auto& [a, b, c] = triangle;
    return cells_around(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
}

TriangleWall::Range TriangleWall::cells_around(const Vector& low, const Vector& high) const
{
    Range range;
    for (int axis = 0; axis < 3; ++axis) {
        const auto clamped = [&](double x) {
            return static_cast<int>(
                std::clamp(std::floor((x - bounds_(axis, 0)) / size_), 0.0, static_cast<double>(cells_[axis] - 1)));
        };
        range.low[axis] = clamped(low[axis]);
        range.high[axis] = clamped(high[axis]);
    }
    return range;
}

template <class Visit>
void TriangleWall::each_near(const Place& sphere, double reach, const Visit& visit) const
{
    const double within = sphere.radius + reach;
    const Vector centre = to_vector(sphere.centre), span = Vector::Constant(within);
    if (((centre + span).array() < bounds_.col(0).array()).any() ||
        ((centre - span).array() > bounds_.col(1).array()).any())
        return;
    const Range range = cells_around(centre - span, centre + span);
    for (int z = range.low[2]; z <= range.high[2]; ++z)
        for (int y = range.low[1]; y <= range.high[1]; ++y)
            for (int x = range.low[0]; x <= range.high[0]; ++x) {
                const auto c = static_cast<std::size_t>(cell(x, y, z));
                for (int k = start_[c]; k < start_[c + 1]; ++k)
                    if (visit(members_[static_cast<std::size_t>(k)])) return;
            }
}

bool TriangleWall::may_touch(const Place& sphere, double reach) const
{
    bool found = false;
    each_near(sphere, reach, [&](int) { return found = true; });
    return found;
}

void TriangleWall::near(const Place& sphere, double reach, std::vector<WallPoint>& points) const
{
    const double within = sphere.radius + reach;
    const Vector centre = to_vector(sphere.centre);
    std::vector<Candidate> candidates;
    each_near(sphere, reach, [&](int t) {
        const Vector point = nearest_point(surface_.triangles[static_cast<std::size_t>(t)], centre);
        const double distance = (point - centre).norm();
        if (distance < within && distance > 0) candidates.push_back({point, distance, t});
        return false;
    });
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
    });
    std::vector<Candidate> kept;
    for (const Candidate& candidate : candidates) {
        const auto hides = [&](const Candidate& nearer) { return hidden_by(nearer, candidate, centre, sphere.radius); };
        if (std::any_of(kept.begin(), kept.end(), hides)) continue;
        kept.push_back(candidate);
        const auto t = static_cast<std::size_t>(candidate.triangle);
        const Vector velocity = surface_.velocity.empty()
                                    ? Vector::Zero().eval()
                                    : velocity_at(surface_.triangles[t], surface_.velocity[t], candidate.point);
        points.push_back({(candidate.point - centre) / candidate.distance, candidate.distance - sphere.radius, velocity,
                          candidate.triangle});
    }
}

}  // namespace interphase::walls
