// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bubbles carved into a box of cells: their number, volumes and places do not depend on how ranks share the cells.
#include "statistics/bubbles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/box_mesh.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

constexpr double pi = 3.14159265358979323846;

class CarvedBox {
public:
    explicit CarvedBox(const std::array<bool, 3>& periodic = {}, int cut = 2)
        : mesh(world(), {test::even_planes(0, 1, 20), test::even_planes(0, 1, 20), test::even_planes(0, 2, 40)}, cut,
               periodic),
          bubbles(world(), mesh.view())
    {}

    template <class Inside>
    BubbleSizes sizes(const Inside& inside) const
    {
        return bubbles.sizes([&](std::size_t cell) { return inside(mesh.view().centre[cell]); });
    }

    test::BoxMesh mesh;
    Bubbles bubbles;
    static constexpr double cell = 0.05;
};

TEST(Bubbles, ASphereHasItsVolumeAndItsHeight)
{
    const CarvedBox bed;
    const Vector centre(0.5, 0.5, 1.0);  // on the border of two ranks and of four
    constexpr double radius = 0.3;
    const BubbleSizes found = bed.sizes([&](const Vector& x) { return (x - centre).norm() < radius; });
    EXPECT_EQ(found.number, 1);
    EXPECT_DOUBLE_EQ(found.volume, found.largest);
    // cells whose centres are inside: of 900 the error is some of those at the surface, at random
    EXPECT_NEAR(found.volume, 4 * pi / 3 * std::pow(radius, 3), 0.03 * found.volume);
    EXPECT_NEAR(found.height, 1.0, 1e-12);  // by symmetry
}

TEST(Bubbles, ReachAcrossRanksAndCyclicSides)
{
    // One bubble lies across the cyclic side in x, the other, smaller one across the borders of ranks; they stay apart.
    const auto inside = [](const Vector& x) {
        const double across = std::min(x.x(), 1 - x.x());
        const bool left = Vector(across, x.y() - 0.5, x.z() - 0.4).norm() < 0.25;
        return left || (x - Vector(0.5, 0.5, 1.2)).norm() < 0.2;
    };
    for (const int cut : {0, 2}) {
        const CarvedBox cyclic({true, false, false}, cut), walled({}, cut);
        EXPECT_EQ(cyclic.sizes(inside).number, 2) << cut;
        EXPECT_EQ(walled.sizes(inside).number, 3) << cut;
        EXPECT_NEAR(cyclic.sizes(inside).height, 0.4, 1e-12);
        EXPECT_NEAR(walled.sizes(inside).volume, cyclic.sizes(inside).volume, 1e-12);
        EXPECT_NEAR(walled.sizes(inside).height, 1.2, 1e-12);  // now the largest
    }
}

TEST(Bubbles, AChainThatWindsThroughAllRanksIsOne)
{
    // Up in every other column of x, joined at the top and the bottom in turn.
    const auto inside = [](const Vector& x) {
        const int i = static_cast<int>(x.x() / CarvedBox::cell);
        if (x.y() > CarvedBox::cell) return false;
        if (i % 2 == 0) return true;
        return i % 4 == 1 ? x.z() > 2 - CarvedBox::cell : x.z() < CarvedBox::cell;
    };
    const CarvedBox bed;
    EXPECT_EQ(bed.sizes(inside).number, 1);
    EXPECT_NEAR(bed.sizes(inside).volume, (10 * 40 + 10) * std::pow(CarvedBox::cell, 3), 1e-12);
}

TEST(Bubbles, CellsThatMeetAtAnEdgeAreTwo)
{
    const CarvedBox bed;
    const auto inside = [](const Vector& x) {
        const int i = static_cast<int>(x.x() / CarvedBox::cell), k = static_cast<int>(x.z() / CarvedBox::cell);
        return x.y() < CarvedBox::cell && ((i == 4 && k == 19) || (i == 5 && k == 20));
    };
    EXPECT_EQ(bed.sizes(inside).number, 2);
    const BubbleSizes none = bed.sizes([](const Vector&) { return false; });
    EXPECT_EQ(none.number, 0);
    EXPECT_EQ(none.volume, 0);
    EXPECT_TRUE(std::isnan(none.height));
}

}  // namespace
