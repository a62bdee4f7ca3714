// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight paths from cell to cell end where a line in the box that the mesh fills ends, thrown back by its walls, or
// brought in again on the other side of a cyclic pair.
#include "mapping/straight_paths.hpp"

#include <gtest/gtest.h>

#include "support/mapped_spheres.hpp"
#include "support/mesh_zoo.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Meshes that fill a box, and across which of its sides they are cyclic.
struct Filled {
    NamedMesh named;
    std::array<bool, 3> cyclic;
};
std::vector<Filled> meshes()
{
    std::vector<Filled> all;
    for (const NamedMesh& each : plane_meshes()) {
        if (each.name == "hexagonalPrisms" || each.name == "truncatedOctahedra" || each.name == "baffle") continue;
        std::array<bool, 3> cyclic{};
        if (each.name == "cyclicInOne") cyclic = {true, false, false};
        if (each.name == "cyclicInTwo" || each.name == "cyclicAndTwoCells" || each.name == "cyclicAndOneCell")
            cyclic = {true, true, false};
        if (each.name == "cyclicInThree" || each.name == "cyclicTetrahedra") cyclic = {true, true, true};
        if (each.name == "cyclicRefined") cyclic = {true, false, true};
        all.push_back({each, cyclic});
    }
    return all;
}

/// Into the box from `low` to `high`: a number of times thrown back, or moved by its length.
double folded(double x, double low, double high, bool cyclic)
{
    const double length = high - low, period = cyclic ? length : 2 * length;
    double off = std::fmod(x - low, period);
    if (off < 0) off += period;
    return low + (off > length ? period - off : off);
}

TEST(StraightPaths, EndWhereALineInTheBoxEnds)
{
    for (const auto& [each, cyclic] : meshes()) {
        const MeshView view = whole_view(each.mesh);
        const JointNumbering numbering(alone(), view);
        const CellSubdivision subdivision(view, numbering);
        const StraightPaths paths(view, subdivision);
        Box box = empty_box();
        for (const Vector& x : view.points)
            extend(box, x);
        Spheres starts = scattered(each.mesh, 3000, [](std::size_t) { return 1.0; });
        for (const MeshView::Face& face : view.faces)
            for (const int cell : {face.owner, face.neighbour})
                for (std::size_t k = 0; cell >= 0 && k < face.points.size(); ++k) {
                    // next to an edge, and to a corner
                    const Vector &a = view.points[at(face.points[k])],
                                 &b = view.points[at(face.points[(k + 1) % face.points.size()])];
                    for (const Vector& x : {Vector(0.3 * a + 0.7 * b), a})
                        starts.add(x + 1e-7 * (view.centre[at(cell)] - x), cell, 1.0);
                }
        std::mt19937 random(2);
        std::normal_distribution<double> normal;
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const Vector way(normal(random), normal(random), normal(random)), &start = starts.positions[i];
            Vector end;
            for (int axis = 0; axis < 3; ++axis)
                end[axis] = folded(start[axis] + way[axis], box(axis, 0), box(axis, 1), cyclic[at(axis)]);
            const Vector& centre = view.centre[at(starts.cells[i])];
            StraightPaths::Path path{starts.cells[i], start - centre, start + way - centre};
            for (int face = paths.follow(path); face >= 0; face = paths.follow(path))
                path = paths.enter(view.faces[at(face)].partner, path.at, path.to, path.faces);
            const Vector reached = view.centre[at(path.cell)] + path.to;
            // of a way of some cells over some faces
            EXPECT_LT((reached - end).norm(), 1e-12)
                << each.name << ", from " << start.transpose() << " by " << way.transpose();
            EXPECT_TRUE(subdivision.holds(path.to * (1 - 1e-9), at(path.cell)))
                << each.name << ", from " << start.transpose() << " by " << way.transpose();
        }
    }
}

}  // namespace
