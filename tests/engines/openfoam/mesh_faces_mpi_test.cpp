// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a rank knows of its faces is enough to walk along the whole mesh: faces close around every cell, and what is
// behind a cut between ranks or a cyclic pair is the same face from the other side, corner by corner. On tetrahedra,
// prisms and polyhedra that lean, with and without cyclic pairs in one to three directions. Pairs that join anything
// but equal faces by a translation are refused.
#include "engines/openfoam/gas_case.hpp"
#include "engines/openfoam/poly_mesh.hpp"
#include "support/refused.hpp"
#include "support/world.hpp"

namespace interphase::testing_gas {
namespace {

using test::world;

/// For lengths of 1 m: decomposePar writes ten digits or so, and sums of twenty faces round.
constexpr double round_off = 1e-9;

/// From leaning(): the side x = 0 of the cube before it leans goes to x = 1.
const Vector period(1, 0, 0.1);

Pair cyclic(const std::string& type, const Vector& offset)
{
    return {[offset](const Vector& x) { return Vector(x + offset); }, "type " + type + "; "};
}

struct Kind {
    std::string name;
    std::function<PolyMesh()> make;
    std::optional<Pair> pair;
    int periods = 0;  ///< without `make`: directions in which a box is periodic
};

std::unique_ptr<GasCase> opened(const Scene& scene, const std::vector<int>& rank_of_cell)
{
    if (world().size() == 1) return std::make_unique<GasCase>(scene);
    return std::make_unique<GasCase>(scene, rank_of_cell);
}

std::unique_ptr<GasCase> opened(const PolyMesh& mesh, const std::optional<Pair>& pair,
                                const std::string& pair_type = "cyclic")
{
    Scene scene;
    scene.pair_type = pair_type;
    scene.write_mesh = [&](const std::string& folder) { mesh.write(folder, pair); };
    return opened(scene, sliced(mesh, world().size()));
}

std::unique_ptr<GasCase> opened_box(int periods)
{
    Scene scene;
    scene.cells = {4, 3, 2};
    for (int axis = 0; axis < 3; ++axis)
        scene.sides[static_cast<std::size_t>(axis)] = axis < periods ? periodic : Sides{"symmetryPlane", {}, {}};
    std::vector<int> rank_of_cell;
    for (int c = 0; c < 4 * 3 * 2; ++c)
        rank_of_cell.push_back(7 * c % 5 % world().size());  // most cells have neighbours on other ranks
    return opened(scene, rank_of_cell);
}

class Faces : public testing::TestWithParam<Kind> {
protected:
    std::unique_ptr<GasCase> gas_ =
        GetParam().make ? opened(leaning(GetParam().make()), GetParam().pair) : opened_box(GetParam().periods);
    const MeshView& mesh_ = gas_->mesh();
};

TEST_P(Faces, CloseAroundEveryCell)
{
    std::vector<Vector> areas(mesh_.size(), Vector(0, 0, 0));
    Scalars volumes(mesh_.size(), 0.0);
    for (const MeshView::Face& face : mesh_.faces) {
        areas[static_cast<std::size_t>(face.owner)] += face.area;
        volumes[static_cast<std::size_t>(face.owner)] += face.centre.dot(face.area) / 3;
        if (face.neighbour < 0) continue;
        areas[static_cast<std::size_t>(face.neighbour)] -= face.area;
        volumes[static_cast<std::size_t>(face.neighbour)] -= face.centre.dot(face.area) / 3;
    }
    for (std::size_t c = 0; c < mesh_.size(); ++c) {
        EXPECT_LT(areas[c].norm(), round_off) << c;
        EXPECT_NEAR(volumes[c], mesh_.volume[c], round_off) << c;
    }
}

TEST_P(Faces, TurnAboutTheirAreaByTheirCorners)
{
    for (const MeshView::Face& face : mesh_.faces) {
        ASSERT_GE(face.points.size(), 3U);
        Vector area(0, 0, 0);
        for (std::size_t i = 0; i < face.points.size(); ++i) {
            const auto at = [&](std::size_t corner) {
                return Vector(mesh_.points[static_cast<std::size_t>(face.points[corner % face.points.size()])] -
                              face.centre);
            };
            area += at(i).cross(at(i + 1)) / 2;
        }
        EXPECT_LT((area - face.area).norm(), round_off);
    }
}

TEST_P(Faces, HaveOneThingBehindThem)
{
    for (const MeshView::Face& face : mesh_.faces) {
        EXPECT_EQ(face.partner_rank < 0, face.partner < 0);
        EXPECT_FALSE(face.neighbour >= 0 && face.partner >= 0);
        if (face.partner_rank >= 0) {
            EXPECT_LT(face.partner_rank, world().size());
        }
    }
}

TEST_P(Faces, AreSeenFromTheOtherSideCornerByCorner)
{
    // what every rank says of its faces, in rows: corners and their number, area, partner
    constexpr std::size_t most_corners = 12, width = 3 * most_corners + 6;
    const auto rows = static_cast<std::size_t>(world().max(static_cast<double>(mesh_.faces.size())));
    Scalars mine(rows * width, 0.0);
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
        const MeshView::Face& face = mesh_.faces[f];
        ASSERT_LE(face.points.size(), most_corners);
        double* row = &mine[f * width];
        for (std::size_t i = 0; i < face.points.size(); ++i)
            Eigen::Map<Vector>(row + 3 * i) = mesh_.points[static_cast<std::size_t>(face.points[i])];
        row += 3 * most_corners;
        row[0] = static_cast<double>(face.points.size());
        row[1] = face.partner_rank;
        row[2] = face.partner;
        Eigen::Map<Vector>(row + 3) = face.area;
    }
    const Scalars all = world().all_gather(mine);

