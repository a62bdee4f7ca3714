// SPDX-License-Identifier: GPL-3.0-or-later
// How a mesh is cut: what each cell sees of its faces and edges, and which of them meet at its corners.
#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "mapping/cell_subdivision.hpp"

namespace interphase {

namespace {

/// Of a length: as near to each other as that two gauges are opposite.
constexpr double tie = 1e-9;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

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
    const std::vector<std::vector<int>> faces_of_cells = mesh.faces_of_cells();
    first_side_.assign(1, 0);
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        for (const int f : faces_of_cells[c]) {
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

}  // namespace interphase
