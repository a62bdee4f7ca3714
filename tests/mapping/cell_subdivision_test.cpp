// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tetrahedra that cells are cut into: they fill the cell, a point has coordinates in one of them, and the two cells at a
// face see a point of it alike.
#include "mapping/cell_subdivision.hpp"

#include <gtest/gtest.h>

#include <map>

#include "support/mapped_spheres.hpp"
#include "support/mesh_zoo.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// Sums of some ten terms of order one; coordinates divide by the height of a tetrahedron, at least a tenth.
constexpr double rounding = 1e-13;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A place by what it is near, whichever of the tetrahedra that meet there it was given to: -1 the cell's centre, then the
/// centre of the face, the middle of the edge by its two points, and the corner.
std::map<std::array<int, 3>, double> coordinates(const MeshView& mesh, const CellSubdivision::Place& place)
{
    const std::vector<int>& points = mesh.faces[at(place.face)].points;
    const int a = points[at(place.edge)], b = points[(at(place.edge) + 1) % points.size()];
    std::map<std::array<int, 3>, double> all;
    all[{0, -1, -1}] += place.in_cell;
    all[{1, place.face, -1}] += place.on_face;
    all[{2, std::min(a, b), std::max(a, b)}] += place.on_edge;
    all[{3, points[at(place.corner)], -1}] += place.on_corner;
    return all;
}

double coordinate(const MeshView& mesh, const CellSubdivision::Place& place, const std::array<int, 3>& vertex)
{
    const auto all = coordinates(mesh, place);
    const auto found = all.find(vertex);
    return found == all.end() ? 0.0 : found->second;
}

std::vector<int> cells_at(const MeshView::Face& face)
{
    return face.neighbour < 0 ? std::vector<int>{face.owner} : std::vector<int>{face.owner, face.neighbour};
}

TEST(CellSubdivision, CoordinatesAreAtLeastZeroAndSumToOne)
{
    for (const NamedMesh& each : mesh_zoo()) {
        const CellSubdivision subdivision(whole_view(each.mesh));
        const Spheres points = scattered(each.mesh, 500, [](std::size_t) { return 1.0; });
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto place = subdivision.place(points.positions[i], at(points.cells[i]));
            for (const double part : {place.in_cell, place.on_face, place.on_edge, place.on_corner})
                EXPECT_GE(part, 0.0) << each.name;
            EXPECT_NEAR(place.in_cell + place.on_face + place.on_edge + place.on_corner, 1.0, rounding) << each.name;
        }
    }
}

TEST(CellSubdivision, CoordinatesGiveThePointBack)
{
    for (const NamedMesh& each : plane_meshes()) {
        const MeshView view = whole_view(each.mesh);
        const CellSubdivision subdivision(view);
        const Spheres points = scattered(each.mesh, 500, [](std::size_t) { return 1.0; });
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t cell = at(points.cells[i]);
            const auto place = subdivision.place(points.positions[i], cell);
            const MeshView::Face& face = view.faces[at(place.face)];
            const Vector &a = view.points[at(face.points[at(place.edge)])],
                         &b = view.points[at(face.points[(at(place.edge) + 1) % face.points.size()])];
            const Vector again = place.in_cell * view.centre[cell] + place.on_face * face.centre +
                                 place.on_edge * 0.5 * (a + b) +
                                 place.on_corner * view.points[at(face.points[at(place.corner)])];
            // coordinates are of order ten
            EXPECT_LT((again - points.positions[i]).norm(), 100 * rounding) << each.name << " cell " << cell;
        }
    }
}

TEST(CellSubdivision, TetrahedraFillTheCell)
{
    for (const NamedMesh& each : mesh_zoo()) {
        const MeshView view = whole_view(each.mesh);
        const CellSubdivision subdivision(view);
        for (std::size_t c = 0; c < view.size(); ++c) {
            double sum = 0, of_centre = 0;
            subdivision.for_each_tetrahedron(c, [&](int face, int, int, double volume) {
                EXPECT_GE(volume, 0.0);
                sum += volume;
                if (face < 0) of_centre += volume;
            });
            EXPECT_NEAR(sum / view.volume[c], 1.0, rounding) << each.name << " cell " << c;
            // Nothing is left for the centre where faces are plane; warped ones, taken as plane, leave about the square of
            // the angle by which their corners are off, which is up to 0.15.
            EXPECT_LE(of_centre / view.volume[c], each.plane ? rounding : 0.05) << each.name << " cell " << c;
        }
    }
}

TEST(CellSubdivision, AtItsVerticesACoordinateIsOne)
{
    for (const NamedMesh& each : plane_meshes()) {
        const MeshView view = whole_view(each.mesh);
        const CellSubdivision subdivision(view);
        const double off = 100 * rounding;
        for (std::size_t c = 0; c < view.size(); ++c)
            EXPECT_NEAR(subdivision.place(view.centre[c], c).in_cell, 1.0, off) << each.name;
        for (std::size_t f = 0; f < view.faces.size(); ++f) {
            const MeshView::Face& face = view.faces[f];
            for (const int cell : cells_at(face)) {
                const auto expect_one = [&](const Vector& point, const std::array<int, 3>& vertex) {
                    EXPECT_NEAR(coordinate(view, subdivision.place(point, at(cell)), vertex), 1.0, off)
                        << each.name << " face " << f << " of cell " << cell << " at " << point.transpose();
                };
                expect_one(face.centre, {1, static_cast<int>(f), -1});
                for (std::size_t k = 0; k < face.points.size(); ++k) {
                    const int a = face.points[k], b = face.points[(k + 1) % face.points.size()];
                    expect_one(view.points[at(a)], {3, a, -1});
                    expect_one(0.5 * (view.points[at(a)] + view.points[at(b)]), {2, std::min(a, b), std::max(a, b)});
                }
            }
        }
    }
}

TEST(CellSubdivision, BothCellsSeeAPointOfTheirFaceAlike)
{
    for (const NamedMesh& each : plane_meshes()) {
        const MeshView view = whole_view(each.mesh);
        const CellSubdivision subdivision(view);
        std::mt19937 random(1);
        for (const MeshView::Face& face : view.faces) {
            if (face.neighbour < 0) continue;
            for (int n = 0; n < 5; ++n) {
                const std::size_t k = std::uniform_int_distribution<std::size_t>(0, face.points.size() - 1)(random);
                double u = std::uniform_real_distribution<double>()(random), v = std::uniform_real_distribution<double>()(random);
                if (u + v > 1) u = 1 - u, v = 1 - v;
                const Vector x = face.centre + u * (view.points[at(face.points[k])] - face.centre) +
                                 v * (view.points[at(face.points[(k + 1) % face.points.size()])] - face.centre);
                const auto here = subdivision.place(x, at(face.owner)), there = subdivision.place(x, at(face.neighbour));
                auto difference = coordinates(view, here);
                for (const auto& [vertex, weight] : coordinates(view, there))
                    difference[vertex] -= weight;
                for (const auto& [vertex, off] : difference)
                    EXPECT_NEAR(off, 0.0, 100 * rounding) << each.name << " at " << x.transpose();
            }
        }
    }
}

}  // namespace
