// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/mesh_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace interphase::test {

namespace {

using Polygon = std::vector<Vector>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Cells one by one, each as polygons in any turn; corners at the same place become one.
class Builder {
public:
    /// `inside`: a point that sees all faces from within, each face plane and seen by its mean corner.
    void add(const std::vector<Polygon>& faces, const Vector& inside)
    {
        std::vector<std::vector<int>> cell;
        for (Polygon face : faces) {
            Vector mean = Vector::Zero(), normal = Vector::Zero();
            for (const Vector& x : face)
                mean += x / static_cast<double>(face.size());
            for (std::size_t k = 0; k < face.size(); ++k)
                normal += (face[k] - mean).cross(face[(k + 1) % face.size()] - mean);
            if (normal.dot(mean - inside) < 0) std::reverse(face.begin(), face.end());
            cell.emplace_back();
            for (const Vector& x : face)
                cell.back().push_back(point(x));
        }
        cells_.push_back(std::move(cell));
    }

    /// A convex cell between planes with these normals: a face is where corners lie farthest along one.
    void add_convex(const Polygon& corners, const Vectors& normals, const Vector& centre)
    {
        std::vector<Polygon> faces;
        for (const Vector& normal : normals) {
            double farthest = -1e300;
            for (const Vector& x : corners)
                farthest = std::max(farthest, normal.dot(x));
            Polygon face;
            for (const Vector& x : corners)
                if (normal.dot(x) > farthest - 1e-9) face.push_back(x);
            Vector mean = Vector::Zero();
            for (const Vector& x : face)
                mean += x / static_cast<double>(face.size());
            const Vector a = (face[0] - mean).normalized(), b = normal.normalized().cross(a);
            std::sort(face.begin(), face.end(), [&](const Vector& x, const Vector& y) {
                return std::atan2(b.dot(x - mean), a.dot(x - mean)) < std::atan2(b.dot(y - mean), a.dot(y - mean));
            });
            faces.push_back(std::move(face));
        }
        add(faces, centre);
    }

    WholeMesh mesh() const { return WholeMesh::of_cells(points_, cells_); }

private:
    int point(const Vector& x)
    {
        std::array<long, 3> key;
        for (int axis = 0; axis < 3; ++axis)
            key[at(axis)] = std::lround(1e6 * x[axis]);
        const auto [place, is_new] = number_of_.emplace(key, static_cast<int>(points_.size()));
        if (is_new) points_.push_back(x);
        return place->second;
    }

    Vectors points_;
    std::map<std::array<long, 3>, int> number_of_;
    std::vector<std::vector<std::vector<int>>> cells_;
};

/// `visit(origin)` for each box of side 1.
void for_each_box(const std::array<int, 3>& n, const std::function<void(const Vector&)>& visit)
{
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
                visit(Vector(i, j, k));
}

/// The six sides of a box.
std::vector<Polygon> sides_of_box(const Vector& low, double side)
{
    std::vector<Polygon> sides;
    for (int axis = 0; axis < 3; ++axis)
        for (const double end : {0.0, side}) {
            const Vector u = side * Vector::Unit((axis + 1) % 3), v = side * Vector::Unit((axis + 2) % 3);
            const Vector x = low + end * Vector::Unit(axis);
            sides.push_back({x, x + u, x + u + v, x + v});
        }
    return sides;
}

/// A prism along z on a polygon.
std::vector<Polygon> prism_on(const Polygon& base, double height)
{
    const Vector up(0, 0, height);
    std::vector<Polygon> faces{base, base};
    for (Vector& x : faces[1])
        x += up;
    for (std::size_t k = 0; k < base.size(); ++k) {
        const Vector &a = base[k], &b = base[(k + 1) % base.size()];
        faces.push_back({a, b, b + up, a + up});
    }
    return faces;
}

Vector mean_of(const Polygon& corners)
{
    Vector mean = Vector::Zero();
    for (const Vector& x : corners)
        mean += x / static_cast<double>(corners.size());
    return mean;
}

}  // namespace

