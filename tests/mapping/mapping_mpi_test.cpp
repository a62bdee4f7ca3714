// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pair of transposed operators between particles and cells: weights that sum to one and change continuously, a
// linear field met exactly on a uniform grid, what is conserved, and that neither the ranks nor the packing limit
// change any of it.
#include "mapping/mapping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "base/user_error.hpp"
#include "support/box_mesh.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::alone;
using test::BoxMesh;
using test::world;

/// Sums of some hundred terms of order one, in different orders.
constexpr double rounding = 1e-13;

constexpr double no_limit = 1e9;

BoxMesh::Planes uniform_planes()
{
    return {test::even_planes(0, 6, 6), test::even_planes(0, 5, 5), test::even_planes(0, 8, 8)};
}

BoxMesh::Planes graded_planes()
{
    return {test::graded_planes(0, 6, 6, 1.3), test::even_planes(0, 5, 5), test::graded_planes(0, 8, 12, 0.8)};
}

Vectors scattered(std::size_t count, const Box& box, unsigned seed = 1)
{
    std::mt19937 random(seed);
    Vectors points(count);
    for (Vector& x : points)
        for (int axis = 0; axis < 3; ++axis)
            x[axis] = std::uniform_real_distribution<double>(box(axis, 0), box(axis, 1))(random);
    return points;
}

/// A mesh, its mapping, and those of the points (the same on all ranks) that have their cell on this rank.
class Placed {
public:
    Placed(const Communicator& comm, const BoxMesh::Planes& planes, const Vectors& points, MappingType type,
           double kernel_width, double limit = no_limit, int cut = 2)
        : comm_(comm), mesh(comm, planes, cut), mapping(comm, mesh.view(), type, kernel_width, limit)
    {
        Vectors positions;
        std::vector<int> cells;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const CellAddress address = mesh.address_of(points[i]);
            if (address.rank != comm.rank()) continue;
            here.push_back(i);
            positions.push_back(points[i]);
            cells.push_back(address.cell);
        }
        mapping.place(positions, cells);
    }

    /// Particle quantities and cell fields are functions of the number among all and of the place.
    Scalars of_particles(const std::function<double(std::size_t)>& f) const
    {
        Scalars values;
        for (const std::size_t i : here)
            values.push_back(f(i));
        return values;
    }
    Scalars of_cells(const std::function<double(std::size_t)>& f) const
    {
        Scalars values;
        for (std::size_t c = 0; c < mesh.view().size(); ++c)
            values.push_back(f(mesh.global_number(c)));
        return values;
    }
    Scalars of_centres(const std::function<double(const Vector&)>& f) const
    {
        Scalars values;
        for (const Vector& centre : mesh.view().centre)
            values.push_back(f(centre));
        return values;
    }
    template <class Record>
    std::vector<Record> at_particles(const std::vector<Record>& cells) const
    {
        std::vector<Record> values;
        mapping.interpolate(cells, values);
        return values;
    }

    double dot(const Scalars& a, const Scalars& b) const
    {
        return comm_.sum(std::inner_product(a.begin(), a.end(), b.begin(), 0.0));
    }
    double total(const Scalars& a) const { return comm_.sum(std::accumulate(a.begin(), a.end(), 0.0)); }

    /// Values of all cells [global count], on every rank.
    Scalars everywhere(const Scalars& own) const
    {
        Scalars all(mesh.global_count(), 0.0);
        for (std::size_t c = 0; c < own.size(); ++c)
            all[mesh.global_number(c)] = own[c];
        comm_.sum(all);
        return all;
    }
    /// Values of all particles, on every rank.
    Scalars everywhere(const Scalars& own, std::size_t particles) const
    {
        Scalars all(particles, 0.0);
        for (std::size_t i = 0; i < own.size(); ++i)
            all[here[i]] = own[i];
        comm_.sum(all);
        return all;
    }

private:
    Communicator comm_;

public:
    BoxMesh mesh;
    Mapping mapping;
    std::vector<std::size_t> here;  ///< numbers of this rank's visitors
};

double noise(std::size_t i) { return std::sin(12.9898 * static_cast<double>(i) + 1.0); }

/// The meshes, kernels and cuts that every property is shown on.
struct Setting {
    const char* name;
    BoxMesh::Planes planes;
    MappingType type;
    double kernel_width;
    int cut = 2;
};

void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.name; }

