// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kernel's shape on uniform boxes, where it is known in closed form: which cells' it is, its variance, its width at
// half height, each size's own.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/mesh_shapes.hpp"
#include "support/sizings.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// Absolute, of weights, after up to some hundred sweeps of the diffusion.
constexpr double rounding = 1e-12;

MappingRules without_limit()
{
    MappingRules rules;
    rules.maximum_packing = no_limit;
    return rules;
}

/// What a cell's neighbour gets, twice, of the way to it.
double smoothed(double t) { return 0.5 * t * t * (3 - t); }

/// Of a Gaussian.
double variance_of_width(double width) { return width * width / (8 * std::log(2.0)); }

/// A row of boxes of side 1, long enough that a kernel of eight cells at half height is below round-off at its ends:
/// twelve standard deviations.
constexpr int length = 81;
WholeMesh row() { return WholeMesh::of_boxes(unit_planes({length, 1, 1})); }

/// Mean and variance along a row of boxes.
struct Moments {
    double mean = 0, variance = 0;

    explicit Moments(const Scalars& content)
    {
        const double sum = std::accumulate(content.begin(), content.end(), 0.0);
        for (std::size_t c = 0; c < content.size(); ++c)
            mean += content[c] / sum * (static_cast<double>(c) + 0.5);
        for (std::size_t c = 0; c < content.size(); ++c)
            variance += content[c] / sum * std::pow(static_cast<double>(c) + 0.5 - mean, 2);
    }
};

TEST(Kernel, OfASmallSphereBelongsToTheCellsThatMeetThere)
{
    const WholeMesh mesh = WholeMesh::of_boxes(unit_planes({4, 4, 4}));
    const auto weight = [&](const Vector& x, int i, int j, int k) {
        const int cell = 1 + 4 * (1 + 4 * 1);  // from 1 to 2 along each axis
        return weights_of(world(), mesh, x, cell, 0.1, without_limit())[static_cast<std::size_t>(i + 4 * (j + 4 * k))];
    };
    EXPECT_NEAR(weight({1.5, 1.5, 1.5}, 1, 1, 1), 1.0, rounding);  // the cell's centre
    EXPECT_NEAR(weight({1.75, 1.5, 1.5}, 1, 1, 1), 1 - 0.5 * smoothed(0.5), rounding);
    EXPECT_NEAR(weight({1.75, 1.5, 1.5}, 2, 1, 1), 0.5 * smoothed(0.5), rounding);
    EXPECT_NEAR(weight({1.75, 1.6, 1.3}, 2, 1, 0),
                0.5 * smoothed(0.5) * (1 - 0.5 * smoothed(0.2)) * 0.5 * smoothed(0.4), rounding);
    EXPECT_NEAR(weight({2, 1.5, 1.5}, 2, 1, 1), 0.5, rounding);  // of a face
    EXPECT_NEAR(weight({2, 1, 1.5}, 2, 0, 1), 0.25, rounding);   // the middle of an edge
    for (const int i : {1, 2})
        for (const int j : {1, 2})
            for (const int k : {1, 2})
                EXPECT_NEAR(weight({2, 2, 2}, i, j, k), 0.125, rounding);  // a corner
}

TEST(Kernel, CellsShareAFaceByTheirVolumes)
{
    // layers 1 and 3 thick: three quarters of what is at the face between them go to the thicker. At 0.9 of the thin
    // one, four fifths of the way from its centre to the face, 0.704 of what is given on goes there.
    const WholeMesh mesh = WholeMesh::of_boxes({Scalars{0, 1, 4}, Scalars{0, 1}, Scalars{0, 1}});
    const Scalars weights = weights_of(world(), mesh, {0.9, 0.5, 0.5}, 0, 0.1, without_limit());
    EXPECT_NEAR(weights[0], 1 - 0.704 * 0.75, rounding);
    EXPECT_NEAR(weights[1], 0.704 * 0.75, rounding);
}

