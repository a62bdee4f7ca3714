// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mapping on OpenFOAM's meshes of tetrahedra, prisms and polyhedra that lean, of boxes of unequal cells, and of
// cyclic pairs. Weights are polynomials in the tetrahedra between a cell's centre, a face's centre and half an edge:
// particles at the points of Gauss's quadrature in each are a uniform density, and integrate them exactly.
#include "mapping/mapping.hpp"

#include "engines/openfoam/gas_case.hpp"
#include "engines/openfoam/poly_mesh.hpp"
#include "support/world.hpp"

namespace interphase::testing_gas {
namespace {

using test::world;

struct Kind {
    std::string name;
    std::function<PolyMesh()> make;  ///< or a box, periodic in as many directions as `periods` says
    std::optional<Pair> pair;
    int periods = 0;
};

std::unique_ptr<GasCase> opened(const Kind& kind)
{
    Scene scene;
    std::vector<int> rank_of_cell;
    const PolyMesh mesh = kind.make ? leaning(kind.make()) : PolyMesh{};
    if (kind.make) {
        scene.write_mesh = [&](const std::string& folder) { mesh.write(folder, kind.pair); };
        rank_of_cell = sliced(mesh, world().size());
    } else {
        scene.cells = {3, 1, 4};
        for (std::size_t axis = 0; axis < 3; ++axis)
            scene.sides[axis] = static_cast<int>(axis) < kind.periods ? periodic : unresolved;
        for (int c = 0; c < 3 * 1 * 4; ++c)
            rank_of_cell.push_back(7 * c % 5 % world().size());  // most cells have neighbours on other ranks
    }
    if (world().size() == 1) return std::make_unique<GasCase>(scene);
    return std::make_unique<GasCase>(scene, rank_of_cell);
}

struct Particles {
    Vectors position;
    std::vector<int> cell;
    std::vector<double> content;

    void add(const Vector& x, int c, double q)
    {
        position.push_back(x);
        cell.push_back(c);
        content.push_back(q);
    }
    std::size_t size() const { return content.size(); }
};

/// Places from 0 to 1 and weights: exact to degree 11.
const std::array<std::pair<double, double>, 6> gauss_6 = [] {
    std::array<std::pair<double, double>, 6> rule;
    const std::array<double, 3> x{0.238619186083196909, 0.661209386466264514, 0.932469514203152028};
    const std::array<double, 3> w{0.467913934572691047, 0.360761573048138608, 0.171324492379170345};
    for (std::size_t i = 0; i < 3; ++i) {
        rule[2 * i] = {(1 - x[i]) / 2, w[i] / 2};
        rule[2 * i + 1] = {(1 + x[i]) / 2, w[i] / 2};
    }
    return rule;
}();

class OnMeshes : public testing::TestWithParam<Kind> {
protected:
    /// With a width at half height, or without diffusion.
    std::unique_ptr<Mapping> mapping(double width) const
    {
        MappingRules rules;
        rules.width = width > 0 ? width : 1e-12;
        rules.maximum_packing = 1;
        return std::make_unique<Mapping>(world(), mesh_, rules);
    }

    /// Contents of the cells [cells]. Small spheres, so that no packing limit takes part.
    Scalars deposited(double width, const Particles& particles) const
    {
        const auto map = mapping(width);
        const Scalars volumes(particles.size(), 1e-12);
        map->place(particles.position, particles.cell, volumes);
        map->solid_volume(volumes);
        return map->deposit(particles.content);
    }

    Particles filled() const
    {
        Particles all;
        for (const MeshView::Face& face : mesh_.faces)
            for (const int cell : {face.owner, face.neighbour}) {
                if (cell < 0) continue;
                const Vector& centre = mesh_.centre[static_cast<std::size_t>(cell)];
                for (std::size_t k = 0; k < face.points.size(); ++k) {
                    const Vector &a = corner(face, k), &b = corner(face, k + 1), middle = 0.5 * (a + b);
                    for (const Vector& end : {a, b}) {
                        const double six_volumes =
                            std::abs((middle - centre).cross(end - centre).dot(face.centre - centre));
                        // 1 >= A >= B >= C >= 0 are u, uv, uvw; of degree 9 in u with the volume's u^2, 6 and 1 in v
                        for (const auto& [u, in_u] : gauss_6)
                            for (const auto& [v, in_v] : gauss_6)
                                for (const auto& [w, in_w] : gauss_6)
                                    all.add(centre + u * (face.centre - centre +
                                                          v * (middle - face.centre + w * (end - middle))),
                                            cell, six_volumes * u * u * v * in_u * in_v * in_w);
                    }
                }
            }
        return all;
    }

