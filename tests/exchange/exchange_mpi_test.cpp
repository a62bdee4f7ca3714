// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every particle finds its gas cell wherever it goes, and its own data come back from there; what is sent for that
// follows the number of particles whose cell is on another rank, and is nothing where the decompositions match.
#include <gtest/gtest.h>

#include <random>

#include "exchange/owner_cell_search.hpp"
#include "exchange/owner_exchange.hpp"
#include "support/box_mesh.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::BoxMesh;
using test::world;

/// 3 x 4 x 60 cells in slabs along z: higher than the longest walk.
BoxMesh tall_box()
{
    return BoxMesh(world(),
                   {test::even_planes(0, 3, 3), test::graded_planes(-1, 1, 4, 1.3), test::even_planes(0, 60, 60)}, 2);
}

class Cloud {
public:
    explicit Cloud(unsigned seed) : random_(seed + 17u * static_cast<unsigned>(world().rank())) {}

    /// Anywhere within a box.
    void scatter(std::size_t count, const Box& within)
    {
        points.resize(3, static_cast<Eigen::Index>(count));
        owner_cells.assign(count, CellAddress{});
        for (auto column : points.colwise())
            for (int axis = 0; axis < 3; ++axis)
                column[axis] = uniform(within(axis, 0), within(axis, 1));
    }

    /// By up to `reach` per axis, but not out of the box.
    void move(double reach, const Box& within)
    {
        for (auto column : points.colwise())
            for (int axis = 0; axis < 3; ++axis)
                column[axis] =
                    std::clamp(column[axis] + uniform(-reach, reach), within(axis, 0) + 1e-9, within(axis, 1) - 1e-9);
    }

    VectorsView view() const { return {points.data(), 3, points.cols()}; }
    ScalarsView reaches() const
    {
        reaches_.setConstant(points.cols(), reach);
        return {reaches_.data(), reaches_.size()};
    }
    std::size_t size() const { return owner_cells.size(); }
    Vector point(std::size_t i) const { return points.col(static_cast<Eigen::Index>(i)); }

    std::size_t abroad() const
    {
        std::size_t count = 0;
        for (const CellAddress& owner : owner_cells)
            count += owner.known() && owner.rank != world().rank();
        return count;
    }

    Eigen::Matrix3Xd points;
    std::vector<CellAddress> owner_cells;
    double reach = 1e-9;  ///< of each

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

    std::mt19937 random_;
    mutable Eigen::VectorXd reaches_;
};

void expect_at_home(const Cloud& cloud, const BoxMesh& mesh)
{
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const CellAddress expected = mesh.address_of(cloud.point(i));
        ASSERT_EQ(cloud.owner_cells[i].rank, expected.rank) << cloud.point(i).transpose();
        ASSERT_EQ(cloud.owner_cells[i].cell, expected.cell) << cloud.point(i).transpose();
    }
}

TEST(OwnerCellSearch, FindsHomesNotKnownBefore)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(1);
    cloud.scatter(200, mesh.whole());
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    expect_at_home(cloud, mesh);
}

TEST(OwnerCellSearch, FollowsSmallMovesFromCellToCellAndRankToRank)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(2);
    cloud.scatter(200, mesh.whole());
    for (int step = 0; step < 50; ++step) {
        cloud.move(0.7, mesh.whole());
        search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
        expect_at_home(cloud, mesh);
    }
}

TEST(OwnerCellSearch, FollowsJumpsFartherThanAWalkReaches)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(3);
    for (int step = 0; step < 10; ++step) {
        const std::vector<CellAddress> last = cloud.owner_cells;
        cloud.scatter(100, mesh.whole());
        if (step > 0) cloud.owner_cells = last;
        search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
        expect_at_home(cloud, mesh);
    }
}

TEST(OwnerCellSearch, KnownAndUnknownHomesMayMix)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(4);
    cloud.scatter(100, mesh.whole());
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    cloud.move(1.5, mesh.whole());
    for (std::size_t i = 0; i < cloud.size(); i += 3)
        cloud.owner_cells[i] = CellAddress{};  // inserted ones
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    expect_at_home(cloud, mesh);
}

