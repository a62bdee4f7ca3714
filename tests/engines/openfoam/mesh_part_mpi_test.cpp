// SPDX-License-Identifier: GPL-3.0-or-later
//
// A particle is found in the cell that holds it, on meshes of tetrahedra, of prisms and of polyhedra, all leaning: from
// any cell that a walk starts from, and by a search; on several ranks a walk hands over to the rank beyond the cut.
// What is outside of the mesh is in no cell.
#include <algorithm>

#include "engines/openfoam/gas_case.hpp"
#include "engines/openfoam/poly_mesh.hpp"
#include "exchange/owner_cell_search.hpp"
#include "support/world.hpp"

namespace interphase::testing_gas {
namespace {

using test::world;

/// Of planes through points of the mesh, for lengths of 1 m: decomposePar writes ten digits or so. A point as near to a
/// face as that may be in either cell.
constexpr double round_off = 1e-9;

struct Kind {
    const char* name;
    PolyMesh (*make)();
};

class Meshes : public testing::TestWithParam<Kind> {
protected:
    Meshes()
    {
        const std::vector<int> rank_of_cell = sliced(mesh_, world().size());
        Scene scene;
        scene.write_mesh = [this](const std::string& folder) { mesh_.write(folder); };
        if (world().size() == 1)
            gas_ = std::make_unique<GasCase>(scene);
        else
            gas_ = std::make_unique<GasCase>(scene, rank_of_cell);
        // parts number their cells anew, in the order of the whole
        for (int rank = 0; rank < world().size(); ++rank) {
            whole_numbers_.emplace_back();
            for (std::size_t c = 0; c < rank_of_cell.size(); ++c)
                if (rank_of_cell[c] == rank) whole_numbers_.back().push_back(c);
        }
    }

    std::size_t in_whole(const CellAddress& address) const
    {
        return whole_numbers_.at(static_cast<std::size_t>(address.rank)).at(static_cast<std::size_t>(address.cell));
    }
    const std::vector<std::size_t>& mine() const { return whole_numbers_[static_cast<std::size_t>(world().rank())]; }

    bool holds(const CellAddress& address, const Vector& point) const
    {
        return mesh_.distance_outside(in_whole(address), point) < round_off;
    }

    /// Inside of the mesh, which is the unit cube made to lean; the same on all ranks.
    std::vector<Vector> random_points(int count) const
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> uniform(1e-6, 1 - 1e-6);
        PolyMesh places;
        for (int i = 0; i < count; ++i)
            places.points.emplace_back(uniform(random), uniform(random), uniform(random));
        return leaning(places).points;
    }

    const CellLocator& locator() const { return gas_->locator(); }

