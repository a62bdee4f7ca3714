// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every point of a mesh is in one of its cells, however they are shaped: warped faces leave neither gaps nor overlaps.
#include "mapping/cell_surfaces.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/mapped_spheres.hpp"
#include "support/mesh_zoo.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

std::vector<std::size_t> holders(const CellSurfaces& surfaces, std::size_t cells, const Vector& point)
{
    std::vector<std::size_t> all;
    for (std::size_t c = 0; c < cells; ++c)
        if (surfaces.holds(point, c)) all.push_back(c);
    return all;
}

class OnTheZoo : public testing::TestWithParam<NamedMesh> {
protected:
    MeshView view_ = whole_view(GetParam().mesh);
    CellSurfaces surfaces_{view_};
};

TEST_P(OnTheZoo, NoPointIsInTwoCells)
{
    const Spheres spheres = scattered(GetParam().mesh, 600, [](std::size_t) { return 1e-3; });
    for (std::size_t i = 0; i + 1 < spheres.size(); i += 2) {
        const Vector between = 0.5 * (spheres.positions[i] + spheres.positions[i + 1]);
        EXPECT_LE(holders(surfaces_, view_.size(), between).size(), 1u) << between.transpose();
    }
}

TEST_P(OnTheZoo, APointOfATetrahedronOfACellIsInThatCell)
{
    const Spheres spheres = scattered(GetParam().mesh, 300, [](std::size_t) { return 1e-3; });
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const auto all = holders(surfaces_, view_.size(), spheres.positions[i]);
        ASSERT_EQ(all.size(), 1u) << spheres.positions[i].transpose();
        if (GetParam().convex) {
            EXPECT_EQ(static_cast<int>(all.front()), spheres.cells[i]);
        }
    }
}

TEST_P(OnTheZoo, PointsOfSymmetryAreInACellOrBesideOne)
{
    // lines from a cell's centre to its corners are where triangles meet: what round-off lets slip through between them
    // is found beside
    const Vector beside = 1e-9 * Vector(0.42, 0.73, 0.54);
    for (const MeshView::Face& face : view_.faces)
        for (const int p : face.points)
            for (const double way : {0.0, 0.25, 0.5, 0.75}) {
                const Vector& centre = view_.centre[static_cast<std::size_t>(face.owner)];
                const Vector point = centre + way * (view_.points[static_cast<std::size_t>(p)] - centre);
                EXPECT_GE(holders(surfaces_, view_.size(), point).size() +
                              holders(surfaces_, view_.size(), point + beside).size(),
                          1u)
                    << point.transpose();
            }
}

TEST_P(OnTheZoo, APointOutsideIsInNone)
{
    Box box = empty_box();
    for (const Vector& point : view_.points)
        extend(box, point);
    const Vector middle = box.rowwise().mean(), half = 0.5 * (box.col(1) - box.col(0));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 200; ++i) {
        Vector to(uniform(random), uniform(random), uniform(random));
        const Vector point = middle + 1.001 / to.cwiseAbs().maxCoeff() * half.cwiseProduct(to);
        EXPECT_TRUE(holders(surfaces_, view_.size(), point).empty()) << point.transpose();
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, OnTheZoo, testing::ValuesIn(mesh_zoo()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