TEST(OwnerCellSearch, OutsideByLessThanItsReachAParticleBelongsToTheNearestCellAndIsCounted)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(6);
    cloud.scatter(60, mesh.whole());
    Cloud nearest = cloud;
    for (Eigen::Index i = 0; i < cloud.points.cols(); ++i) {  // on each of the six sides, and 0.08 beyond it
        const int axis = static_cast<int>(i % 3), side = static_cast<int>(i / 3 % 2);
        nearest.points(axis, i) = mesh.whole()(axis, side);
        cloud.points(axis, i) = mesh.whole()(axis, side) + (side == 0 ? -0.08 : 0.08);
    }
    cloud.reach = 0.1;
    for (int again = 0; again < 2; ++again) {  // from nowhere, and from the last owner
        search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
        nearest.owner_cells = cloud.owner_cells;
        expect_at_home(nearest, mesh);
        EXPECT_EQ(search.beyond_edge(), 60);
    }
    cloud.reach = 0.07;
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    for (const CellAddress& owner : cloud.owner_cells)
        EXPECT_FALSE(owner.known());
    EXPECT_EQ(search.beyond_edge(), 0);
}

TEST(OwnerCellSearch, OutsideThereIsNoHomeAndTheWayBackIsFound)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(5);
    cloud.scatter(60, mesh.whole());
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);

    const Eigen::Matrix3Xd inside = cloud.points;
    for (Eigen::Index i = 0; i < inside.cols(); ++i) {  // out through each of the six sides, near and far
        const int axis = static_cast<int>(i % 3);
        const double beyond = i % 2 ? 1e-6 : 100.0;
        cloud.points(axis, i) = i % 4 < 2 ? mesh.whole()(axis, 0) - beyond : mesh.whole()(axis, 1) + beyond;
    }
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    for (const CellAddress& owner : cloud.owner_cells)
        EXPECT_FALSE(owner.known());

    cloud.points = inside;
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    expect_at_home(cloud, mesh);
}

TEST(OwnerCellSearch, PointsOnFacesBelongToACellThatTouchesThem)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(6);
    cloud.scatter(61, mesh.whole());
    for (int k = 0; k <= 60; ++k)
        cloud.points.col(k) = Vector(1.0, 0.1, k);  // between cells, ranks, and on the rim
    for (int repeat = 0; repeat < 2; ++repeat) {    // searched for, and from the last owner cell
        search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
        for (std::size_t i = 0; i < cloud.size(); ++i)
            EXPECT_TRUE(mesh.holds(cloud.owner_cells[i], cloud.point(i))) << i;
    }
}

TEST(OwnerCellSearch, NotANumberIsInNoCell)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(7);
    cloud.scatter(1, mesh.whole());
    cloud.points(1, 0) = std::nan("");
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    EXPECT_FALSE(cloud.owner_cells[0].known());
}

TEST(OwnerCellSearch, ARankWithoutParticlesTakesPart)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(8);
    cloud.scatter(world().is_master() ? 30 : 0, mesh.whole());
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    expect_at_home(cloud, mesh);
}

/// A particle's record of some numbers: who it is, and from where.
template <int width>
struct Named {
    double numbers[width];
};

template <int width>
std::vector<Named<width>> records_of(const OwnerExchange& visits)
{
    std::vector<Named<width>> records;
    for (const std::size_t i : visits.order()) {
        records.emplace_back();
        for (int k = 0; k < width; ++k)
            records.back().numbers[k] = 1e6 * world().rank() + 10.0 * static_cast<double>(i) + k;
    }
    return records;
}

