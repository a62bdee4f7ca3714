// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kernel's shape on uniform boxes, where it is known in closed form: which cells' it is, its variance, its width at half
// height, each size's own.
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

/// Of a Gaussian.
double variance_of_width(double width) { return width * width / (8 * std::log(2.0)); }

/// A row of boxes of side 1, long enough that a kernel of eight cells at half height is below round-off at its ends: twelve
/// standard deviations.
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
    EXPECT_NEAR(weight({1.75, 1.5, 1.5}, 1, 1, 1), 0.75, rounding);
    EXPECT_NEAR(weight({1.75, 1.5, 1.5}, 2, 1, 1), 0.25, rounding);
    EXPECT_NEAR(weight({2, 1.5, 1.5}, 2, 1, 1), 0.5, rounding);  // of a face
    EXPECT_NEAR(weight({2, 1, 1.5}, 2, 0, 1), 0.25, rounding);   // the middle of an edge
    for (const int i : {1, 2})
        for (const int j : {1, 2})
            for (const int k : {1, 2})
                EXPECT_NEAR(weight({2, 2, 2}, i, j, k), 0.125, rounding);  // a corner
}

TEST(Kernel, CellsShareAFaceByTheirVolumes)
{
    // layers 1 and 3 thick: three quarters of what is at the face between them go to the thicker. At 0.9 of the thin one,
    // four fifths of the way from its centre to the face.
    const WholeMesh mesh = WholeMesh::of_boxes({Scalars{0, 1, 4}, Scalars{0, 1}, Scalars{0, 1}});
    const Scalars weights = weights_of(world(), mesh, {0.9, 0.5, 0.5}, 0, 0.1, without_limit());
    EXPECT_NEAR(weights[0], 0.2 + 0.8 * 0.25, rounding);
    EXPECT_NEAR(weights[1], 0.8 * 0.75, rounding);
}

TEST(Kernel, MeetsALinearFieldExactlyWithinAUniformGrid)
{
    const std::array<int, 3> n{9, 8, 9};
    const WholeMesh mesh = WholeMesh::of_boxes(unit_planes(n));
    const MeshView view = whole_view(mesh);
    const auto linear = [](const Vector& x) { return 3.0 + x.dot(Vector(1.5, -0.7, 2.1)); };
    for (const double diameter : {0.1, 0.5, 0.65}) {
        // so many cells from the walls that no step of the diffusion, which the largest of these takes three of, gets there
        Spheres inner;
        const Spheres all = scattered(mesh, 3000, [=](std::size_t) { return diameter; });
        for (std::size_t i = 0; i < all.size(); ++i)
            if ((all.positions[i].array() > 3.5).all() && (all.positions[i].array() < Eigen::Array3d(5.5, 4.5, 5.5)).all())
                inner.add(all.positions[i], all.cells[i], all.volumes[i]);
        ASSERT_GT(inner.size(), 10u);
        const MappedSpheres p(world(), mesh, inner, without_limit());
        const Scalars values = p.at_particles(p.of_cells([&](std::size_t c) { return linear(view.centre[c]); }));
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i], linear(inner.positions[p.here[i]]), 100 * rounding) << diameter;
    }
}

