// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of the unit cube of convex cells that are no cuboids, made from nothing, and written as OpenFOAM's polyMesh.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "base/vector.hpp"

namespace interphase::testing_gas {

using Polygon = std::vector<int>;  ///< numbers of points, in order around it

/// Two sides of a mesh that are joined: faces whose middles `across` takes to those of others.
struct Pair {
    std::function<Vector(const Vector&)> across;
    std::string entries;  ///< of both patches in the file boundary
};

/// Cells by their faces. Two cells that meet have one face in common, with the same points.
struct PolyMesh {
    std::vector<Vector> points;
    std::vector<std::vector<Polygon>> cells;

    /// The mean of a cell's points, which is inside of it.
    Vector middle(std::size_t cell) const
    {
        Vector sum(0, 0, 0);
        double count = 0;
        for (const Polygon& face : cells[cell])
            for (const int p : face) {
                sum += points[static_cast<std::size_t>(p)];
                ++count;
            }
        return sum / count;
    }

    /// By how much `x` is beyond the farthest of the cell's planes [m]; at most 0 inside.
    double distance_outside(std::size_t cell, const Vector& x) const
    {
        double farthest = -1e300;
        for (const Polygon& face : cells[cell]) {
            const Vector n = outward(cell, face).normalized();
            farthest = std::max(farthest, n.dot(x - points[static_cast<std::size_t>(face[0])]));
        }
        return farthest;
    }

    /// The files points, faces, owner, neighbour and boundary: the patch `sides`, and with a `pair` the patches
    /// `cyclicLow` and `cyclicHigh`, whose faces do not begin at the same corners.
    void write(const std::string& folder, const std::optional<Pair>& pair = std::nullopt) const
    {
        enum Patch { inside, sides, low, high };
        struct Face {
            Polygon polygon;
            int owner, neighbour;
            Patch patch = sides;
            std::size_t rank = 0;  ///< in its half of the pair
        };
        std::map<Polygon, Face> by_points;
        for (std::size_t c = 0; c < cells.size(); ++c)
            for (const Polygon& polygon : cells[c]) {
                Polygon key = polygon;
                std::sort(key.begin(), key.end());
                const auto [at, is_new] = by_points.try_emplace(key, Face{polygon, static_cast<int>(c), -1});
                if (!is_new) {
                    at->second.neighbour = static_cast<int>(c);
                    continue;
                }
                if (area(polygon).dot(outward(c, polygon)) < 0)
                    std::reverse(at->second.polygon.begin() + 1, at->second.polygon.end());
            }
        std::vector<Face> faces;
        for (const auto& [key, face] : by_points)
            faces.push_back(face);
        for (Face& face : faces)
            if (face.neighbour >= 0) face.patch = inside;
        if (pair)
            for (std::size_t f = 0; f < faces.size(); ++f) {
                if (faces[f].patch == inside) continue;
                const Vector there = pair->across(mean(faces[f].polygon));
                const auto other = std::find_if(faces.begin(), faces.end(), [&](const Face& face) {
                    return face.patch != inside && (mean(face.polygon) - there).norm() < 1e-9;
                });
                if (other == faces.end()) continue;
                faces[f].patch = low;
                other->patch = high;
                faces[f].rank = other->rank = f;
                std::rotate(other->polygon.begin(), other->polygon.begin() + 1, other->polygon.end());
            }
        // inner faces first, by owner and neighbour: OpenFOAM's upper triangular order
        std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
            return std::make_tuple(a.patch, a.rank, a.owner, a.neighbour) <
                   std::make_tuple(b.patch, b.rank, b.owner, b.neighbour);
        });
        const auto count = [&](Patch patch) {
            return std::count_if(faces.begin(), faces.end(), [&](const Face& f) { return f.patch == patch; });
        };

