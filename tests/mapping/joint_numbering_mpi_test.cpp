// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces, edges and corners of cells are one: counted, they have the Euler characteristic of the space that the
// mesh fills, corners - edges + faces - cells, whatever the shape of the cells and however they are spread over the
// ranks.
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

/// Joints are counted on the rank that their labels began on, which has them itself.
long distinct(const std::set<int>& joints, const JointNumbering& numbering)
{
    long begun = 0;
    for (const int joint : joints)
        begun += numbering.home(numbering.label(joint)) == world().rank();
    return world().sum(begun);
}

MeshView part_of(const WholeMesh& mesh, unsigned seed)
{
    const Partition partition = Partition::at_random(mesh.cells, world().size(), seed);
    return mesh.part(partition.rank_of, partition.number_on, world().rank());
}

Counts count(const WholeMesh& mesh, unsigned seed = 1)
{
    const MeshView view = part_of(mesh, seed);
    const JointNumbering numbering(world(), view);
    std::set<int> corners, edges, faces;
    for (std::size_t f = 0; f < view.faces.size(); ++f) {
        faces.insert(numbering.of_face(static_cast<int>(f)));
        for (std::size_t k = 0; k < view.faces[f].points.size(); ++k) {
            corners.insert(numbering.of_corner(static_cast<int>(f), static_cast<int>(k)));
            edges.insert(numbering.of_edge(static_cast<int>(f), static_cast<int>(k)));
        }
    }
    EXPECT_EQ(numbering.count(), view.size() + corners.size() + edges.size() + faces.size());
    return {distinct(corners, numbering), distinct(edges, numbering), distinct(faces, numbering),
            static_cast<long>(mesh.cells)};
}

constexpr long nx = 4, ny = 3, nz = 5;

WholeMesh box(const std::array<bool, 3>& periodic = {})
{
    return WholeMesh::of_boxes(unit_planes({nx, ny, nz}), periodic);
}

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
        // Cyclic sides make a ring of it, a torus or both by an interval: 0. What has neither is a ball, 1; a baffle
        // that reaches three of its sides leaves it one.
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
    double last = 0;
    for (std::size_t j = view.size(); j < numbering.count(); ++j)
        last = std::max(last, static_cast<double>(numbering.label(static_cast<int>(j))));
    Scalars on_side[2];  // [all labels]: whether it is there
    for (Scalars& side : on_side)
        side.assign(static_cast<std::size_t>(world().max(last)) + 1, 0.0);
    for (std::size_t f = 0; f < view.faces.size(); ++f) {
        const MeshView::Face& face = view.faces[f];
        Scalars& side = on_side[view.centre[static_cast<std::size_t>(face.owner)].x() > 2];
        const auto set = [&](int joint) { side[static_cast<std::size_t>(numbering.label(joint))] = 1; };
        for (std::size_t k = 0; k < face.points.size(); ++k)
            if (view.points[static_cast<std::size_t>(face.points[k])].x() == 2)
                set(numbering.of_corner(static_cast<int>(f), static_cast<int>(k)));
        if (face.centre.x() == 2) set(numbering.of_face(static_cast<int>(f)));
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
