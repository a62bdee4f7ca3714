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

CellSubdivision::CellSubdivision(const MeshView& mesh, const JointNumbering& joints)
    : centre_(mesh.centre), volume_(mesh.volume)
{
    look_at_faces(mesh);
    look_at_cells(mesh, joints);
}

void CellSubdivision::look_at_faces(const MeshView& mesh)
{
    first_edge_.assign(1, 0);
    for (const MeshView::Face& face : mesh.faces) {
        const Vector normal = face.area.normalized();
        for (std::size_t k = 0; k < face.points.size(); ++k) {
            const auto point = [&](std::size_t n) -> Vector {
                const Vector x =
                    mesh.points[static_cast<std::size_t>(face.points[n % face.points.size()])] - face.centre;
                return x - normal.dot(x) * normal;
            };
            const Vector middle = 0.5 * (point(k) + point(k + 1)), half = 0.5 * (point(k + 1) - point(k));
            const Vector outward = half.cross(normal);
            Edge edge;
            const double seen = outward.dot(middle);
            if (seen > 0) {
                edge.gauge = outward / seen;
                edge.along = half / half.squaredNorm();
                edge.middle = edge.along.dot(middle);
                edge.area = seen;
            }
            edges_.push_back(edge);
        }
        first_edge_.push_back(edges_.size());
    }
}

/// Finds the corners of one cell and which of its sides and edges meet there.
class CellSubdivision::CornerFinder {
public:
    CornerFinder(CellSubdivision& all, const MeshView& mesh, const JointNumbering& joints, std::size_t cell)
        : all_(all), mesh_(mesh), joints_(joints), cell_(cell)
    {
        for (std::size_t s = all.first_side_[cell]; s < all.sides_.size(); ++s)
            for (std::size_t k = 0; k < points(s).size(); ++k)
                meetings_[points(s)[k]].push_back({s, k});
    }

    /// Three sides at each corner, all of them seen, so that the products have every face and edge they need.
    bool all_simple() const
    {
        for (const auto& [point, sides] : meetings_) {
            if (sides.size() != 3) return false;
            for (const auto& [s, k] : sides) {
                const auto face = at(all_.sides_[s].face);
                if (!(all_.sides_[s].gauge.norm() > 0) || !(all_.edges_[all_.first_edge_[face] + k].gauge.norm() > 0))
                    return false;
                for (const int neighbour : {next(s, k), previous(s, k)})
                    if (shared_edge(sides, s, neighbour) == none) return false;
            }
        }
        return true;
    }

    /// Three pairs of opposite gauges: numbers the axes, and the sides at each corner in their order.
    bool is_box()
    {
        const std::size_t first = all_.first_side_[cell_];
        if (all_.sides_.size() - first != 6) return false;
        axis_.assign(6, none);
        std::size_t axes = 0;
        for (std::size_t s = 0; s < 6; ++s)
            for (std::size_t other = s + 1; other < 6 && axis_[s] == none; ++other) {
                const Vector &here = all_.sides_[first + s].gauge, &there = all_.sides_[first + other].gauge;
                if ((here + there).norm() > tie * here.norm()) continue;
                if (axes == 3) return false;
                axis_[s] = axis_[other] = axes++;
            }
        if (axes != 3) return false;
        for (auto& [point, sides] : meetings_)
            std::sort(sides.begin(), sides.end(), [&](const Meeting& a, const Meeting& b) {
                return axis_[a.side - first] < axis_[b.side - first];
            });
        return true;
    }

    /// Of the corners that find_products() has found, which come from `first_corner` on.
    BoxCell box(std::size_t first_corner) const
    {
        const std::size_t first = all_.first_side_[cell_];
        BoxCell box;
        for (std::size_t s = 6; s-- > 0;)
            box.gauge[axis_[s]] = all_.sides_[first + s].gauge;
        for (const auto& [point, sides] : meetings_) {
            unsigned octant = 0;
            for (unsigned axis = 0; axis < 3; ++axis)
                octant |= (box.gauge[axis].dot(all_.sides_[sides[axis].side].to_face) > 0 ? 1u : 0u) << axis;
            box.corner[octant] = first_corner++;
        }
        return box;
    }

    void find_products()
    {
        for (const auto& [point, sides] : meetings_) {
            Corner corner;
            corner.fill(-1);
            corner[0] = static_cast<int>(cell_);
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [s, k] = sides[i];
                const int face = all_.sides_[s].face, n = static_cast<int>(points(s).size());
                const auto here = static_cast<int>(k), before = (here + n - 1) % n;
                const std::size_t over_next = shared_edge(sides, s, next(s, k)),
                                  over_previous = shared_edge(sides, s, previous(s, k));
                corner[1u << i] = joints_.of_face(face);
                corner[1u << i | 1u << over_next] = joints_.of_edge(face, here);
                corner[1u << i | 1u << over_previous] = joints_.of_edge(face, before);
                corner[7] = joints_.of_corner(face, here);
                enter(s, k, 0, {i, over_next, over_previous});
                enter(s, at(before), 1, {i, over_previous, over_next});
            }
            all_.corners_.push_back(corner);
        }
    }

    void find_cones()
    {
        for (std::size_t s = all_.first_side_[cell_]; s < all_.sides_.size(); ++s) {
            const int face = all_.sides_[s].face, n = static_cast<int>(points(s).size());
            for (int k = 0; k < n; ++k) {
                const int before = (k + n - 1) % n;
                enter(s, at(k), 0, {0, 1, 2});
                enter(s, at(before), 1, {0, 2, 1});
                all_.corners_.push_back({static_cast<int>(cell_), joints_.of_face(face), -1, joints_.of_edge(face, k),
                                         -1, joints_.of_edge(face, before), -1, joints_.of_corner(face, k)});
            }
        }
    }