        std::filesystem::create_directories(folder);
        const auto open = [&](const std::string& name, const std::string& type) {
            std::ofstream file(folder + "/" + name);
            file.precision(17);
            file << "FoamFile { version 2.0; format ascii; class " << type << "; object " << name << "; }\n";
            return file;
        };
        std::ofstream file = open("points", "vectorField");
        file << points.size() << "(\n";
        for (const Vector& p : points)
            file << "(" << p.x() << " " << p.y() << " " << p.z() << ")\n";
        file << ")\n";
        file = open("faces", "faceList");
        file << faces.size() << "(\n";
        for (const Face& face : faces) {
            file << face.polygon.size() << "(";
            for (const int p : face.polygon)
                file << p << " ";
            file << ")\n";
        }
        file << ")\n";
        file = open("owner", "labelList");
        file << faces.size() << "(\n";
        for (const Face& face : faces)
            file << face.owner << "\n";
        file << ")\n";
        file = open("neighbour", "labelList");
        file << count(inside) << "(\n";
        for (const Face& face : faces)
            if (face.neighbour >= 0) file << face.neighbour << "\n";
        file << ")\n";
        file = open("boundary", "polyBoundaryMesh");
        const auto range = [&](Patch patch, long start) {
            return "nFaces " + std::to_string(count(patch)) + "; startFace " + std::to_string(start) + "; }\n";
        };
        long start = count(inside);
        file << (pair ? 3 : 1) << "(\nsides { type patch; " << range(sides, start);
        if (pair) {
            start += count(sides);
            file << "cyclicLow { neighbourPatch cyclicHigh; " << pair->entries << range(low, start);
            start += count(low);
            file << "cyclicHigh { neighbourPatch cyclicLow; " << pair->entries << range(high, start);
        }
        file << ")\n";
    }

private:
    Vector mean(const Polygon& face) const
    {
        Vector sum(0, 0, 0);
        for (const int p : face)
            sum += points[static_cast<std::size_t>(p)];
        return sum / static_cast<double>(face.size());
    }

    Vector area(const Polygon& face) const
    {
        const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(face[i])]; };
        Vector sum(0, 0, 0);
        for (std::size_t i = 2; i < face.size(); ++i)
            sum += (at(i - 1) - at(0)).cross(at(i) - at(0));
        return sum;
    }

    Vector outward(std::size_t cell, const Polygon& face) const
    {
        const Vector a = area(face);
        return a.dot(middle(cell) - points[static_cast<std::size_t>(face[0])]) > 0 ? Vector(-a) : a;
    }
};

/// Points of a grid of n x n x n cubes.
inline std::vector<Vector> grid_points(int n)
{
    std::vector<Vector> points;
    for (int k = 0; k <= n; ++k)
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i)
                points.emplace_back(Vector(i, j, k) / n);
    return points;
}

/// Six tetrahedra in each of n x n x n cubes, around its diagonal, one for each order of the axes (Kuhn).
inline PolyMesh tetrahedra(int n)
{
    PolyMesh mesh{grid_points(n), {}};
    const std::array<int, 3> stride{1, n + 1, (n + 1) * (n + 1)};
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                std::array<int, 3> order{0, 1, 2};
                do {
                    const int a = i + stride[1] * j + stride[2] * k;
                    const int b = a + stride[static_cast<std::size_t>(order[0])];
                    const int c = b + stride[static_cast<std::size_t>(order[1])];
                    const int d = c + stride[static_cast<std::size_t>(order[2])];
                    mesh.cells.push_back({{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}});
                } while (std::next_permutation(order.begin(), order.end()));
            }
    return mesh;
}

/// 3 x 3 x 3 cubes, the middle one cut into eight: its faces are four of a neighbour's, and nodes hang on the edges of
/// others.
inline PolyMesh refined_in_the_middle()
{
    constexpr int n = 6;  // of the fine cubes along an edge
    PolyMesh mesh{grid_points(n), {}};
    using Place = std::array<int, 3>;
    const auto number = [](const Place& p) { return p[0] + (n + 1) * (p[1] + (n + 1) * p[2]); };
    const auto at_middle = [](const Place& p) {
        return std::all_of(p.begin(), p.end(), [](int x) { return x >= 2 && x <= 4; });
    };
    const auto cube = [&](const Place& low, int size) {
        std::vector<Polygon> faces;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, size}) {
                const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                const auto corner = [&](int along_u, int along_v) {
                    Place p = low;
                    p[axis] += side;
                    p[u] += along_u;
                    p[v] += along_v;
                    return p;
                };
                if (size == 2 && at_middle(corner(0, 0)) && at_middle(corner(2, 2))) {
                    for (const int i : {0, 1})
                        for (const int j : {0, 1})
                            faces.push_back({number(corner(i, j)), number(corner(i + 1, j)),
                                             number(corner(i + 1, j + 1)), number(corner(i, j + 1))});
                    continue;
                }
                const std::array<Place, 4> corners{corner(0, 0), corner(size, 0), corner(size, size), corner(0, size)};
                Polygon face;
                for (std::size_t k = 0; k < 4; ++k) {
                    const Place &a = corners[k], &b = corners[(k + 1) % 4];
                    face.push_back(number(a));
                    if (size == 2 && at_middle(a) && at_middle(b))
                        face.push_back(number({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}));
                }
                faces.push_back(face);
            }
        mesh.cells.push_back(faces);
    };
    for (int k = 0; k < n; k += 2)
        for (int j = 0; j < n; j += 2)
            for (int i = 0; i < n; i += 2) {
                if (i != 2 || j != 2 || k != 2) {
                    cube({i, j, k}, 2);
                    continue;
                }
                for (int fine = 0; fine < 8; ++fine)
                    cube({i + fine % 2, j + fine / 2 % 2, k + fine / 4}, 1);
            }
    // only points of some face
    PolyMesh used;
    std::map<int, int> new_number;
    for (auto cell : mesh.cells) {
        for (Polygon& face : cell)
            for (int& p : face) {
                const auto [at, is_new] = new_number.try_emplace(p, static_cast<int>(used.points.size()));
                if (is_new) used.points.push_back(mesh.points[static_cast<std::size_t>(p)]);
                p = at->second;
            }
        used.cells.push_back(cell);
    }
    return used;
}