class MappingProperty : public testing::TestWithParam<Setting> {
protected:
    Placed placed(std::size_t count, double limit = no_limit) const
    {
        const Setting& s = GetParam();
        return Placed(world(), s.planes, points(count), s.type, s.kernel_width, limit, s.cut);
    }
    Vectors points(std::size_t count) const
    {
        return scattered(count, BoxMesh(alone(), GetParam().planes, GetParam().cut).whole());
    }
};

INSTANTIATE_TEST_SUITE_P(, MappingProperty,
                         testing::Values(Setting{"uniform", uniform_planes(), MappingType::kernel, 0.5},
                                         Setting{"graded", graded_planes(), MappingType::kernel, 0.5},
                                         Setting{"cutAcross", graded_planes(), MappingType::kernel, 0.5, 0},
                                         // a particle of diameter 1.15, kernel two diameters: cells from 0.15 on
                                         Setting{"kernelWiderThanCells", graded_planes(), MappingType::kernel, 2.3},
                                         Setting{"cellCentre", graded_planes(), MappingType::cell_centre, 0.5}),
                         [](const auto& test) { return test.param.name; });

TEST_P(MappingProperty, WeightsSumToOne)
{
    const Placed p = placed(300);
    const Scalars ones = p.at_particles(Scalars(p.mesh.view().size(), 1.0));
    ASSERT_EQ(ones.size(), p.here.size());
    for (const double one : ones)
        EXPECT_NEAR(one, 1.0, rounding);
    // and each particle's part from the cells' side, one at a time through a content that only it has
    for (std::size_t i = 0; i < 300; i += 50) {
        const Scalars content = p.mapping.deposit(p.of_particles([i](std::size_t n) { return n == i ? 1.0 : 0.0; }));
        EXPECT_NEAR(p.total(content), 1.0, rounding);
        for (const double part : content)
            EXPECT_GE(part, 0.0);
    }
}

TEST_P(MappingProperty, SolidVolumeIsConserved)
{
    Placed p = placed(300);
    const Scalars volumes = p.of_particles([](std::size_t i) { return 1e-3 * (2 + noise(i)); });
    EXPECT_NEAR(p.total(p.mapping.solid_volume(volumes)) / p.total(volumes), 1.0, rounding);
}

TEST_P(MappingProperty, ThereAndBackAreTransposed)
{
    Placed p = placed(300);
    p.mapping.solid_volume(p.of_particles([](std::size_t) { return 1e-3; }));
    const Scalars q = p.of_particles([](std::size_t i) { return noise(i); });
    const Scalars g = p.of_cells([](std::size_t c) { return noise(7 * c); });
    const double of_cells = p.dot(p.mapping.deposit(q), g);
    EXPECT_NEAR(of_cells, p.dot(q, p.at_particles(g)), 300 * rounding);
    EXPECT_GT(std::abs(of_cells), 0.1);  // it is not the zero operator
}

