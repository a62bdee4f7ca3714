// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids spread evenly over a mesh give every cell the same solid fraction, whatever the shape of the cells and the
// size of the spheres: at walls, where cell sizes jump, on all ranks.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mapping/joints.hpp"
#include "support/measured.hpp"
#include "support/mesh_zoo.hpp"
#include "support/sizings.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// Relative, of sums of some thousand terms after up to some hundred sweeps of the diffusion.
constexpr double rounding = 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Gauss's rules for an interval from 0 to 1: exact for polynomials of degrees 11, 7 and 3.
struct Node {
    double at, weight;
};
std::vector<Node> gauss(const std::vector<Node>& positive_half)
{
    std::vector<Node> nodes;
    for (const Node& node : positive_half)
        for (const double sign : {-1.0, 1.0})
            nodes.push_back({0.5 + 0.5 * sign * node.at, 0.5 * node.weight});
    return nodes;
}
const std::vector<Node> six = gauss({{0.2386191860831969, 0.4679139345726910},
                                     {0.6612093864662645, 0.3607615730481386},
                                     {0.9324695142031521, 0.1713244923791704}});
const std::vector<Node> four =
    gauss({{0.3399810435848563, 0.6521451548625461}, {0.8611363115940526, 0.3478548451374538}});
const std::vector<Node> two = gauss({{0.5773502691896257, 1.0}});

/// Small spheres and what each of them stands for [m3].
struct Filling {
    Spheres spheres;
    Scalars share;
};

/// In each tetrahedron between the centre of a cell, that of one of its faces, the middle of an edge of it and one end,
/// at 1 >= A >= B >= C >= 0: the functions of the joints are polynomials of degree 9 in A, 6 in B/A and 3 in C/B, and
/// the volume goes with A^2 (B/A). So a sum over these is an integral over the mesh.
Filling integrated(const WholeMesh& mesh, double diameter)
{
    const MeshView view = whole_view(mesh);
    Filling all;
    for (const MeshView::Face& face : view.faces)
        for (const int cell : {face.owner, face.neighbour})
            for (std::size_t k = 0; cell >= 0 && k < face.points.size(); ++k) {
                const Vector ends[2] = {view.points[at(face.points[k])],
                                        view.points[at(face.points[(k + 1) % face.points.size()])]};
                const Vector &centre = view.centre[at(cell)], middle = 0.5 * (ends[0] + ends[1]);
                for (const Vector& end : ends) {
                    const Vector a = face.centre - centre, b = middle - face.centre, c = end - middle;
                    const double whole = std::abs(a.dot(b.cross(c)));
                    for (const Node& out : six)
                        for (const Node& aside : four)
                            for (const Node& along : two) {
                                all.spheres.add(centre + out.at * (a + aside.at * (b + along.at * c)), cell,
                                                sphere_volume(diameter));
                                all.share.push_back(whole * out.weight * aside.weight * along.weight * out.at * out.at *
                                                    aside.at);
                            }
                }
            }
    return all;
}

/// The largest relative error of a cell's solid volume.
double error_of_filling(const WholeMesh& mesh, const Filling& filling, const MappingRules& rules)
{
    MappedSpheres p(world(), mesh, filling.spheres, rules);
    const Scalars volume = p.mapping.solid_volume(p.of_particles([&](std::size_t i) { return filling.share[i]; }));
    double largest = 0;
    for (std::size_t c = 0; c < volume.size(); ++c)
        largest = std::max(largest, std::abs(volume[c] / p.view.volume[c] - 1));
    return world().max(largest);
}

MappingRules rules_of(MappingType type)
{
    MappingRules rules;
    rules.type = type;
    rules.maximum_packing = no_limit;
    return rules;
}

TEST(UniformDensity, FillsEveryCellWithItsOwnVolume)
{
    // small spheres, which are single points and not spread by diffusion
    double worst = 0;
    for (const NamedMesh& each : plane_meshes())
        worst =
            std::max(worst, error_of_filling(each.mesh, integrated(each.mesh, 0.03), rules_of(MappingType::kernel)));
    expect_below(
        {"a uniform density of solids in " + std::to_string(plane_meshes().size()) +
             " meshes of plane faces (boxes, refined, tetrahedra, prisms, polyhedra): a cell's solid fraction off it",
         "", "exact: cubature"},
        worst, rounding);
    const WholeMesh mesh = tetrahedra({3, 3, 2});
    EXPECT_LT(error_of_filling(mesh, integrated(mesh, 0.03), rules_of(MappingType::cell_centre)), rounding);
}