    const Vector& corner(const MeshView::Face& face, std::size_t k) const
    {
        return mesh_.points[static_cast<std::size_t>(face.points[k % face.points.size()])];
    }

    std::unique_ptr<GasCase> gas_ = opened(GetParam());
    const MeshView& mesh_ = gas_->mesh();
};

/// decomposePar writes ten digits or so, and faces of the polyhedra are plane to as many.
constexpr double round_off = 1e-8;

TEST_P(OnMeshes, AUniformDensityFillsEveryCellAlike)
{
    // without diffusion, and with much; in between particles are spread as points, which are no such quadrature
    for (const double width : {0.0, 5.0}) {
        const Scalars content = deposited(width, filled());
        for (std::size_t c = 0; c < mesh_.size(); ++c)
            EXPECT_NEAR(content[c] / mesh_.volume[c], 1, round_off) << "cell " << c << ", width " << width;
    }
}

TEST_P(OnMeshes, WhatPassesAFaceChangesNoCellByAJump)
{
    // At one place of each face a particle on this side of it, and one that takes its content away on the other. What
    // is left is what their weights differ by: of the order of their distance over the size of a cell.
    const double near = 1e-7;
    Particles pairs;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
        const MeshView::Face& face = mesh_.faces[f];
        if (face.neighbour < 0 && face.partner < 0) continue;
        const auto me = std::make_pair(world().rank(), static_cast<int>(f));
        const auto other = std::make_pair(face.partner_rank, face.partner);
        const bool first = face.neighbour >= 0 || me < other;
        const auto [rank, number] = first ? me : other;  // what both halves know
        Vector place(0, 0, 0);
        double sum = 0;
        for (std::size_t k = 0; k < face.points.size(); ++k) {
            const std::size_t there = first ? k : (face.points.size() - k) % face.points.size();
            const double share = 1.1 + std::sin(3.0 * number + 5.0 * rank + 7.0 * static_cast<double>(there));
            place += share * corner(face, k);
            sum += share;
        }
        place /= sum;
        const double content = 2 + std::cos(11.0 * number + rank);
        const auto add = [&](int cell, double q) {
            pairs.add(place + near * (mesh_.centre[static_cast<std::size_t>(cell)] - place), cell, q);
        };
        add(face.owner, first ? content : -content);
        if (face.neighbour >= 0) add(face.neighbour, -content);
    }
    for (const double width : {0.0, 0.3}) {
        const Scalars left = deposited(width, pairs);
        // at most twenty faces of a cell and those around it, contents up to 3, gradients up to 2 over half a cell
        for (std::size_t c = 0; c < mesh_.size(); ++c)
            EXPECT_LT(std::abs(left[c]), 1e4 * near) << c;
    }
}

TEST_P(OnMeshes, TheWayBackIsTheTransposeAndNothingIsLost)
{
    Particles all = filled();
    std::mt19937 random(static_cast<unsigned>(7 + world().rank()));
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (double& q : all.content)
        q = uniform(random);
    Scalars of_cells(mesh_.size());
    for (double& q : of_cells)
        q = uniform(random);
    const Scalars volumes(all.size(), 1e-12);
    for (const double width : {0.0, 0.3}) {
        const auto map = mapping(width);
        map->place(all.position, all.cell, volumes);
        map->solid_volume(volumes);
        const Scalars content = map->deposit(all.content);
        Scalars seen;
        map->interpolate(of_cells, seen);
        double there = 0, back = 0, cells = 0, particles = 0;
        for (std::size_t c = 0; c < mesh_.size(); ++c) {
            there += content[c] * of_cells[c];
            cells += content[c];
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            back += all.content[i] * seen[i];
            particles += all.content[i];
        }
        const double count = static_cast<double>(world().sum(static_cast<long>(all.size())));
        EXPECT_NEAR(world().sum(there), world().sum(back), 1e-14 * count);
        EXPECT_NEAR(world().sum(cells), world().sum(particles), 1e-14 * count);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, OnMeshes,
    testing::Values(Kind{"Tetrahedra", [] { return tetrahedra(2); }, {}}, Kind{"Prisms", [] { return prisms(2); }, {}},
                    Kind{"Polyhedra", [] { return polyhedra(8, 2); }, {}},
                    Kind{"PeriodicTetrahedra", [] { return tetrahedra(2); },
                         Pair{[](const Vector& x) { return Vector(x + Vector(1, 0, 0.1)); }, "type cyclic; "}},
                    Kind{"Box", {}, {}, 0}, Kind{"BoxPeriodicInX", {}, {}, 1}, Kind{"BoxPeriodicInXY", {}, {}, 2},
                    Kind{"BoxPeriodicInXYZ", {}, {}, 3}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace interphase::testing_gas
