// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nothing passes a baffle, and everything passes cyclic pairs as if they were not there.
#include <gtest/gtest.h>

#include "support/mesh_zoo.hpp"
#include "support/sizings.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// Absolute, of contents and values of order one.
constexpr double rounding = 1e-12;

/// Solid volume in each cell of the whole.
Scalars filled(const WholeMesh& mesh, const Spheres& spheres, const MappingRules& rules)
{
    MappedSpheres p(world(), mesh, spheres, rules);
    return p.of_whole_mesh(p.fill());
}

/// Meshes parted by a baffle of no thickness in x = 3, of side 6.
std::vector<NamedMesh> parted_meshes()
{
    const auto is_baffle = [](const Vector& face) { return std::abs(face.x() - 3) < 1e-9; };
    return {
        {"boxes", with_baffle(WholeMesh::of_boxes(unit_planes({6, 3, 3})), is_baffle)},
        {"cyclic along it", with_baffle(WholeMesh::of_boxes(unit_planes({6, 3, 3}), {false, true, true}), is_baffle)},
        {"tetrahedra", with_baffle(tetrahedra({6, 2, 2}), is_baffle)},
        {"pyramids", with_baffle(pyramids({6, 2, 2}), is_baffle)},
        // boxes of 2, halved up to x = 4
        {"refined", with_baffle(refined_boxes({3, 2, 2}, [](int i, int, int) { return i < 2; }), is_baffle)},
    };
}

TEST(Baffle, KeepsContentsOnTheirSideWholly)
{
    for (const NamedMesh& each : parted_meshes())
        for (const Sizing& sizing : sizings())
            for (const double limit : {no_limit, 0.6}) {
                // spheres on the left, the empty side's cells must have nothing at all
                const MeshView view = whole_view(each.mesh);
                Spheres left;
                const Spheres all = scattered(each.mesh, 300, sizing.diameter);
                for (std::size_t i = 0; i < all.size(); ++i)
                    if (all.positions[i].x() < 3) left.add(all.positions[i], all.cells[i], all.volumes[i]);
                MappingRules rules = sizing.rules;
                rules.maximum_packing = limit;
                MappedSpheres p(world(), each.mesh, left, rules);
                // 0.4 of the left half, up to more than 0.6 here and there
                const double half = 0.5 * p.total(p.view.volume);
                const Scalars solid = p.fill(0.4 * half / p.total(p.volumes));
                for (std::size_t c = 0; c < solid.size(); ++c)
                    if (view.centre[p.own_cells[c]].x() > 3) {
                        EXPECT_EQ(solid[c], 0.0) << each.name << ", " << sizing.name;
                    }
                EXPECT_NEAR(p.total(solid) / half, 0.4, rounding);

                // and what is on the other side is not seen, to the last bit
                const auto seen = [&](double behind) {
                    return p.at_particles(
                        p.of_cells([&](std::size_t c) { return view.centre[c].x() < 3 ? noise(c) : behind; }));
                };
                EXPECT_EQ(seen(1.0), seen(1e6)) << each.name << ", " << sizing.name;
            }
}

TEST(Baffle, ThatEndsIsPassedAroundItsRimOnly)
{
    // In x = 3 up to z = 3 of 4: small spheres right before it reach cells behind only where these meet around its rim.
    const WholeMesh mesh = with_baffle(WholeMesh::of_boxes(unit_planes({6, 3, 4})),
                                       [](const Vector& face) { return face.x() == 3 && face.z() < 3; });
    const MeshView view = whole_view(mesh);
    const CellFinder finder(view);
    MappingRules rules;
    rules.maximum_packing = no_limit;
    const auto behind = [&](const Vector& x) {
        const Scalars weights = weights_of(world(), mesh, x, finder.cell_at(x), 0.1, rules);
        double sum = 0;
        for (std::size_t c = 0; c < mesh.cells; ++c)
            if (view.centre[c].x() > 3) sum += weights[c];
        return sum;
    };
    EXPECT_EQ(behind({2.99, 1.4, 0.5}), 0.0);
    EXPECT_EQ(behind({2.99, 1.4, 2.2}), 0.0);
    EXPECT_GT(behind({2.99, 1.4, 2.9}), 0.1);
    EXPECT_NEAR(behind({2.999999, 1.4, 3.5}), 0.5, 1e-3);
}