    PolyMesh mesh_ = leaning(GetParam().make());
    std::unique_ptr<GasCase> gas_;
    std::vector<std::vector<std::size_t>> whole_numbers_;  ///< by rank and its cell
};

TEST_P(Meshes, CellsAreNumberedAsTheyWereMade)
{
    ASSERT_EQ(gas_->cells(), mine().size());
    double volume = 0;
    for (std::size_t c = 0; c < gas_->cells(); ++c) {
        EXPECT_LT(mesh_.distance_outside(mine()[c], gas_->centre(c)), -1e-3);
        volume += gas_->volume(c);
    }
    // the determinant of leaning()
    EXPECT_NEAR(world().sum(volume), 1 - 0.1 * (0.2 + 0.3 * 0.15), round_off);
}

TEST_P(Meshes, ACellsCentreIsFoundInIt)
{
    for (std::size_t c = 0; c < gas_->cells(); ++c) {
        const CellAddress here = locator().search(gas_->centre(c));
        EXPECT_EQ(here.rank, world().rank());
        EXPECT_EQ(here.cell, static_cast<int>(c));
        const CellAddress stays = locator().walk(gas_->centre(c), static_cast<int>(c));
        EXPECT_EQ(stays.rank, world().rank());
        EXPECT_EQ(stays.cell, static_cast<int>(c));
    }
}

TEST_P(Meshes, AWalkEndsInTheRightCellOrOnTheRankBeyondOrSaysThatItDoesNotKnow)
{
    long arrived = 0, handed_over = 0, all = 0;
    for (const Vector& point : random_points(50))
        for (std::size_t start = 0; start < gas_->cells(); ++start) {
            const CellAddress end = locator().walk(point, static_cast<int>(start));
            ++all;
            if (!end.known()) continue;
            if (end.rank == world().rank()) {
                ++arrived;
                EXPECT_TRUE(holds(end, point)) << point.transpose() << " from cell " << start;
            } else {
                ++handed_over;
                EXPECT_NO_THROW(in_whole(end));
            }
        }
    // A walk gives up at the boundary where the mesh bends around it, and after twenty cells: few do in meshes as
    // convex and as small as these.
    EXPECT_GT(arrived + handed_over, 0.95 * static_cast<double>(all));
    EXPECT_GT(arrived, 0);
    EXPECT_EQ(handed_over > 0, world().size() > 1);
}

TEST_P(Meshes, APointIsFoundByOneRank)
{
    for (const Vector& point : random_points(500)) {
        const CellAddress found = locator().search(point);
        if (found.known()) {
            EXPECT_EQ(found.rank, world().rank());
            EXPECT_TRUE(holds(found, point)) << point.transpose();
        }
        EXPECT_EQ(world().sum(static_cast<long>(found.known())), 1) << point.transpose();
    }
}

TEST_P(Meshes, APointOutsideIsInNoCell)
{
    const Box bounds = locator().bounds();
    std::vector<Vector> outside{bounds.col(0) - Vector(0.1, 0, 0), bounds.col(1) + Vector(0, 1e-6, 0),
                                Vector(1e3, -1e3, 1e3)};
    // beyond the lowest and the highest face of the cube, though within the box around the part it may be
    for (const Vector& below : {Vector(0.5, 0.5, -1e-6), Vector(0.5, 0.5, 1 + 1e-6), Vector(-1e-6, 0.5, 0.5)}) {
        PolyMesh place;
        place.points = {below};
        outside.push_back(leaning(place).points[0]);
    }
    for (const Vector& point : outside) {
        EXPECT_FALSE(locator().search(point).known()) << point.transpose();
        for (std::size_t start = 0; start < gas_->cells(); ++start) {
            const CellAddress end = locator().walk(point, static_cast<int>(start));
            EXPECT_TRUE(!end.known() || end.rank != world().rank()) << point.transpose();
        }
    }
}

TEST_P(Meshes, APointJustBeyondAWallHasTheCellBehindIt)
{
    // of every face at a wall, 0.01 beyond its centre: less than to any other face's centre
    constexpr double beyond = 0.01;
    for (const MeshView::Face& face : gas_->mesh().faces) {
        if (face.neighbour >= 0 || face.partner >= 0) continue;
        const Vector point = face.centre + beyond * face.area.normalized();
        const NearCell found = locator().nearest(point, 0.02);
        EXPECT_EQ(found.cell, face.owner);
        EXPECT_NEAR(found.distance, beyond, round_off);
        EXPECT_EQ(locator().nearest(point, 0.009).cell, -1);
    }
}

TEST_P(Meshes, ParticlesThatMoveAreFollowedFromRankToRank)
{
    // every rank has points everywhere, which jump by a cell or so, some out of the mesh
    std::vector<Vector> points = random_points(400);
    OwnerCellSearch search(world(), locator());
    std::vector<CellAddress> found(points.size());
    const Scalars reach(points.size(), round_off);
    std::mt19937 random(static_cast<unsigned>(100 + world().rank()));
    std::uniform_real_distribution<double> jump(-0.15, 0.15);
    long outside = 0, elsewhere = 0;
    for (int move = 0; move < 5; ++move) {
        const auto count = static_cast<Eigen::Index>(points.size());
        search.update(VectorsView(points[0].data(), 3, count), ScalarsView(reach.data(), count), found);
        for (std::size_t i = 0; i < points.size(); ++i) {
            double nearest = 1e300;
            for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
                nearest = std::min(nearest, mesh_.distance_outside(c, points[i]));
            EXPECT_EQ(found[i].known(), nearest < 0) << points[i].transpose();
            if (!found[i].known()) {
                ++outside;
                continue;
            }
            EXPECT_TRUE(holds(found[i], points[i])) << points[i].transpose();
            if (found[i].rank != world().rank()) ++elsewhere;
        }
        for (Vector& point : points)
            point += Vector(jump(random), jump(random), jump(random));
    }
    EXPECT_GT(outside, 0);
    EXPECT_EQ(elsewhere > 0, world().size() > 1);
}

INSTANTIATE_TEST_SUITE_P(Of, Meshes,
                         testing::Values(Kind{"Tetrahedra", [] { return tetrahedra(4); }},
                                         Kind{"Prisms", [] { return prisms(5); }},
                                         Kind{"Polyhedra", [] { return polyhedra(40, 6); }}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace interphase::testing_gas