TEST_P(MappingProperty, RanksDoNotChangeTheResult)
{
    const Setting& s = GetParam();
    const Vectors all = points(300);
    Placed many = placed(300), one(alone(), s.planes, all, s.type, s.kernel_width, no_limit, s.cut);
    const auto q = [](std::size_t i) { return noise(i); };
    const auto g = [](std::size_t c) { return noise(7 * c); };
    many.mapping.solid_volume(many.of_particles(q));
    one.mapping.solid_volume(one.of_particles(q));

    const Scalars cells = many.everywhere(many.mapping.deposit(many.of_particles(q)));
    const Scalars cells_of_one = one.everywhere(one.mapping.deposit(one.of_particles(q)));
    for (std::size_t c = 0; c < cells.size(); ++c)
        EXPECT_NEAR(cells[c], cells_of_one[c], rounding) << "cell " << c;

    const Scalars values = many.everywhere(many.at_particles(many.of_cells(g)), all.size());
    const Scalars values_of_one = one.everywhere(one.at_particles(one.of_cells(g)), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_NEAR(values[i], values_of_one[i], rounding) << "particle " << i;
}

TEST_P(MappingProperty, SeveralValuesATimeAreTheSameAsOneByOne)
{
    struct Three {
        double of[3];
    };
    Placed p = placed(100);
    std::vector<Three> three, cells;
    for (const std::size_t i : p.here)
        three.push_back({noise(3 * i), noise(3 * i + 1), noise(3 * i + 2)});
    for (std::size_t c = 0; c < p.mesh.view().size(); ++c) {
        const std::size_t n = 3 * p.mesh.global_number(c);
        cells.push_back({noise(n), noise(n + 1), noise(n + 2)});
    }
    const std::vector<Three> together = p.mapping.deposit(three), seen = p.at_particles(cells);
    for (std::size_t k = 0; k < 3; ++k) {
        const Scalars apart = p.mapping.deposit(p.of_particles([k](std::size_t i) { return noise(3 * i + k); }));
        for (std::size_t c = 0; c < apart.size(); ++c)
            EXPECT_NEAR(together[c].of[k], apart[c], rounding);
        const Scalars seen_apart = p.at_particles(p.of_cells([k](std::size_t c) { return noise(3 * c + k); }));
        for (std::size_t i = 0; i < seen_apart.size(); ++i)
            EXPECT_NEAR(seen[i].of[k], seen_apart[i], rounding);
    }
}

TEST(Kernel, MeetsALinearFieldExactlyWithinAUniformGrid)
{
    const auto linear = [](const Vector& x) { return 3.0 + x.dot(Vector(1.5, -0.7, 2.1)); };
    // trilinear where cells are as wide as the kernel or wider; with a kernel a whole number of cells wide just as well
    for (const double width : {0.5, 1.0, 2.0}) {
        Box inner;  // from where no weight is cut off at the rim
        inner.col(0).setConstant(std::max(0.5, width - 0.5));
        inner.col(1) = Vector(6, 5, 8) - inner.col(0);
        const Vectors points = scattered(300, inner);
        const Placed p(world(), uniform_planes(), points, MappingType::kernel, width);
        const Scalars values = p.at_particles(p.of_centres(linear));
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i], linear(points[p.here[i]]), 100 * rounding) << "width " << width;
    }
}

TEST(Kernel, IsTrilinearWithinAUniformGrid)
{
    const Vectors points{
        {2.6, 2.9, 4.25}};  // cells 2 | 2 and 3 | 3 and 4 hold it: centres at 2.5, 3.5; 2.5, 3.5; 3.5, 4.5
    const Placed p(world(), uniform_planes(), points, MappingType::kernel, 0.5);
    const Scalars content = p.everywhere(p.mapping.deposit(p.of_particles([](std::size_t) { return 1.0; })));
    const auto number = [](std::size_t i, std::size_t j, std::size_t k) { return i + 6 * (j + 5 * k); };
    EXPECT_NEAR(content[number(2, 2, 3)], 0.9 * 0.6 * 0.25, rounding);
    EXPECT_NEAR(content[number(3, 2, 3)], 0.1 * 0.6 * 0.25, rounding);
    EXPECT_NEAR(content[number(2, 3, 4)], 0.9 * 0.4 * 0.75, rounding);
    EXPECT_NEAR(content[number(3, 3, 4)], 0.1 * 0.4 * 0.75, rounding);
    EXPECT_NEAR(content[number(1, 2, 3)], 0.0, rounding);
}

TEST(Kernel, ACellWeighsByItsVolume)
{
    // two layers, 1 and 3 thick about 0.5 and 2.5, and a reach of each its own thickness: at 0.9 the thin one has
    // 1 (1 - 0.4 / 1) = 0.6, the thick one 3 (1 - 1.6 / 3) = 1.4. Four of each, so that every rank has one.
    const BoxMesh::Planes layers{Scalars{0, 1, 4}, Scalars{0, 1}, test::even_planes(0, 4, 4)};
    const Placed p(world(), layers, {{0.9, 0.5, 0.5}, {0.9, 0.5, 3.5}}, MappingType::kernel, 0.5);
    const Scalars content = p.everywhere(p.mapping.deposit(p.of_particles([](std::size_t) { return 1.0; })));
    for (const std::size_t layer : {0u, 3u}) {
        EXPECT_NEAR(content[2 * layer], 0.6 / 2, rounding);
        EXPECT_NEAR(content[2 * layer + 1], 1.4 / 2, rounding);
    }
}