TEST(OwnerExchange, RoundTripReturnsEveryParticlesOwnData)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    OwnerExchange visits(world());
    Cloud cloud(9);
    cloud.scatter(300, mesh.whole());
    for (int step = 0; step < 3; ++step) {
        cloud.move(5.0, mesh.whole());
        if (step == 1)  // some are outside
            for (Eigen::Index i = 0; i < cloud.points.cols(); i += 7)
                cloud.points(0, i) = -1;
        search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
        visits.plan(cloud.owner_cells);

        // the hosts see the positions, and that each is in the cell it asks for; a second kind of record, of another
        // size, travels with them
        std::vector<Named<3>> positions, arrived;
        for (const std::size_t i : visits.order()) {
            positions.emplace_back();
            set(positions.back().numbers, cloud.point(i));
        }
        std::vector<int> numbers, arrived_numbers, expected_numbers;
        for (const std::size_t i : visits.order())
            numbers.push_back(1000 * world().rank() + static_cast<int>(i));
        expected_numbers = numbers;
        Message message(positions, arrived);
        message.add(numbers, arrived_numbers);
        visits.gather(message);
        ASSERT_EQ(arrived.size(), visits.visitors());
        ASSERT_EQ(arrived_numbers.size(), visits.visitors());
        for (std::size_t v = 0; v < visits.visitors(); ++v)
            EXPECT_TRUE(mesh.holds({world().rank(), visits.cells()[v]}, to_vector(arrived[v].numbers)));

        // and what they answer comes back to the one that asked, both kinds
        std::vector<Named<2>> records = records_of<2>(visits), visitors, answers;
        const std::vector<Named<2>> expected = records;
        visits.gather({records, visitors});
        Message home(visitors, answers);
        home.add(arrived_numbers, numbers);
        visits.scatter(home);
        ASSERT_EQ(answers.size(), expected.size());
        for (std::size_t t = 0; t < answers.size(); ++t)
            for (int k = 0; k < 2; ++k)
                EXPECT_EQ(answers[t].numbers[k], expected[t].numbers[k]);
        EXPECT_EQ(numbers, expected_numbers);

        std::size_t known = 0;
        for (const CellAddress& owner : cloud.owner_cells)
            known += owner.known();
        EXPECT_EQ(visits.order().size(), known);
        EXPECT_EQ(world().sum(static_cast<long>(visits.visitors())), world().sum(static_cast<long>(known)));
    }
}

/// Bytes that this rank sends in a step: owner_cells, a record of eight numbers out and one of seven back.
std::size_t bytes_of_a_step(OwnerCellSearch& search, Cloud& cloud)
{
    const std::size_t before = search.bytes_sent();
    search.update(cloud.view(), cloud.reaches(), cloud.owner_cells);
    OwnerExchange visits(world());
    visits.plan(cloud.owner_cells);
    std::vector<Named<8>> records = records_of<8>(visits), visitors;
    visits.gather({records, visitors});
    std::vector<Named<7>> answers(visits.visitors()), fluid;
    visits.scatter({answers, fluid});
    return search.bytes_sent() - before + visits.bytes_sent();
}

TEST(MessageVolume, IsZeroWhereTheDecompositionsMatch)
{
    const BoxMesh mesh = tall_box();
    OwnerCellSearch search(world(), mesh);
    Cloud cloud(10);
    cloud.scatter(500, mesh.bounds());
    EXPECT_EQ(bytes_of_a_step(search, cloud), 0u);  // searched for
    cloud.move(0.3, mesh.bounds());
    EXPECT_EQ(bytes_of_a_step(search, cloud), 0u);  // followed
}

/// `staying` particles of each rank in its own part of the mesh, `crossing` in the part of the rank after it.
Cloud partly_abroad(std::size_t staying, std::size_t crossing, const BoxMesh& mesh)
{
    const Box mine = mesh.bounds();
    const Scalars boxes = world().all_gather(Scalars(mine.data(), mine.data() + mine.size()));
    const Box next =
        Eigen::Map<const Box>(&boxes[static_cast<std::size_t>(6 * ((world().rank() + 1) % world().size()))]);
    Cloud home(11), abroad(12);
    home.scatter(staying, mesh.bounds());
    abroad.scatter(crossing, next);
    Cloud all(13);
    all.scatter(staying + crossing, mesh.bounds());
    all.points << home.points, abroad.points;
    return all;
}

TEST(MessageVolume, FollowsTheParticlesThatCrossNotTheirTotal)
{
    const BoxMesh mesh = tall_box();
    const auto settled_volume = [&](std::size_t staying, std::size_t crossing) {
        OwnerCellSearch search(world(), mesh);
        Cloud cloud = partly_abroad(staying, crossing, mesh);
        bytes_of_a_step(search, cloud);  // owner_cells become known
        EXPECT_EQ(cloud.abroad(), world().size() > 1 ? crossing : 0u);
        return static_cast<long>(bytes_of_a_step(search, cloud));
    };
    const long few = world().sum(settled_volume(100, 10));
    EXPECT_EQ(world().sum(settled_volume(1000, 10)), few);  // ten times as many stay
    EXPECT_EQ(world().sum(settled_volume(100, 20)), 2 * few);
    // a crossing particle: position and cell out (32 bytes as the compiler lays them), address back; the cell's number;
    // eight numbers out, seven back
    const long crossing = world().size() > 1 ? 10L * world().size() : 0L;
    EXPECT_EQ(few, crossing * (32 + 8 + 4 + 64 + 56));
}

}  // namespace
