// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces, edges and corners of cells are one: counted, they have the Euler characteristic of the space that the mesh
// fills, corners - edges + faces - cells, whatever the shape of the cells and however they are spread over the ranks.
#include "mapping/joint_numbering.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/mapped_spheres.hpp"
#include "support/mesh_zoo.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

struct Counts {
    long corners, edges, faces, cells;

    long euler() const { return corners - edges + faces - cells; }
};

/// Labels are counted on the rank on which they began, which has them itself.
long distinct(const std::vector<std::int64_t>& labels, const JointNumbering& numbering)
{
    const auto rank = static_cast<std::size_t>(world().rank());
    std::set<std::int64_t> begun;
    for (const std::int64_t label : labels)
        if (label >= numbering.first_of_rank[rank] && label < numbering.first_of_rank[rank + 1]) begun.insert(label);
    return world().sum(static_cast<long>(begun.size()));
}

MeshView part_of(const WholeMesh& mesh, unsigned seed)
{
    const Partition partition = Partition::at_random(mesh.cells, world().size(), seed);
    return mesh.part(partition.rank_of, partition.number_on, world().rank());
}

Counts count(const WholeMesh& mesh, unsigned seed = 1)
{
    const JointNumbering numbering(world(), part_of(mesh, seed));
    return {distinct(numbering.of_corner, numbering), distinct(numbering.of_edge, numbering),
            distinct(numbering.of_face, numbering), static_cast<long>(mesh.cells)};
}

constexpr long nx = 4, ny = 3, nz = 5;

WholeMesh box(const std::array<bool, 3>& periodic = {}) { return WholeMesh::of_boxes(unit_planes({nx, ny, nz}), periodic); }

TEST(JointNumbering, ABoxHasTheFacesEdgesAndCornersOfItsGrid)
{
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Counts n = count(box(), seed);
        EXPECT_EQ(n.corners, (nx + 1) * (ny + 1) * (nz + 1));
        EXPECT_EQ(n.edges, nx * (ny + 1) * (nz + 1) + (nx + 1) * ny * (nz + 1) + (nx + 1) * (ny + 1) * nz);
        EXPECT_EQ(n.faces, (nx + 1) * ny * nz + nx * (ny + 1) * nz + nx * ny * (nz + 1));
    }
}

TEST(JointNumbering, ATorusHasThreeFacesAndEdgesAndOneCornerACell)
{
    // down to one cell, all of whose corners are one
    for (const std::array<int, 3>& n : {std::array{4, 3, 5}, {2, 2, 2}, {3, 1, 2}, {1, 1, 1}}) {
        const Counts counted = count(WholeMesh::of_boxes(unit_planes(n), {true, true, true}));
        EXPECT_EQ(counted.corners, counted.cells);
        EXPECT_EQ(counted.edges, 3 * counted.cells);
        EXPECT_EQ(counted.faces, 3 * counted.cells);
    }
}

TEST(JointNumbering, HasTheEulerCharacteristicOfTheSpace)
{
    for (const NamedMesh& each : mesh_zoo()) {
        // Cyclic sides make a ring of it, a torus or both by an interval: 0. What has neither is a ball, 1; a baffle that
        // reaches three of its sides leaves it one.
        const long expected = each.name.find("cyclic") == 0 ? 0 : 1;
        EXPECT_EQ(count(each.mesh).euler(), expected) << each.name;
    }
    // a baffle within it makes a hollow of the ball, one across it two balls
    const auto within = [](const Vector& f) { return f.x() == 2 && f.y() > 1 && f.y() < 2 && f.z() > 1 && f.z() < 4; };
    EXPECT_EQ(count(with_baffle(box(), within)).euler(), 2);
    EXPECT_EQ(count(with_baffle(box(), [](const Vector& f) { return f.x() == 2; })).euler(), 2);
}

TEST(JointNumbering, TheTwoSidesOfABaffleDiffer)
{
    // labels of what lies in the plane x = 2, by the side on which the cell lies
    const MeshView view = part_of(with_baffle(box(), [](const Vector& f) { return f.x() == 2; }), 1);
    const JointNumbering numbering(world(), view);
    Scalars on_side[2];  // [all labels]: whether it is there
    for (Scalars& side : on_side)
        side.assign(static_cast<std::size_t>(numbering.first_of_rank.back()), 0.0);
    std::size_t slot = 0;
    for (std::size_t f = 0; f < view.faces.size(); ++f) {
        const MeshView::Face& face = view.faces[f];
        const bool right = view.centre[static_cast<std::size_t>(face.owner)].x() > 2;
        for (const int p : face.points) {
            if (view.points[static_cast<std::size_t>(p)].x() == 2)
                on_side[right][static_cast<std::size_t>(numbering.of_corner[slot])] = 1;
            ++slot;
        }
        if (face.centre.x() == 2) on_side[right][static_cast<std::size_t>(numbering.of_face[f])] = 1;
    }
    long labels = 0;
    for (Scalars& side : on_side)
        world().sum(side);
    for (std::size_t label = 0; label < on_side[0].size(); ++label) {
        EXPECT_FALSE(on_side[0][label] > 0 && on_side[1][label] > 0) << label;
        labels += (on_side[0][label] > 0) + (on_side[1][label] > 0);
    }
    EXPECT_EQ(labels, 2 * (ny * nz + (ny + 1) * (nz + 1)));  // faces and corners of the plane, on each side
}

}  // namespace