TEST(Kernel, WeightsAreContinuousWhereAParticleCrossesAFace)
{
    constexpr double step = 1e-9;
    for (const auto& planes : {uniform_planes(), graded_planes()})
        for (const double width : {0.5, 2.3}) {
            // through a face of each kind, at edges and corners too; one pair of points each, a step apart
            Vectors points;
            for (std::size_t n = 1; n + 1 < planes[2].size(); ++n) {
                for (const Vector& normal : {Vector(0, 0, 1), Vector(0, 1, 1), Vector(1, 1, 1)}) {
                    const Vector x(normal.x() > 0 ? planes[0][3] : 2.3, normal.y() > 0 ? planes[1][2] : 1.3,
                                   planes[2][n]);
                    points.push_back(x - 0.5 * step * normal);
                    points.push_back(x + 0.5 * step * normal);
                }
            }
            const Placed p(world(), planes, points, MappingType::kernel, width);
            const Scalars own = p.at_particles(p.of_cells([](std::size_t c) { return noise(7 * c); }));
            const Scalars values = p.everywhere(own, points.size());
            // the steepest weight goes from 0 to 1 over the smallest cell, 0.15, on three axes; values are of order one
            for (std::size_t i = 0; i < points.size(); i += 2)
                EXPECT_NEAR(values[i], values[i + 1], 3 * 2 * step / 0.15)
                    << points[i].transpose() << ", width " << width;
        }
}

TEST(Kernel, SpreadsAParticleBiggerThanItsCellOverAllThatItCovers)
{
    // cells of 0.25, a particle of diameter 0.5: two diameters to each side
    const BoxMesh::Planes fine{test::even_planes(0, 3, 12), test::even_planes(0, 3, 12), test::even_planes(0, 3, 12)};
    const Vector x(1.51, 1.48, 1.57);
    const double volume = M_PI / 6 * 0.125;
    Placed p(world(), fine, {x}, MappingType::kernel, 1.0);
    const Scalars solid = p.everywhere(p.mapping.solid_volume(p.of_particles([=](std::size_t) { return volume; })));
    const double cell = 0.25 * 0.25 * 0.25;
    EXPECT_LT(*std::max_element(solid.begin(), solid.end()) / cell, 0.1);  // a cell within it would be all solid
    EXPECT_NEAR(std::accumulate(solid.begin(), solid.end(), 0.0), volume, rounding);

    // the spread keeps the place: its centre of mass is the particle's
    Vector moment = Vector::Zero();
    const BoxMesh whole(alone(), fine, 2);
    for (std::size_t c = 0; c < solid.size(); ++c)
        moment += solid[c] / volume * whole.view().centre[c];
    EXPECT_LT((moment - x).norm(), 100 * rounding);
}

