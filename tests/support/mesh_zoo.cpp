// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/mesh_zoo.hpp"

#include <algorithm>

#include "support/box_mesh.hpp"

namespace interphase::test {

namespace {

WholeMesh periodic(WholeMesh mesh, const std::vector<Vector>& shifts)
{
    for (const Vector& shift : shifts)
        mesh.glue_sides(shift);
    return mesh;
}

}  // namespace

std::vector<NamedMesh> mesh_zoo()
{
    const Vector x = Vector::UnitX(), y = Vector::UnitY(), z = Vector::UnitZ();
    return {
        {"uniform", WholeMesh::of_boxes(unit_planes({6, 5, 4}))},
        {"graded",
         WholeMesh::of_boxes({graded_planes(0, 6, 6, 1.3), graded_planes(0, 5, 5, 1.0), graded_planes(0, 4, 8, 0.7)})},
        {"shaken", shaken_boxes({6, 5, 4}, 0.15), false},
        {"refinedHalf", refined_boxes({3, 3, 3}, [](int, int, int k) { return k == 0; })},
        {"refinedHereAndThere", refined_boxes({3, 3, 3}, [](int i, int j, int k) { return (i + j + 2 * k) % 4 == 0; })},
        {"tetrahedra", tetrahedra({3, 3, 2})},
        {"prisms", prisms({5, 4, 3})},
        {"pyramids", pyramids({3, 3, 3})},
        {"hexagonalPrisms", hexagonal_prisms({5, 5, 4})},
        {"truncatedOctahedra", truncated_octahedra({4, 4, 3})},
        {"lShaped", l_shaped_cells(l_shaped_blocks), true, false},
        {"cyclicInOne", WholeMesh::of_boxes(unit_planes({5, 4, 4}), {true, false, false})},
        {"cyclicInTwo", WholeMesh::of_boxes(unit_planes({5, 4, 4}), {true, true, false})},
        {"cyclicInThree", WholeMesh::of_boxes(unit_planes({5, 4, 4}), {true, true, true})},
        {"cyclicAndTwoCells", WholeMesh::of_boxes(unit_planes({6, 2, 4}), {true, true, false})},
        {"cyclicAndOneCell", WholeMesh::of_boxes(unit_planes({6, 1, 4}), {true, true, false})},
        {"cyclicTetrahedra", periodic(tetrahedra({3, 2, 2}), {3 * x, 2 * y, 2 * z})},
        {"cyclicRefined", periodic(refined_boxes({3, 3, 3}, [](int, int j, int) { return j == 1; }), {6 * x, 6 * z})},
        {"baffle", with_baffle(WholeMesh::of_boxes(unit_planes({6, 4, 4})),
                               [](const Vector& f) { return f.x() == 3 && f.z() < 3; })},
    };
}

std::vector<NamedMesh> plane_meshes()
{
    std::vector<NamedMesh> meshes = mesh_zoo();
    meshes.erase(std::remove_if(meshes.begin(), meshes.end(), [](const NamedMesh& each) { return !each.plane; }),
                 meshes.end());
    return meshes;
}

}  // namespace interphase::test