/// Copies of spheres and cells, `times` along x, each `length` from the one before; cells of copy n follow those of n -
/// 1 in rows of `row` cells, where rows of copies are joined to longer ones.
Spheres repeated(const Spheres& spheres, int times, double length, int row)
{
    Spheres all;
    for (int n = 0; n < times; ++n)
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const int cell = spheres.cells[i];
            all.add(spheres.positions[i] + Vector(n * length, 0, 0), cell / row * times * row + n * row + cell % row,
                    spheres.volumes[i]);
        }
    return all;
}

TEST(CyclicPair, MakesABoxLikeOneThreeTimesAsLong)
{
    for (const int length : {1, 2, 4})
        for (const Sizing& sizing : sizings()) {
            const WholeMesh short_box = WholeMesh::of_boxes(unit_planes({length, 3, 2}), {true, false, false});
            const WholeMesh long_box = WholeMesh::of_boxes(unit_planes({3 * length, 3, 2}), {true, false, false});
            const Spheres spheres = scattered(short_box, 30, sizing.diameter);
            const Scalars one = filled(short_box, spheres, sizing.rules);
            const Scalars three = filled(long_box, repeated(spheres, 3, length, length), sizing.rules);
            double largest = 0;
            for (const double volume : spheres.volumes)
                largest = std::max(largest, volume);
            for (std::size_t c = 0; c < three.size(); ++c) {
                const auto row = static_cast<std::size_t>(length);
                const std::size_t image = c / (3 * row) * row + c % row;
                EXPECT_NEAR(three[c] / largest, one[image] / largest, 10 * rounding)
                    << sizing.name << ", " << length << " long, cell " << c;
            }
        }
}

TEST(CyclicPair, IsNotSeenBySpheresThatMoveByACell)
{
    // in all directions, of which one is a single cell thick
    const std::array<int, 3> n{5, 4, 1};
    const WholeMesh mesh = WholeMesh::of_boxes(unit_planes(n), {true, true, true});
    const auto number = [&](int i, int j, int k) { return i % n[0] + n[0] * (j % n[1] + n[1] * (k % n[2])); };
    for (const Sizing& sizing : sizings()) {
        const Spheres spheres = scattered(mesh, 30, sizing.diameter);
        const Scalars still = filled(mesh, spheres, sizing.rules);
        double largest = 0;
        for (const double volume : spheres.volumes)
            largest = std::max(largest, volume);
        for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}, {3, 2}}) {
            Spheres moved;
            for (std::size_t i = 0; i < spheres.size(); ++i) {
                const int c = spheres.cells[i], ci = c % n[0], cj = c / n[0] % n[1];
                const Vector x = spheres.positions[i] + Vector((ci + di) % n[0] - ci, (cj + dj) % n[1] - cj, 0);
                moved.add(x, number(ci + di, cj + dj, 0), spheres.volumes[i]);
            }
            const Scalars after = filled(mesh, moved, sizing.rules);
            for (int j = 0; j < n[1]; ++j)
                for (int i = 0; i < n[0]; ++i)
                    EXPECT_NEAR(after[static_cast<std::size_t>(number(i + di, j + dj, 0))] / largest,
                                still[static_cast<std::size_t>(number(i, j, 0))] / largest, 10 * rounding)
                        << sizing.name << ", moved by " << di << " and " << dj;
        }
    }
}

TEST(CyclicPair, OfTetrahedraJoinsWhatAFaceWithinWouldJoin)
{
    // The weights of a sphere at the middle of a box of cubes cut to tetrahedra, and of one at its corner: the same
    // mesh seen from there, as the cut repeats with each cube.
    const std::array<int, 3> n{3, 3, 3};
    WholeMesh mesh = tetrahedra(n);
    for (int axis = 0; axis < 3; ++axis)
        mesh.glue_sides(3 * Vector::Unit(axis));
    const CellFinder finder(whole_view(mesh));
    MappingRules rules;
    rules.maximum_packing = no_limit;
    for (const double diameter : {0.1, 1.0}) {
        const Vector inside(1.93, 1.02, 1.11), across = inside + Vector(1, -1, 1);
        const Scalars a = weights_of(world(), mesh, inside, finder.cell_at(inside), diameter, rules);
        const Scalars b = weights_of(world(), mesh, across, finder.cell_at(across), diameter, rules);
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i)
                    for (int t = 0; t < 6; ++t) {
                        const auto cell = [&](int x, int y, int z) {
                            return static_cast<std::size_t>(6 * (x % 3 + 3 * (y % 3 + 3 * (z % 3))) + t);
                        };
                        EXPECT_NEAR(b[cell(i + 1, j + 2, k + 1)], a[cell(i, j, k)], rounding);
                    }
    }
}

}  // namespace