TEST(CellCentre, GivesAParticleToItsCellAlone)
{
    const Vectors points = scattered(50, BoxMesh(alone(), graded_planes(), 2).whole());
    Placed p(world(), graded_planes(), points, MappingType::cell_centre, 2.3);
    const Scalars content = p.everywhere(p.mapping.deposit(p.of_particles([](std::size_t i) { return 1.0 + i; })));
    Scalars expected(p.mesh.global_count(), 0.0);
    const BoxMesh whole(alone(), graded_planes(), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        expected[static_cast<std::size_t>(whole.address_of(points[i]).cell)] += 1.0 + static_cast<double>(i);
    EXPECT_EQ(content, expected);

    const Scalars field = p.of_cells([](std::size_t c) { return noise(c); });
    const Scalars seen = p.at_particles(field);
    for (std::size_t i = 0; i < seen.size(); ++i)
        EXPECT_EQ(seen[i], noise(static_cast<std::size_t>(whole.address_of(points[p.here[i]]).cell)));
}

/// Particles crowded about the middle, where slabs of 2 and 4 ranks meet, and some elsewhere.
Vectors crowd()
{
    Box middle;
    middle.col(0) = Vector(2.6, 1.6, 3.6);
    middle.col(1) = Vector(3.4, 2.9, 4.4);
    Vectors points = scattered(60, middle, 3);
    for (const Vector& x : scattered(60, BoxMesh(alone(), uniform_planes(), 2).whole(), 4))
        points.push_back(x);
    return points;
}

constexpr double crowding_volume = 0.1;  // of each: 6 m3 about 8 cells of 1 m3
constexpr double limit = 0.6;

double crowding(std::size_t) { return crowding_volume; }

TEST(PackingLimit, HandsTheExcessOnAndKeepsTheVolume)
{
    for (const MappingType type : {MappingType::kernel, MappingType::cell_centre}) {
        Placed unlimited(world(), uniform_planes(), crowd(), type, 1.0);
        const Scalars before = unlimited.everywhere(unlimited.mapping.solid_volume(unlimited.of_particles(crowding)));
        ASSERT_GT(*std::max_element(before.begin(), before.end()), limit);  // there is something to do

        Placed p(world(), uniform_planes(), crowd(), type, 1.0, limit);
        const Scalars after = p.everywhere(p.mapping.solid_volume(p.of_particles(crowding)));
        EXPECT_LE(*std::max_element(after.begin(), after.end()), limit * (1 + 1e-8));  // slack of the limit: 1e-9
        EXPECT_NEAR(std::accumulate(after.begin(), after.end(), 0.0), 120 * crowding_volume, 120 * rounding);

        long above = 0;
        for (const double volume : before)
            above += volume > limit;
        EXPECT_EQ(world().sum(p.mapping.cells_relieved()), above);
    }
}

TEST(PackingLimit, LeavesCellsWithinTheLimitAlone)
{
    Placed p(world(), uniform_planes(), crowd(), MappingType::kernel, 1.0, 10.0);
    Placed unlimited(world(), uniform_planes(), crowd(), MappingType::kernel, 1.0);
    EXPECT_EQ(p.mapping.solid_volume(p.of_particles(crowding)),
              unlimited.mapping.solid_volume(p.of_particles(crowding)));
    EXPECT_EQ(p.mapping.cells_relieved(), 0);
}

TEST(PackingLimit, EverythingElseFollowsTheVolume)
{
    Placed p(world(), uniform_planes(), crowd(), MappingType::kernel, 1.0, limit);
    const Scalars volume = p.mapping.solid_volume(p.of_particles(crowding));
    ASSERT_GT(world().sum(p.mapping.cells_relieved()), 0);

    // the same operator: another quantity in proportion to the volume ends where the volume did
    const Scalars doubled = p.mapping.deposit(p.of_particles([](std::size_t) { return 2 * crowding_volume; }));
    for (std::size_t c = 0; c < volume.size(); ++c)
        EXPECT_NEAR(doubled[c], 2 * volume[c], rounding);

    // any quantity is conserved, a constant stays one, and the two directions are transposed
    const Scalars q = p.of_particles([](std::size_t i) { return noise(i); });
    const Scalars g = p.of_cells([](std::size_t c) { return noise(7 * c); });
    const Scalars content = p.mapping.deposit(q);
    EXPECT_NEAR(p.total(content), p.total(q), 120 * rounding);
    EXPECT_NEAR(p.dot(content, g), p.dot(q, p.at_particles(g)), 120 * rounding);
    for (const double one : p.at_particles(Scalars(p.mesh.view().size(), 1.0)))
        EXPECT_NEAR(one, 1.0, rounding);
}

TEST(PackingLimit, RanksDoNotChangeTheHandOver)
{
    Placed many(world(), uniform_planes(), crowd(), MappingType::kernel, 1.0, limit);
    Placed one(alone(), uniform_planes(), crowd(), MappingType::kernel, 1.0, limit);
    const Scalars volume = many.everywhere(many.mapping.solid_volume(many.of_particles(crowding)));
    const Scalars volume_of_one = one.everywhere(one.mapping.solid_volume(one.of_particles(crowding)));
    // many passes, each on the round-off of the one before
    for (std::size_t c = 0; c < volume.size(); ++c)
        EXPECT_NEAR(volume[c], volume_of_one[c], 1e4 * rounding) << c;
    EXPECT_EQ(world().sum(many.mapping.cells_relieved()), one.mapping.cells_relieved());

    const auto g = [](std::size_t c) { return noise(7 * c); };
    const Scalars values = many.everywhere(many.at_particles(many.of_cells(g)), 120);
    const Scalars values_of_one = one.everywhere(one.at_particles(one.of_cells(g)), 120);
    for (std::size_t i = 0; i < 120; ++i)
        EXPECT_NEAR(values[i], values_of_one[i], 1e4 * rounding) << i;
}

TEST(PackingLimit, WithoutRoomAnywhereAllRanksAreToldWhere)
{
    // 240 cells of 1 m3, 0.6 each: room for 144 m3; the particles have 180
    Placed p(world(), uniform_planes(), crowd(), MappingType::kernel, 1.0, limit);
    try {
        p.mapping.solid_volume(p.of_particles([](std::size_t) { return 1.5; }));
        FAIL() << "180 m3 of solids found room in 144";
    } catch (const UserError& error) {
        const std::string message = error.what();
        for (const char* part :
             {"solid fraction", "in cell", "of rank", "limit of 0.6", "where:  at (", "maximumPacking"})
            EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
    }
}

}  // namespace