TEST(Kernel, KeepsThePlaceOfASphereWithinATenthOfACell)
{
    // s(t) - t is t (1 - t) (2 - t) / 2 at most 0.193, where half of a cell is 1. Spheres are single points here.
    const double middle = 0.5 * length;
    for (const double diameter : {0.05, 0.4, 3.0})
        for (double x = -0.48; x < 0.5; x += 0.06) {
            const Moments moments(
                weights_of(world(), row(), {middle + x, 0.4, 0.7}, length / 2, diameter, without_limit()));
            EXPECT_NEAR(moments.mean, middle + std::copysign(0.5 * smoothed(2 * std::abs(x)), x), length * rounding);
            EXPECT_LT(std::abs(moments.mean - middle - x), 0.0963);
        }
}

/// Of a sphere's content about the sphere, along the row; the mean over its places in a cell.
double mean_second_moment(double diameter, const MappingRules& rules)
{
    constexpr int places = 50;
    Spheres spheres;
    for (int i = 0; i < places; ++i)
        spheres.add({length / 2 + (i + 0.5) / places, 0.4, 0.7}, length / 2, sphere_volume(diameter));
    const MappedSpheres p(world(), row(), spheres, rules);
    double sum = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const Moments moments(
            p.of_whole_mesh(p.mapping.deposit(p.of_particles([&](std::size_t n) { return n == i ? 1.0 : 0.0; }))));
        sum += moments.variance + std::pow(moments.mean - spheres.positions[i].x(), 2);
    }
    return sum / places;
}

/// Of weights alone: the mean of x^2 + w (1 - 2 x) over x from 0 to 1/2, where w = s(2x)/2 goes to the next cell.
constexpr double of_weights = 2.0 / 15;

TEST(Kernel, HasTheVarianceOfTheWidthThatIsAskedFor)
{
    // That of a Gaussian, less that of one as wide as the weights, a cell, which these have in its place; whether the
    // sphere is one point (0.05, 0.4, 3, 4) or several, some diffusion (2, 1) or none.
    for (const double diameter : {0.05, 0.4, 1.0, 2.0, 3.0, 4.0}) {
        const double added = std::max(0.0, variance_of_width(2.5 * diameter) - variance_of_width(1));
        // a sum over places in place of an integral: a second difference of w in fiftieths of a cell
        EXPECT_NEAR(mean_second_moment(diameter, without_limit()), of_weights + added, 1e-3) << "d = " << diameter;
    }
}

TEST(Kernel, HasTheWidthAtHalfHeightThatIsAskedFor)
{
    // between the cells where it falls below half of its peak, in a line from one cell to the next
    const auto width_at_half_height = [](const Scalars& content) {
        const auto peak = std::max_element(content.begin(), content.end());
        double width = 0;
        for (const int step : {-1, 1}) {
            auto inside = peak;
            while (*(inside + step) > 0.5 * *peak)
                inside += step;
            width +=
                std::abs(static_cast<double>(inside - peak)) + (*inside - 0.5 * *peak) / (*inside - *(inside + step));
        }
        return width;
    };
    const Vector centre(0.5 * length, 0.5, 0.5);
    MappingRules given = without_limit(), wider = without_limit();
    given.width = 5;
    wider.width_in_diameters = 3;
    // What a line between cells a quarter of the width apart makes of a Gaussian: 3 %. The points of a sphere, all as
    // far from its centre, have a flatter top: 6 %.
    for (const double diameter : {2.0, 3.0, 4.0}) {
        EXPECT_NEAR(width_at_half_height(weights_of(world(), row(), centre, length / 2, diameter, without_limit())) /
                        (2.5 * diameter),
                    1.0, 0.03)
            << "d = " << diameter;
        EXPECT_NEAR(width_at_half_height(weights_of(world(), row(), centre, length / 2, diameter / 1.5, wider)) /
                        (2 * diameter),
                    1.0, 0.06)
            << "d = " << diameter;
        EXPECT_NEAR(width_at_half_height(weights_of(world(), row(), centre, length / 2, diameter, given)) / 5, 1.0,
                    0.03)
            << "d = " << diameter;
    }
}

