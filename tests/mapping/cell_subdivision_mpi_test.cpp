// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions on cells of every shape: at least zero, one in sum, each one at its own joint, alike for the two cells
// at a face; their integrals fill the cell.
#include "mapping/cell_subdivision.hpp"

#include <gtest/gtest.h>

#include <map>

#include "support/mapped_spheres.hpp"
#include "support/mesh_zoo.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// Absolute, of sums of eight terms of order one.
constexpr double rounding = 1e-13;
/// Of functions, whose coordinates divide by heights of tetrahedra, a tenth and more, once and again.
constexpr double rounding_of_places = 1e-11;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// One mesh's part of this rank, subdivided.
struct Subdivided {
    explicit Subdivided(const WholeMesh& mesh)
        : partition(Partition::at_random(mesh.cells, world().size())),
          view(mesh.part(partition.rank_of, partition.number_on, world().rank())),
          joints(world(), view),
          cells(view, joints)
    {}

    /// Value of each joint's function; those not named are 0.
    std::map<int, double> functions(const Vector& point, int cell) const
    {
        const CellSubdivision::Place place = cells.place(point, at(cell));
        const std::array<double, 8> values = place.functions();
        std::map<int, double> functions;
        for (std::size_t n = 0; n < 8; ++n)
            if (cells.corner(place.corner)[n] >= 0)
                functions[cells.corner(place.corner)[n]] += values[n];
            else
                EXPECT_EQ(values[n], 0.0);
        return functions;
    }

    Partition partition;
    MeshView view;
    JointNumbering joints;
    CellSubdivision cells;
};

std::vector<int> cells_at(const MeshView::Face& face)
{
    return face.neighbour < 0 ? std::vector<int>{face.owner} : std::vector<int>{face.owner, face.neighbour};
}

TEST(CellSubdivision, FunctionsAreAtLeastZeroAndSumToOne)
{
    for (const NamedMesh& each : mesh_zoo()) {
        const Subdivided mesh(each.mesh);
        const Spheres points = scattered(each.mesh, 500, [](std::size_t) { return 1.0; });
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t cell = at(points.cells[i]);
            if (mesh.partition.rank_of[cell] != world().rank()) continue;
            double sum = 0;
            for (const auto& [joint, value] : mesh.functions(points.positions[i], mesh.partition.number_on[cell])) {
                EXPECT_GE(value, -rounding) << each.name;
                sum += value;
            }
            EXPECT_NEAR(sum, 1.0, rounding) << each.name;
        }
    }
}

TEST(CellSubdivision, IntegralsFillTheCell)
{
    for (const NamedMesh& each : mesh_zoo()) {
        const Subdivided mesh(each.mesh);
        for (std::size_t c = 0; c < mesh.view.size(); ++c) {
            double sum = 0;
            mesh.cells.for_each_integral(c, [&](int, double integral) {
                EXPECT_GE(integral, 0.0);
                sum += integral;
            });
            EXPECT_NEAR(sum / mesh.view.volume[c], 1.0, 10 * rounding) << each.name << " cell " << c;
        }
    }
}

TEST(CellSubdivision, AtItsJointAFunctionIsOne)
{
    for (const NamedMesh& each : plane_meshes()) {
        const Subdivided mesh(each.mesh);
        for (std::size_t c = 0; c < mesh.view.size(); ++c)
            EXPECT_NEAR(mesh.functions(mesh.view.centre[c], static_cast<int>(c))[static_cast<int>(c)], 1.0,
                        rounding_of_places)
                << each.name;
        for (std::size_t f = 0; f < mesh.view.faces.size(); ++f) {
            const MeshView::Face& face = mesh.view.faces[f];
            const int number = static_cast<int>(f);
            for (const int cell : cells_at(face)) {
                const auto expect_one = [&](const Vector& point, int joint) {
                    EXPECT_NEAR(mesh.functions(point, cell)[joint], 1.0, rounding_of_places)
                        << each.name << ", cell " << cell << " at " << point.transpose();
                };
                expect_one(face.centre, mesh.joints.of_face(number));
                for (std::size_t k = 0; k < face.points.size(); ++k) {
                    const Vector &a = mesh.view.points[at(face.points[k])],
                                 &b = mesh.view.points[at(face.points[(k + 1) % face.points.size()])];
                    expect_one(a, mesh.joints.of_corner(number, static_cast<int>(k)));
                    expect_one(0.5 * (a + b), mesh.joints.of_edge(number, static_cast<int>(k)));
                }
            }
        }
    }
}

TEST(CellSubdivision, BothCellsSeeAPointOfTheirFaceAlike)
{
    for (const NamedMesh& each : plane_meshes()) {
        const Subdivided mesh(each.mesh);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> part(0, 1);
        for (const MeshView::Face& face : mesh.view.faces) {
            if (face.neighbour < 0) continue;
            const auto corner = [&](std::size_t k) -> Vector {
                return mesh.view.points[at(face.points[k % face.points.size()])] - face.centre;
            };
            for (std::size_t k = 0; k < face.points.size(); ++k) {
                const double u = part(random), v = (1 - u) * part(random);
                const Vector x = face.centre + u * corner(k) + v * corner(k + 1);
                std::map<int, double> difference = mesh.functions(x, face.owner);
                for (const auto& [joint, value] : mesh.functions(x, face.neighbour))
                    difference[joint] -= value;
                for (const auto& [joint, off] : difference)
                    EXPECT_NEAR(off, 0.0, rounding_of_places) << each.name << " at " << x.transpose();
            }
        }
    }
}

}  // namespace