/// Polygons of a plane, one above another in `layers` of equal height.
inline PolyMesh columns(const std::vector<Vector>& in_plane, const std::vector<Polygon>& bases, int layers)
{
    PolyMesh mesh;
    const int n = static_cast<int>(in_plane.size());
    for (int k = 0; k <= layers; ++k)
        for (const Vector& p : in_plane)
            mesh.points.emplace_back(p.x(), p.y(), static_cast<double>(k) / layers);
    for (int k = 0; k < layers; ++k)
        for (const Polygon& base : bases) {
            std::vector<Polygon> faces(2);
            for (std::size_t i = 0; i < base.size(); ++i) {
                const int a = base[i] + k * n, b = base[(i + 1) % base.size()] + k * n;
                faces[0].push_back(a);
                faces[1].push_back(a + n);
                faces.push_back({a, b, b + n, a + n});
            }
            mesh.cells.push_back(faces);
        }
    return mesh;
}

/// Two prisms of triangles in each of n x n x n cubes.
inline PolyMesh prisms(int n)
{
    std::vector<Vector> points = grid_points(n);
    points.resize(static_cast<std::size_t>((n + 1) * (n + 1)));
    std::vector<Polygon> bases;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = i + (n + 1) * j, b = a + 1, c = b + n + 1, d = a + n + 1;
            bases.push_back({a, b, c});
            bases.push_back({a, c, d});
        }
    return columns(points, bases, n);
}

/// Polyhedra of five to ten or so faces: the Voronoi cells of `seeds` random points of the unit square, in layers.
inline PolyMesh polyhedra(int seeds, int layers)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Vector> centres;
    for (int i = 0; i < seeds; ++i)
        centres.emplace_back(uniform(random), uniform(random), 0);

    std::vector<Vector> points;
    const auto number = [&points](const Vector& p) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if ((points[i] - p).norm() < 1e-9) return static_cast<int>(i);  // the same corner, of another cell
        points.push_back(p);
        return static_cast<int>(points.size()) - 1;
    };
    std::vector<Polygon> bases;
    for (const Vector& centre : centres) {
        std::vector<Vector> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        for (const Vector& other : centres) {
            if (&other == &centre) continue;
            const Vector normal = other - centre, middle = 0.5 * (other + centre);
            std::vector<Vector> kept;  // on this side of the bisector
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Vector &a = corners[i], &b = corners[(i + 1) % corners.size()];
                const double of_a = normal.dot(a - middle), of_b = normal.dot(b - middle);
                if (of_a <= 0) kept.push_back(a);
                if (of_a * of_b < 0) kept.emplace_back(a + of_a / (of_a - of_b) * (b - a));
            }
            corners = kept;
        }
        Polygon base;
        for (const Vector& corner : corners)
            base.push_back(number(corner));
        bases.push_back(base);
    }
    return columns(points, bases, layers);
}

/// No face stands square to an axis: the cube leans.
inline PolyMesh leaning(PolyMesh mesh)
{
    for (Vector& p : mesh.points)
        p = Vector(p.x() + 0.3 * p.y() + 0.2 * p.z(), p.y() - 0.15 * p.z(), p.z() + 0.1 * p.x());
    return mesh;
}

/// Cell by cell a rank: slices along x with as many cells each, so that cuts go through the slanted faces of cells.
inline std::vector<int> sliced(const PolyMesh& mesh, int ranks)
{
    std::vector<double> x;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        x.push_back(mesh.middle(c).x());
    std::vector<double> sorted = x;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> rank_of_cell;
    for (const double of_cell : x) {
        const auto before = std::lower_bound(sorted.begin(), sorted.end(), of_cell) - sorted.begin();
        rank_of_cell.push_back(static_cast<int>(before * ranks / static_cast<long>(x.size())));
    }
    return rank_of_cell;
}

}  // namespace interphase::testing_gas