TEST(Kernel, IsTheCellsOwnWhereTheyAreWideEnough)
{
    // 0.8 of the width, two diameters by default; cells that measure just that, by whatever round-off
    for (const double diameter : {0.45, 0.5}) {
        EXPECT_NEAR(mean_second_moment(diameter, without_limit()), of_weights, 1e-3) << "d = " << diameter;
    }
    EXPECT_GT(mean_second_moment(0.51, without_limit()), of_weights + 0.1);
}

TEST(Kernel, OfEachSizeInAMixtureHasItsOwnWidth)
{
    // sizes 1:10, in octaves of the largest and between them: the width is 2.5 diameters or up to an octave more,
    // or that of a cell that measures two
    Spheres spheres;
    Scalars diameters;
    for (double diameter = 4.0; diameter > 0.4; diameter *= std::exp2(-0.25)) {
        diameters.push_back(diameter);
        spheres.add({0.5 * length, 0.5, 0.5}, length / 2, sphere_volume(diameter));
    }
    MappedSpheres p(world(), row(), spheres, without_limit());
    for (std::size_t n = 0; n < diameters.size(); ++n) {
        const Scalars content =
            p.of_whole_mesh(p.mapping.deposit(p.of_particles([&](std::size_t i) { return i == n ? 1.0 : 0.0; })));
        // at a cell's centre the weights add nothing
        const double width = std::sqrt(8 * std::log(2.0) * Moments(content).variance + 1);
        const double octave = std::exp2(-std::floor(static_cast<double>(n) / 4 + 1e-9));
        EXPECT_GE(width, 2 * diameters[n] * (1 - rounding)) << "d = " << diameters[n];
        // exactly, but for what the weights add to points that lie beside the centre of a cell, most of it where one is
        // as wide as the kernel
        EXPECT_NEAR(width / (10 * octave), 1.0, diameters[n] > 2 ? rounding : 0.2) << "d = " << diameters[n];
    }
}

TEST(Kernel, SpreadsASphereBiggerThanItsCellOverAllThatItCovers)
{
    // cells of a quarter of a diameter: one within the sphere would be all solid
    const WholeMesh mesh = WholeMesh::of_boxes(unit_planes({24, 24, 24}));
    const Vector x(12.51, 11.98, 12.57);
    const double diameter = 4;
    const Scalars solid =
        weights_of(world(), mesh, x, CellFinder(whole_view(mesh)).cell_at(x), diameter, without_limit());
    const double volume = sphere_volume(diameter);
    // The peak of a Gaussian of the width asked for.
    const double peak = volume / std::pow(2 * M_PI * variance_of_width(2.5 * diameter), 1.5);
    EXPECT_NEAR(volume * *std::max_element(solid.begin(), solid.end()) / peak, 1.0, 0.02);
    EXPECT_LT(peak, 0.1);
}

TEST(CellCentre, GivesASphereToItsCellAlone)
{
    const WholeMesh mesh = tetrahedra({3, 3, 2});
    MappingRules rules = without_limit();
    rules.type = MappingType::cell_centre;
    const Spheres spheres = scattered(mesh, 50, [](std::size_t i) { return i % 2 == 0 ? 0.1 : 3.0; });
    MappedSpheres p(world(), mesh, spheres, rules);
    const auto q = [](std::size_t i) { return 1.0 + static_cast<double>(i); };
    Scalars expected(mesh.cells, 0.0);
    for (std::size_t i = 0; i < spheres.size(); ++i)
        expected[static_cast<std::size_t>(spheres.cells[i])] += q(i);
    EXPECT_EQ(p.of_whole_mesh(p.mapping.deposit(p.of_particles(q))), expected);

    const Scalars seen = p.at_particles(p.of_cells(noise));
    for (std::size_t i = 0; i < seen.size(); ++i)
        EXPECT_EQ(seen[i], noise(static_cast<std::size_t>(spheres.cells[p.here[i]])));
}

}  // namespace