TEST(UniformDensity, OfEachSizeDoesSoInAMixture)
{
    // the larger ones, single points as well, are spread over the whole mesh
    for (const NamedMesh& each : plane_meshes()) {
        Filling both = integrated(each.mesh, 8.0);
        if (both.share.size() > 200000) continue;  // enough of the others
        const Filling small = integrated(each.mesh, 0.03);
        for (std::size_t i = 0; i < small.share.size(); ++i) {
            both.spheres.add(small.spheres.positions[i], small.spheres.cells[i], small.spheres.volumes[i]);
            both.share[i] *= 0.25;
            both.share.push_back(0.75 * small.share[i]);
        }
        EXPECT_LT(error_of_filling(each.mesh, both, rules_of(MappingType::kernel)), rounding) << each.name;
    }
}

TEST(UniformDensity, FillsCellsBetweenWarpedFacesWithinTheSquareOfTheWarp)
{
    // Faces count as planes, which their corners miss by up to `by` in cells of 1: to first order what one cell gets
    // too much for that its neighbour gets as well. The factor is measured: 0.05 to 0.07 at any warp.
    for (const double by : {0.04, 0.08, 0.16, 0.32}) {
        const WholeMesh mesh = shaken_boxes({4, 4, 3}, by);
        const double error = error_of_filling(mesh, integrated(mesh, 0.03), rules_of(MappingType::kernel));
        EXPECT_LT(error, 0.08 * by * by) << "moved by " << by;
    }
}

TEST(UniformDensity, OfSpheresThatAreSeveralPointsIsWithinOnePercent)
{
    // Where cells and spheres are of one size, each is spread as points, which walls throw back. Places on a lattice of
    // a sixth of the smallest cells, away from its planes.
    constexpr double spacing = 0.1667;
    for (const NamedMesh& each : plane_meshes()) {
        if (!each.convex || each.name == "hexagonalPrisms" || each.name == "truncatedOctahedra" ||
            each.name == "baffle")
            continue;
        const MeshView view = whole_view(each.mesh);
        Box box = empty_box();
        for (const Vector& x : view.points)
            extend(box, x);
        const CellFinder finder(view);
        std::array<int, 3> n;
        for (int axis = 0; axis < 3; ++axis)
            n[at(axis)] = static_cast<int>(std::lround((box(axis, 1) - box(axis, 0)) / spacing));
        Filling filling;
        for (int i = 0; i < n[0]; ++i)
            for (int j = 0; j < n[1]; ++j)
                for (int k = 0; k < n[2]; ++k) {
                    const Vector part((i + 0.5) / n[0], (j + 0.5) / n[1], (k + 0.5) / n[2]);
                    const Vector x = box.col(0) + part.cwiseProduct(box.col(1) - box.col(0));
                    filling.spheres.add(x, finder.cell_at(x), sphere_volume(1.0));
                    filling.share.push_back((box.col(1) - box.col(0)).prod() / n[0] / n[1] / n[2]);
                }
        const double error = error_of_filling(each.mesh, filling, rules_of(MappingType::kernel));

        EXPECT_LT(error, 0.003) << each.name;  // of the lattice, halved with its spacing
    }
}

TEST(UniformDensity, SharesOfTheJointsFillCellsByThemselves)
{
    // With volumes as the subdivision has them, warped faces are no exception.
    for (const NamedMesh& each : mesh_zoo()) {
        const Partition partition = Partition::at_random(each.mesh.cells, world().size());
        const MeshView view = each.mesh.part(partition.rank_of, partition.number_on, world().rank());
        const JointNumbering numbering(world(), view);
        const CellSubdivision subdivision(view, numbering);
        const Joints joints(world(), numbering, subdivision, view.size());
        const auto over_ranks = [&](Scalars& of_joints) {
            Scalars shared;
            for (const int joint : joints.shared())
                shared.push_back(of_joints[at(joint)]);
            joints.sum_shared(shared);
            for (std::size_t n = 0; n < shared.size(); ++n)
                of_joints[at(joints.shared()[n])] = shared[n];
        };
        Scalars integral(joints.count(), 0.0);  // of each joint's function over the mesh [m3]
        for (std::size_t c = 0; c < view.size(); ++c)
            subdivision.for_each_integral(c, [&](int joint, double volume) { integral[at(joint)] += volume; });
        over_ranks(integral);
        Scalars filled(view.size(), 0.0), sum(joints.count(), 0.0);
        for (std::size_t j = 0; j < joints.count(); ++j)
            for (const Joints::Share& share : joints.shares(static_cast<int>(j))) {
                EXPECT_GE(share.part, 0.0);
                filled[at(share.cell)] += share.part * integral[j];
                sum[j] += share.part;
            }
        over_ranks(sum);
        for (std::size_t c = 0; c < view.size(); ++c)
            EXPECT_NEAR(filled[c] / view.volume[c], 1.0, rounding) << each.name;
        for (const double one : sum)
            EXPECT_NEAR(one, 1.0, rounding) << each.name;
    }
}

}  // namespace
