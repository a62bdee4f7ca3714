// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds on every mesh, for spheres of any size, on any number of ranks: contents sum to what was deposited, a
// constant is interpolated as one, the two ways are transposed, nothing becomes negative, and ranks change nothing;
// with a packing limit that acts and without.
#include "mapping/mapping.hpp"

#include <gtest/gtest.h>

#include "support/mesh_zoo.hpp"
#include "support/sizings.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

constexpr std::size_t count = 150;

/// Relative, of sums of some hundred terms in different orders, after up to some hundred sweeps of the diffusion, whose
/// round-off adds up at random.
constexpr double rounding = 1e-12;

double other_noise(std::size_t i) { return noise(7 * i + 3); }

class MappingOnMesh : public testing::TestWithParam<NamedMesh> {
protected:
    const WholeMesh& mesh() const { return GetParam().mesh; }

    /// How the spheres fill the cells: the densest has a solid fraction of 1 while no limit acts.
    struct Filling {
        Spheres spheres;
        MappingRules rules;
        double weight;  ///< of each sphere
        bool limited = false;
    };

    /// `visit(filling)` for all sizes and rules, without a limit and with one that acts: a quarter of the way from the
    /// densest cell to the mean.
    template <class Visit>
    void for_each_filling(const Visit& visit) const
    {
        for (const Sizing& sizing : sizings()) {
            SCOPED_TRACE(sizing.name);
            const Spheres spheres = scattered(mesh(), count, sizing.diameter);
            MappedSpheres p(alone(), mesh(), spheres, sizing.rules);
            const Scalars solid = p.fill();
            double densest = 0;
            for (std::size_t c = 0; c < solid.size(); ++c)
                densest = std::max(densest, solid[c] / p.view.volume[c]);
            const double mean = p.total(solid) / p.total(p.view.volume);

            Filling filling{spheres, sizing.rules, 1 / densest};
            visit(filling);
            if (densest < 1.001 * mean) continue;  // wide kernels on a small cyclic mesh fill all cells alike
            filling.limited = true;
            filling.rules.maximum_packing = 1 - 0.25 * (1 - mean / densest);
            SCOPED_TRACE("limit " + std::to_string(filling.rules.maximum_packing));
            visit(filling);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(, MappingOnMesh, testing::ValuesIn(mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

TEST_P(MappingOnMesh, ConservesIsTransposedAndTheSameOnAnyRanks)
{
    for_each_filling([&](const Filling& filling) {
        MappedSpheres one(alone(), mesh(), filling.spheres, filling.rules);
        MappedSpheres many(world(), mesh(), filling.spheres, filling.rules);
        const Scalars solid = many.fill(filling.weight);
        const Scalars q = many.of_particles(noise), contents = many.mapping.deposit(q);
        const Scalars g = many.of_cells(other_noise), values = many.at_particles(g);

        EXPECT_NEAR(many.total(solid) / (filling.weight * many.total(many.volumes)), 1.0, rounding);
        EXPECT_NEAR(many.total(contents), many.total(q), rounding * count);
        EXPECT_NEAR(many.dot(contents, g), many.dot(q, values), rounding * count);
        EXPECT_GT(std::abs(many.dot(contents, g)), 1e-6);  // it is not the zero operator
        for (const double value : many.at_particles(Scalars(many.view.size(), 3.0)))
            EXPECT_NEAR(value, 3.0, 3 * rounding);
        for (std::size_t c = 0; c < solid.size(); ++c) {
            EXPECT_GE(solid[c], 0.0);
            EXPECT_LE(solid[c] / many.view.volume[c],
                      filling.rules.maximum_packing + 1e-3);  // what it lets stand at last
        }
        EXPECT_EQ(world().sum(many.mapping.cells_relieved()) > 0, filling.limited);

        one.fill(filling.weight);
        EXPECT_EQ(world().sum(many.mapping.cells_relieved()), one.mapping.cells_relieved());
        const Scalars contents_of_one = one.mapping.deposit(one.of_particles(noise));
        for (std::size_t c = 0; c < contents.size(); ++c)
            EXPECT_NEAR(contents[c], contents_of_one[many.own_cells[c]], 10 * rounding) << many.own_cells[c];
        const Scalars values_of_one = one.at_particles(one.of_cells(other_noise));
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i], values_of_one[many.here[i]], rounding) << many.here[i];
    });
}

TEST(Mapping, DoesNotChangeWithThePartition)
{
    const WholeMesh mesh = refined_boxes({3, 3, 3}, [](int i, int j, int k) { return (i + j + 2 * k) % 4 == 0; });
    for (const Sizing& sizing : sizings()) {
        const Spheres spheres = scattered(mesh, count, sizing.diameter);
        MappedSpheres one(alone(), mesh, spheres, sizing.rules);
        const Scalars contents = one.mapping.deposit(one.of_particles(noise));
        for (const unsigned seed : {2u, 3u, 4u}) {
            const MappedSpheres many(world(), mesh, spheres, sizing.rules, seed);
            const Scalars own = many.mapping.deposit(many.of_particles(noise));
            for (std::size_t c = 0; c < own.size(); ++c)
                EXPECT_NEAR(own[c], contents[many.own_cells[c]], 10 * rounding) << sizing.name;
        }
    }
}

TEST(Mapping, OfSeveralValuesATimeIsTheSameAsOneByOne)
{
    struct Three {
        double of[3];
    };
    const WholeMesh mesh = refined_boxes({3, 3, 3}, [](int i, int j, int k) { return (i + j + 2 * k) % 4 == 0; });
    for (const Sizing& sizing : sizings()) {
        MappedSpheres p(world(), mesh, scattered(mesh, count, sizing.diameter), sizing.rules);
        p.fill();
        const auto three = [](std::size_t i) { return Three{{noise(3 * i), noise(3 * i + 1), noise(3 * i + 2)}}; };
        const std::vector<Three> contents = p.mapping.deposit(p.of_particles(three));
        const std::vector<Three> values = p.at_particles(p.of_cells(three));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto one = [&](std::size_t i) { return noise(3 * i + k); };
            const Scalars contents_of_one = p.mapping.deposit(p.of_particles(one));
            for (std::size_t c = 0; c < contents.size(); ++c)
                EXPECT_NEAR(contents[c].of[k], contents_of_one[c], rounding) << sizing.name;
            const Scalars values_of_one = p.at_particles(p.of_cells(one));
            for (std::size_t i = 0; i < values.size(); ++i)
                EXPECT_NEAR(values[i].of[k], values_of_one[i], rounding) << sizing.name;
        }
    }
}

TEST(Mapping, ServesSpheresThatComeAndGo)
{
    // a mapping that had other spheres, of other sizes, before, and none at all, maps as a new one
    const WholeMesh mesh = refined_boxes({3, 3, 3}, [](int, int, int k) { return k == 0; });
    MappingRules rules;
    rules.maximum_packing = no_limit;
    const auto diameter = [](std::size_t) { return 1.0; };
    const Spheres few = scattered(mesh, 40, diameter);
    MappedSpheres fresh(world(), mesh, few, rules), used(world(), mesh, few, rules);
    used.mapping.place({}, {}, {});
    EXPECT_EQ(used.mapping.solid_volume({}), Scalars(used.view.size(), 0.0));

    Vectors positions;
    std::vector<int> cells;
    for (std::size_t c = 0; c < used.view.size(); ++c) {
        positions.push_back(used.view.centre[c]);
        cells.push_back(static_cast<int>(c));
    }
    used.mapping.place(positions, cells, Scalars(cells.size(), sphere_volume(0.3)));
    used.mapping.solid_volume(Scalars(cells.size(), sphere_volume(0.3)));

    positions.clear();
    cells.clear();
    const Partition partition = Partition::at_random(mesh.cells, world().size());
    for (const std::size_t i : used.here) {
        positions.push_back(few.positions[i]);
        cells.push_back(partition.number_on[static_cast<std::size_t>(few.cells[i])]);
    }
    used.mapping.place(positions, cells, used.volumes);
    const Scalars again = used.fill(), first = fresh.fill();
    // The smaller spheres' width stays one step of the way to the larger one's; either way has its own error, which
    // is of the fourth order in width over cells and below a hundredth here.
    for (std::size_t c = 0; c < again.size(); ++c)
        EXPECT_NEAR(again[c], first[c], 0.02 * sphere_volume(1.0)) << "cell " << c;
}

}  // namespace