    long halves = 0, moved = 0;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
        const MeshView::Face& face = mesh_.faces[f];
        if (face.partner < 0) continue;
        ++halves;
        const auto corner = [&](std::size_t i) { return mesh_.points[static_cast<std::size_t>(face.points[i])]; };
        const double* there =
            &all[(static_cast<std::size_t>(face.partner_rank) * rows + static_cast<std::size_t>(face.partner)) * width];
        const double* facts = there + 3 * most_corners;
        EXPECT_EQ(facts[1], world().rank());
        EXPECT_EQ(facts[2], static_cast<double>(f));
        EXPECT_LT((Eigen::Map<const Vector>(facts + 3) + face.area).norm(), round_off);
        const std::size_t n = face.points.size();
        ASSERT_EQ(facts[0], static_cast<double>(n));
        const Vector offset = Eigen::Map<const Vector>(there) - corner(0);
        if (offset.norm() > round_off) ++moved;
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_LT((Eigen::Map<const Vector>(there + 3 * ((n - i) % n)) - corner(i) - offset).norm(), round_off);
        if (GetParam().make && offset.norm() > round_off) {
            EXPECT_NEAR(std::abs(offset.dot(period)), period.squaredNorm(), round_off);
        }
    }
    const bool has_period = GetParam().pair || GetParam().periods > 0;
    EXPECT_EQ(world().sum(moved) > 0, has_period);
    EXPECT_EQ(world().sum(halves) > 0, has_period || world().size() > 1);
}

INSTANTIATE_TEST_SUITE_P(
    Of, Faces,
    testing::Values(Kind{"Tetrahedra", [] { return tetrahedra(3); }, {}}, Kind{"Prisms", [] { return prisms(3); }, {}},
                    Kind{"Polyhedra", [] { return polyhedra(30, 4); }, {}},
                    Kind{"PeriodicTetrahedra", [] { return tetrahedra(3); }, cyclic("cyclic", period)},
                    Kind{"PeriodicPrisms", [] { return prisms(3); }, cyclic("cyclic", period)}, Kind{"Box", {}, {}, 0},
                    Kind{"BoxPeriodicInX", {}, {}, 1}, Kind{"BoxPeriodicInXY", {}, {}, 2},
                    Kind{"BoxPeriodicInXYZ", {}, {}, 3}),
    [](const auto& info) { return info.param.name; });

void expect_refused(const PolyMesh& mesh, const Pair& pair, const std::string& type)
{
    const Problem problem = test::refused([&] { opened(mesh, pair, type); });
    EXPECT_NE(problem.what.find("`cyclicLow` of type " + type), std::string::npos) << problem.what;
    EXPECT_NE(problem.remedy.find("transform translational"), std::string::npos);
}

TEST(PairsOfPatches, ThatJoinUnequalFacesAreRefused)
{
    expect_refused(prisms(3), cyclic("cyclicAMI", {1, 0, 0}), "cyclicAMI");
    expect_refused(prisms(3), cyclic("cyclicSlip", {1, 0, 0}), "cyclicSlip");
}

TEST(PairsOfPatches, ThatTurnAreRefused)
{
    // a quarter turn about z from the side x = 0 to the side y = 0
    const Pair turn{[](const Vector& x) { return x.x() < 1e-9 ? Vector(x.y(), 0, x.z()) : Vector(-1, -1, -1); },
                    "type cyclic; transform rotational; rotationAxis (0 0 1); rotationCentre (0 0 0); "};
    expect_refused(prisms(3), turn, "cyclic");
}

}  // namespace
}  // namespace interphase::testing_gas
