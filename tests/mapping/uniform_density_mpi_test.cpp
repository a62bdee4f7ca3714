// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids spread evenly over a mesh give every cell the same solid fraction, whatever the shape of the cells and the size
// of the spheres: at walls, where cell sizes jump, on all ranks.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mapping/joints.hpp"
#include "support/mesh_zoo.hpp"
#include "support/sizings.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// Relative, of sums of some hundred terms after up to some hundred sweeps of the diffusion.
constexpr double rounding = 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A sphere at the middle of each tetrahedron between the centre of a cell, that of one of its faces, the middle of an edge
/// of it and one end: weights are linear in each of them, so a sum over these is an integral over the mesh. `share` [m3]:
/// the tetrahedron's volume, the number of the sphere in its order.
struct EvenlySpread {
    Spheres spheres;
    Scalars share;
};

EvenlySpread evenly_spread(const WholeMesh& mesh, const std::function<double(std::size_t)>& diameter)
{
    const MeshView view = whole_view(mesh);
    EvenlySpread all;
    for (const MeshView::Face& face : view.faces)
        for (const int cell : {face.owner, face.neighbour})
            for (std::size_t k = 0; cell >= 0 && k < face.points.size(); ++k) {
                const Vector ends[2] = {view.points[at(face.points[k])],
                                        view.points[at(face.points[(k + 1) % face.points.size()])]};
                const Vector middle = 0.5 * (ends[0] + ends[1]), &centre = view.centre[at(cell)];
                for (const Vector& end : ends) {
                    const Vector a = face.centre - centre, b = middle - centre, c = end - centre;
                    all.share.push_back(std::abs(a.dot(b.cross(c))) / 6);
                    all.spheres.add(centre + 0.25 * (a + b + c), cell, sphere_volume(diameter(all.spheres.size())));
                }
            }
    return all;
}

class UniformDensity : public testing::TestWithParam<NamedMesh> {};

INSTANTIATE_TEST_SUITE_P(, UniformDensity, testing::ValuesIn(mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

/// The largest relative error of a cell's solid volume.
double error_of_filling(const WholeMesh& mesh, const Sizing& sizing)
{
    const EvenlySpread even = evenly_spread(mesh, sizing.diameter);
    MappedSpheres p(world(), mesh, even.spheres, sizing.rules);
    const Scalars volume = p.mapping.solid_volume(p.of_particles([&](std::size_t i) { return even.share[i]; }));
    double largest = 0;
    for (std::size_t c = 0; c < volume.size(); ++c)
        largest = std::max(largest, std::abs(volume[c] / p.view.volume[c] - 1));
    return world().max(largest);
}

TEST_P(UniformDensity, FillsEveryCellWithItsOwnVolume)
{
    const NamedMesh& each = GetParam();
    for (const Sizing& sizing : sizings()) {
        // Spheres of several sizes share each cell, but not evenly.
        if (!each.plane || sizing.name == "d = 0.2 to 2") continue;
        EXPECT_LT(error_of_filling(each.mesh, sizing), rounding) << sizing.name;
    }
}

TEST(UniformDensityBetweenWarpedFaces, FillsEveryCellWithinTheSquareOfTheWarp)
{
    // Faces count as planes, which their corners miss by up to `by` in cells of 1: to first order what one cell gets too
    // much for that its neighbour gets as well. The factor is measured: 0.023, and as large at half the warp.
    for (const double by : {0.04, 0.08, 0.16, 0.32}) {
        const WholeMesh mesh = shaken_boxes({6, 5, 4}, by);
        for (const Sizing& sizing : sizings()) {
            if (sizing.name == "d = 0.2 to 2") continue;
            EXPECT_LT(error_of_filling(mesh, sizing), 0.03 * by * by) << sizing.name << ", moved by " << by;
        }
    }
}

TEST_P(UniformDensity, OfEachSizeDoesSoInAMixture)
{
    const NamedMesh& each = GetParam();
    if (!each.plane) GTEST_SKIP() << "quadrature is exact between plane faces";
    // the same places twice: for spheres of 1.5 and of 0.15
    EvenlySpread even = evenly_spread(each.mesh, [](std::size_t) { return 1.5; });
    const std::size_t count = even.spheres.size();
    for (std::size_t i = 0; i < count; ++i) {
        even.spheres.add(even.spheres.positions[i], even.spheres.cells[i], sphere_volume(0.15));
        even.share.push_back(2 * even.share[i]);
    }
    MappingRules rules;
    rules.maximum_packing = no_limit;
    MappedSpheres p(world(), each.mesh, even.spheres, rules);
    const Scalars volume = p.mapping.solid_volume(p.of_particles([&](std::size_t i) { return even.share[i]; }));
    for (std::size_t c = 0; c < volume.size(); ++c)
        EXPECT_NEAR(volume[c] / p.view.volume[c], 3.0, 3 * rounding) << "cell " << p.own_cells[c];
}

TEST_P(UniformDensity, SharesOfTheJointsDoSoByThemselves)
{
    // With volumes as the subdivision has them, warped faces are no exception.
    const WholeMesh& mesh = GetParam().mesh;
    const Partition partition = Partition::at_random(mesh.cells, world().size());
    const MeshView view = mesh.part(partition.rank_of, partition.number_on, world().rank());
    const CellSubdivision subdivision(view);
    const Joints joints(world(), view, subdivision);
    Scalars integral(joints.count(), 0.0);  // of each joint's function over the mesh [m3]
    for (std::size_t c = 0; c < view.size(); ++c)
        subdivision.for_each_tetrahedron(c, [&](int face, int edge, int corner, double volume) {
            if (face < 0)
                integral[at(joints.of_cell(c))] += volume;
            else
                for (const int joint : {joints.of_cell(c), joints.of_face(face), joints.of_edge(face, edge),
                                        joints.of_corner(face, corner)})
                    integral[at(joint)] += volume / 4;
        });
    Scalars shared, sum_of_shared, sum(joints.count(), 0.0);  // of shares
    for (const int joint : joints.shared())
        shared.push_back(integral[at(joint)]);
    joints.sum_shared(shared);
    for (std::size_t n = 0; n < shared.size(); ++n)
        integral[at(joints.shared()[n])] = shared[n];

    Scalars filled(view.size(), 0.0);
    for (std::size_t j = 0; j < joints.count(); ++j)
        for (const Joints::Share& share : joints.shares(static_cast<int>(j))) {
            EXPECT_GE(share.part, 0.0);
            filled[at(share.cell)] += share.part * integral[j];
            sum[j] += share.part;
        }
    for (std::size_t c = 0; c < view.size(); ++c)
        EXPECT_NEAR(filled[c] / view.volume[c], 1.0, rounding);
    for (const int joint : joints.shared())
        sum_of_shared.push_back(sum[at(joint)]);
    joints.sum_shared(sum_of_shared);
    for (std::size_t n = 0; n < sum_of_shared.size(); ++n)
        sum[at(joints.shared()[n])] = sum_of_shared[n];
    for (const double one : sum)
        EXPECT_NEAR(one, 1.0, rounding);
}

}  // namespace