std::array<Scalars, 3> unit_planes(const std::array<int, 3>& n)
{
    std::array<Scalars, 3> planes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        planes[axis].resize(at(n[axis] + 1));
        std::iota(planes[axis].begin(), planes[axis].end(), 0.0);
    }
    return planes;
}

WholeMesh shaken_boxes(const std::array<int, 3>& n, double by, unsigned seed)
{
    WholeMesh mesh = WholeMesh::of_boxes(unit_planes(n));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-by, by);
    for (Vector& x : mesh.points)
        for (int axis = 0; axis < 3; ++axis) {
            const double moved = move(random);
            if (x[axis] > 0.5 && x[axis] < n[at(axis)] - 0.5) x[axis] += moved;
        }
    return mesh;
}

WholeMesh refined_boxes(const std::array<int, 3>& n, const std::function<bool(int, int, int)>& is_fine)
{
    const auto fine = [&](const Vector& x) {  // the box that holds x
        if (x.minCoeff() < 0 || x[0] > 2 * n[0] || x[1] > 2 * n[1] || x[2] > 2 * n[2]) return false;
        return is_fine(static_cast<int>(x[0] / 2), static_cast<int>(x[1] / 2), static_cast<int>(x[2] / 2));
    };
    // the middle of a side, 2 long, of a coarse box: a corner where one of the boxes about it is fine
    const auto has_corner = [&](const Vector& x) {
        for (const double a : {-0.5, 0.5})
            for (const double b : {-0.5, 0.5})
                for (const double c : {-0.5, 0.5})
                    if (fine(x + Vector(a, b, c))) return true;
        return false;
    };
    Builder builder;
    for_each_box(n, [&](const Vector& index) {
        const Vector low = 2 * index;
        if (fine(low + Vector::Constant(1))) {
            for_each_box({2, 2, 2}, [&](const Vector& eighth) {
                builder.add(sides_of_box(low + eighth, 1), low + eighth + Vector::Constant(0.5));
            });
            return;
        }
        std::vector<Polygon> faces;
        const Vector centre = low + Vector::Constant(1);
        for (const Polygon& side : sides_of_box(low, 2)) {
            const Vector middle = mean_of(side);
            if (fine(middle + 0.5 * (middle - centre))) {
                for (std::size_t k = 0; k < 4; ++k)
                    faces.push_back(
                        {side[k], 0.5 * (side[k] + side[(k + 1) % 4]), middle, 0.5 * (side[k] + side[(k + 3) % 4])});
                continue;
            }
            Polygon face;
            for (std::size_t k = 0; k < 4; ++k) {
                face.push_back(side[k]);
                const Vector between = 0.5 * (side[k] + side[(k + 1) % 4]);
                if (has_corner(between)) face.push_back(between);
            }
            faces.push_back(std::move(face));
        }
        builder.add(faces, centre);
    });
    return builder.mesh();
}

WholeMesh tetrahedra(const std::array<int, 3>& n)
{
    Builder builder;
    for_each_box(n, [&](const Vector& low) {
        std::array<int, 3> axes{0, 1, 2};
        do {
            Polygon x{low};
            for (const int axis : axes)
                x.push_back(x.back() + Vector::Unit(axis));
            builder.add({{x[0], x[1], x[2]}, {x[0], x[1], x[3]}, {x[0], x[2], x[3]}, {x[1], x[2], x[3]}}, mean_of(x));
        } while (std::next_permutation(axes.begin(), axes.end()));
    });
    return builder.mesh();
}

