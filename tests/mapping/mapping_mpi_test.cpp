// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds on every mesh, for spheres of any size, on any number of ranks: contents sum to what was deposited, a constant
// is interpolated as one, the two ways are transposed, nothing becomes negative, and ranks change nothing; with a packing
// limit that acts and without.
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

    /// `visit(filling)` for all sizes and rules, without a limit and with one that acts: a tenth of the way from the
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
            filling.rules.maximum_packing = 1 - 0.1 * (1 - mean / densest);
            SCOPED_TRACE("limit " + std::to_string(filling.rules.maximum_packing));
            visit(filling);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(, MappingOnMesh, testing::ValuesIn(mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

TEST_P(MappingOnMesh, ContentsSumToWhatWasDepositedAndNothingIsNegative)
{
    for_each_filling([&](const Filling& filling) {
        MappedSpheres p(world(), mesh(), filling.spheres, filling.rules);
        const Scalars solid = p.fill(filling.weight);
        EXPECT_NEAR(p.total(solid) / (filling.weight * p.total(p.volumes)), 1.0, rounding);
        for (std::size_t c = 0; c < solid.size(); ++c) {
            EXPECT_GE(solid[c], 0.0);
            EXPECT_LE(solid[c] / p.view.volume[c], filling.rules.maximum_packing + 1e-8);  // slack of the limit: 1e-9
        }
        const Scalars q = p.of_particles(noise);
        EXPECT_NEAR(p.total(p.mapping.deposit(q)), p.total(q), rounding * count);
        EXPECT_EQ(world().sum(p.mapping.cells_relieved()) > 0, filling.limited);
    });
}

TEST_P(MappingOnMesh, AConstantIsInterpolatedAsOne)
{
    for_each_filling([&](const Filling& filling) {
        MappedSpheres p(world(), mesh(), filling.spheres, filling.rules);
        p.fill(filling.weight);
        for (const double value : p.at_particles(Scalars(p.view.size(), 3.0)))
            EXPECT_NEAR(value, 3.0, 3 * rounding);
    });
}

TEST_P(MappingOnMesh, ThereAndBackAreTransposed)
{
    for_each_filling([&](const Filling& filling) {
        MappedSpheres p(world(), mesh(), filling.spheres, filling.rules);
        p.fill(filling.weight);
        const Scalars q = p.of_particles(noise);
        const Scalars g = p.of_cells([](std::size_t c) { return noise(7 * c + 3); });
        const double of_cells = p.dot(p.mapping.deposit(q), g);
        EXPECT_NEAR(of_cells, p.dot(q, p.at_particles(g)), count * rounding);
        EXPECT_GT(std::abs(of_cells), 1e-6);  // it is not the zero operator
    });
}

TEST_P(MappingOnMesh, RanksDoNotChangeTheResult)
{
    for_each_filling([&](const Filling& filling) {
        MappedSpheres one(alone(), mesh(), filling.spheres, filling.rules);
        const Scalars solid = one.of_whole_mesh(one.fill(filling.weight));
        const Scalars contents = one.of_whole_mesh(one.mapping.deposit(one.of_particles(noise)));
        const Scalars values = one.of_all_spheres(one.at_particles(one.of_cells(noise)));
        for (const unsigned partition : {1u, 2u}) {
            MappedSpheres many(world(), mesh(), filling.spheres, filling.rules, partition);
            const double volume = *std::max_element(solid.begin(), solid.end());
            const Scalars solid_of_many = many.of_whole_mesh(many.fill(filling.weight));
            const Scalars contents_of_many = many.of_whole_mesh(many.mapping.deposit(many.of_particles(noise)));
            for (std::size_t c = 0; c < solid.size(); ++c) {
                EXPECT_NEAR(solid_of_many[c] / volume, solid[c] / volume, rounding) << "cell " << c;
                EXPECT_NEAR(contents_of_many[c], contents[c], 10 * rounding) << "cell " << c;
            }
            const Scalars values_of_many = many.of_all_spheres(many.at_particles(many.of_cells(noise)));
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_NEAR(values_of_many[i], values[i], rounding) << "sphere " << i;
            EXPECT_EQ(world().sum(many.mapping.cells_relieved()), one.mapping.cells_relieved());
        }
    });
}

TEST_P(MappingOnMesh, SeveralValuesATimeAreTheSameAsOneByOne)
{
    struct Three {
        double of[3];
    };
    for_each_filling([&](const Filling& filling) {
        MappedSpheres p(world(), mesh(), filling.spheres, filling.rules);
        p.fill(filling.weight);
        const auto three = [](std::size_t i) { return Three{{noise(3 * i), noise(3 * i + 1), noise(3 * i + 2)}}; };
        const std::vector<Three> contents = p.mapping.deposit(p.of_particles(three));
        const std::vector<Three> values = p.at_particles(p.of_cells(three));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto one = [&](std::size_t i) { return noise(3 * i + k); };
            const Scalars contents_of_one = p.mapping.deposit(p.of_particles(one));
            for (std::size_t c = 0; c < contents.size(); ++c)
                EXPECT_NEAR(contents[c].of[k], contents_of_one[c], rounding);
            const Scalars values_of_one = p.at_particles(p.of_cells(one));
            for (std::size_t i = 0; i < values.size(); ++i)
                EXPECT_NEAR(values[i].of[k], values_of_one[i], rounding);
        }
    });
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
    EXPECT_EQ(used.fill().size(), used.view.size());
    for (const double solid : used.mapping.solid_volume({}))
        EXPECT_EQ(solid, 0.0);

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