private:
    static constexpr std::size_t none = 3;

    struct Meeting {
        std::size_t side, k;
    };

    const std::vector<int>& points(std::size_t side) const { return mesh_.faces[at(all_.sides_[side].face)].points; }
    int next(std::size_t side, std::size_t k) const { return points(side)[(k + 1) % points(side).size()]; }
    int previous(std::size_t side, std::size_t k) const
    {
        return points(side)[(k + points(side).size() - 1) % points(side).size()];
    }

    /// Which of the sides at a point has the edge to `neighbour` beside `side`.
    std::size_t shared_edge(const std::vector<Meeting>& sides, std::size_t side, int neighbour) const
    {
        for (std::size_t j = 0; j < sides.size(); ++j)
            if (sides[j].side != side &&
                (next(sides[j].side, sides[j].k) == neighbour || previous(sides[j].side, sides[j].k) == neighbour))
                return j;
        return none;
    }

    /// The corner that comes next belongs to this end of an edge of a side.
    void enter(std::size_t side, std::size_t edge, std::size_t end, const std::array<std::size_t, 3>& order)
    {
        Wedge& wedge = all_.wedges_[all_.sides_[side].first_wedge + edge];
        wedge.corner[end] = all_.corners_.size();
        for (std::size_t i = 0; i < 3; ++i)
            wedge.order[end][i] = static_cast<unsigned char>(order[i]);
    }

    CellSubdivision& all_;
    const MeshView& mesh_;
    const JointNumbering& joints_;
    std::size_t cell_;
    std::map<int, std::vector<Meeting>> meetings_;  ///< of each point
    std::vector<std::size_t> axis_;                 ///< of each side of a box
};

void CellSubdivision::look_at_cells(const MeshView& mesh, const JointNumbering& joints)
{
    std::vector<std::vector<int>> faces_of(mesh.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        faces_of[at(mesh.faces[f].owner)].push_back(static_cast<int>(f));
        if (mesh.faces[f].neighbour >= 0) faces_of[at(mesh.faces[f].neighbour)].push_back(static_cast<int>(f));
    }
    first_side_.assign(1, 0);
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        for (const int f : faces_of[c]) {
            const MeshView::Face& face = mesh.faces[at(f)];
            const Vector outward = at(face.owner) == c ? face.area : Vector(-face.area);
            Side side;
            side.to_face = face.centre - mesh.centre[c];
            const double seen = outward.dot(side.to_face);
            if (seen > 0) side.gauge = outward / seen;
            side.face = f;
            side.first_wedge = wedges_.size();
            wedges_.resize(wedges_.size() + face.points.size());
            sides_.push_back(side);
        }
        CornerFinder finder(*this, mesh, joints, c);
        has_simple_corners_.push_back(finder.all_simple());
        const std::size_t first_corner = corners_.size();
        const bool is_box = has_simple_corners_.back() && finder.is_box();
        box_of_cell_.push_back(is_box ? static_cast<int>(boxes_.size()) : -1);
        if (has_simple_corners_.back())
            finder.find_products();
        else
            finder.find_cones();
        if (is_box) boxes_.push_back(finder.box(first_corner));
        first_side_.push_back(sides_.size());
    }
}

double CellSubdivision::aside(std::size_t side, const Vector& y) const
{
    const std::size_t face = at(sides_[side].face);
    double most = 0;
    for (std::size_t e = first_edge_[face]; e < first_edge_[face + 1]; ++e)
        most = std::max(most, edges_[e].gauge.dot(y));
    return most;
}

CellSubdivision::OnFace CellSubdivision::seen_from_cell(const Vector& x, std::size_t side) const
{
    const double out = sides_[side].gauge.dot(x);
    OnFace at{side, 0, out, 0, 0};
    const auto face = static_cast<std::size_t>(sides_[side].face);
    const Vector y = x / out - sides_[side].to_face;
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

std::array<double, 8> CellSubdivision::Place::functions() const
{
    const auto [a, b, c] = smoothed;
    return products ? interphase::products(a, b, c) : cones(a, b, c);
}

CellSubdivision::Place CellSubdivision::place_in_tetrahedron(const Vector& x, std::size_t cell) const
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
    Place place{wedges_[sides_[side].first_wedge].corner[0], has_simple_corners_[cell] != 0, {}};
    if (!(out > 0)) return place;

    OnFace on = seen_from_cell(x, side);
    if (on.aside > 1 + tie)
        // beside the face: another one in the same plane, or a cell that is not convex
        for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
            if (!(sides_[s].gauge.dot(x) > 0)) continue;
            const OnFace other = seen_from_cell(x, s);
            if (other.aside < on.aside) on = other;
        }

    const double aside = std::min(on.aside, 1.0), along = std::min(std::abs(on.along), 1.0);
    out = std::min(on.out, 1.0);
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