WholeMesh prisms(const std::array<int, 3>& n)
{
    Builder builder;
    for_each_box(n, [&](const Vector& low) {
        const Vector x = Vector::UnitX(), y = Vector::UnitY();
        for (const Polygon& base : {Polygon{low, low + x, low + x + y}, Polygon{low, low + x + y, low + y}})
            builder.add(prism_on(base, 1), mean_of(base) + Vector(0, 0, 0.5));
    });
    return builder.mesh();
}

WholeMesh pyramids(const std::array<int, 3>& n)
{
    Builder builder;
    for_each_box(n, [&](const Vector& low) {
        const Vector apex = low + Vector::Constant(0.5);
        for (const Polygon& base : sides_of_box(low, 1)) {
            std::vector<Polygon> faces{base};
            for (std::size_t k = 0; k < 4; ++k)
                faces.push_back({base[k], base[(k + 1) % 4], apex});
            builder.add(faces, 0.75 * mean_of(base) + 0.25 * apex);
        }
    });
    return builder.mesh();
}

WholeMesh hexagonal_prisms(const std::array<int, 3>& n)
{
    constexpr double side = 0.6;
    Builder builder;
    for_each_box(n, [&](const Vector& index) {
        const int row = static_cast<int>(index[1]);
        const Vector centre(std::sqrt(3.0) * side * (index[0] + 0.5 * (row % 2)), 1.5 * side * row, index[2]);
        Polygon base;
        for (int k = 0; k < 6; ++k)
            base.push_back(centre + side * Vector(std::sin(M_PI / 3 * k), std::cos(M_PI / 3 * k), 0));
        builder.add(prism_on(base, 1), centre + Vector(0, 0, 0.5));
    });
    return builder.mesh();
}

WholeMesh truncated_octahedra(const std::array<int, 3>& n)
{
    Polygon corners;  // all arrangements of 0, 1/4, 1/2 with both signs
    Vectors normals;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-1.0, 1.0}) {
            std::array<int, 3> axes{0, 1, 2};
            do
                corners.push_back(0.25 * a * Vector::Unit(axes[0]) + 0.5 * b * Vector::Unit(axes[1]));
            while (std::next_permutation(axes.begin(), axes.end()));
            for (const double c : {-1.0, 1.0})
                normals.emplace_back(a, b, c);
        }
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0})
            normals.push_back(sign * Vector::Unit(axis));
    Builder builder;
    for_each_box(n, [&](const Vector& low) {
        for (const Vector& centre : {low, Vector(low + Vector::Constant(0.5))}) {
            Polygon moved = corners;
            for (Vector& x : moved)
                x += centre;
            builder.add_convex(moved, normals, centre);
        }
    });
    return builder.mesh();
}

WholeMesh l_shaped_cells(const std::array<int, 3>& n)
{
    Builder builder;
    for_each_box(n, [&](const Vector& index) {
        const Vector low = index.cwiseProduct(Vector(2, 2, 1));
        // The corner in the middle of a side is there since other blocks' cells end there.
        Polygon base;
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}})
            base.push_back(low + Vector(x, y, 0));
        builder.add(prism_on(base, 1), low + Vector(0.8, 0.8, 0.5));
        builder.add(sides_of_box(low + Vector(1, 1, 0), 1), low + Vector(1.5, 1.5, 0.5));
    });
    return builder.mesh();
}

WholeMesh with_baffle(WholeMesh mesh, const std::function<bool(const Vector&)>& is_baffle)
{
    const std::size_t count = mesh.faces.size();
    for (std::size_t f = 0; f < count; ++f) {
        WholeMesh::Face& face = mesh.faces[f];
        Polygon corners;
        for (const int p : face.points)
            corners.push_back(mesh.points[at(p)]);
        if (face.neighbour < 0 || !is_baffle(mean_of(corners))) continue;
        WholeMesh::Face behind{face.points, face.neighbour};
        std::reverse(behind.points.begin() + 1, behind.points.end());
        face.neighbour = -1;
        mesh.faces.push_back(std::move(behind));
    }
    return mesh;
}

}  // namespace interphase::test