TEST(Kernel, HasTheVarianceOfTheWidthThatIsAskedFor)
{
    // The weights alone have |x| (1 - |x|) at the distance x from a cell's centre, 1/6 on the average; diffusion adds what is
    // missing to the Gaussian's.
    const double middle = 0.5 * length;
    for (const double diameter : {0.05, 0.4, 0.5, 1.0, 2.0, 4.0})
        for (const double x : {0.0, 0.1, 0.25, 0.4}) {
            const Moments moments(weights_of(world(), row(), {middle + x, 0.4, 0.7}, length / 2, diameter, without_limit()));
            const double added = std::max(0.0, variance_of_width(2 * diameter) - 1.0 / 6);
            EXPECT_NEAR(moments.mean, middle + x, length * rounding) << "d = " << diameter << ", x = " << x;
            EXPECT_NEAR(moments.variance, x * (1 - x) + added, length * length * rounding)
                << "d = " << diameter << ", x = " << x;
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
            width += std::abs(static_cast<double>(inside - peak)) + (*inside - 0.5 * *peak) / (*inside - *(inside + step));
        }
        return width;
    };
    const Vector centre(0.5 * length, 0.5, 0.5);
    MappingRules given = without_limit(), wider = without_limit();
    given.width = 5;
    wider.width_in_diameters = 3;
    // What a line between cells a quarter of the width apart makes of a Gaussian: 3 %.
    for (const double diameter : {2.0, 3.0, 4.0}) {
        EXPECT_NEAR(width_at_half_height(weights_of(world(), row(), centre, length / 2, diameter, without_limit())) /
                        (2 * diameter),
                    1.0, 0.03)
            << "d = " << diameter;
        EXPECT_NEAR(width_at_half_height(weights_of(world(), row(), centre, length / 2, diameter / 1.5, wider)) /
                        (2 * diameter),
                    1.0, 0.03)
            << "d = " << diameter;
        EXPECT_NEAR(width_at_half_height(weights_of(world(), row(), centre, length / 2, diameter, given)) / 5, 1.0, 0.03)
            << "d = " << diameter;
    }
}

TEST(Kernel, OfEachSizeInAMixtureHasItsOwnWidth)
{
    // one sphere of each size at the same place, its content asked for by itself; sizes are octaves of the largest
    const Scalars diameters{4.0, 2.0, 1.0, 0.5};
    Spheres spheres;
    for (const double diameter : diameters)
        spheres.add({0.5 * length, 0.5, 0.5}, length / 2, sphere_volume(diameter));
    MappedSpheres p(world(), row(), spheres, without_limit());
    for (std::size_t n = 0; n < diameters.size(); ++n) {
        const Scalars content = p.of_whole_mesh(
            p.mapping.deposit(p.of_particles([&](std::size_t i) { return i == n ? 1.0 : 0.0; })));
        EXPECT_NEAR(Moments(content).variance, std::max(0.0, variance_of_width(2 * diameters[n]) - 1.0 / 6),
                    length * length * rounding)
            << "d = " << diameters[n];
    }
}

TEST(Kernel, OfASizeBetweenOctavesIsWithinHalfAnOctave)
{
    // sizes 1:10 in small steps: each has the width of the nearest octave
    Spheres spheres;
    Scalars diameters;
    for (double diameter = 4.0; diameter > 0.4; diameter *= 0.93) {
        diameters.push_back(diameter);
        spheres.add({0.5 * length, 0.5, 0.5}, length / 2, sphere_volume(diameter));
    }
    MappedSpheres p(world(), row(), spheres, without_limit());
    for (std::size_t n = 0; n < diameters.size(); ++n) {
        const Scalars content = p.of_whole_mesh(
            p.mapping.deposit(p.of_particles([&](std::size_t i) { return i == n ? 1.0 : 0.0; })));
        const double width = std::sqrt(8 * std::log(2.0) * (Moments(content).variance + 1.0 / 6));
        if (diameters[n] < 1) continue;  // these have the width of the weights
        EXPECT_NEAR(std::log2(width / (2 * diameters[n])), 0.0, 0.5 + 1e-9) << "d = " << diameters[n];
    }
}

TEST(Kernel, SpreadsASphereBiggerThanItsCellOverAllThatItCovers)
{
    // cells of a quarter of a diameter: one within the sphere would be all solid
    const WholeMesh mesh = WholeMesh::of_boxes(unit_planes({24, 24, 24}));
    const Vector x(12.51, 11.98, 12.57);
    const double diameter = 4;
    const Scalars solid = weights_of(world(), mesh, x, CellFinder(whole_view(mesh)).cell_at(x), diameter, without_limit());
    const double volume = sphere_volume(diameter);
    // The peak of a Gaussian of the width asked for.
    const double peak = volume / std::pow(2 * M_PI * variance_of_width(2 * diameter), 1.5);
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
