// SPDX-License-Identifier: GPL-3.0-or-later
//
// What interpolation by the transposed weights makes of a gas that changes over a kernel's width: at the surface of a
// bed, where the interstitial velocity falls from U/0.5 to U within a sphere's diameter, and in a shear layer. Prints
// the table of coupler/mapping/README.md.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "mapping/mapping.hpp"
#include "support/box_mesh.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;

constexpr double diameter = 1.0, solid_fraction = 0.5;

/// A column of cells of `side`, its lower half filled with spheres on a cubic lattice of that solid fraction that the
/// column's walls repeat.
class Column {
public:
    Column(double side, double width_in_diameters)
        : mesh(test::alone(), planes(side), 2),
          mapping(test::alone(), mesh.view(), {MappingType::kernel, width_in_diameters, 0, 1.0})
    {
        const auto across = static_cast<int>(std::lround(width() / spacing));
        for (int k = 0; (k + 0.5) * spacing < surface(); ++k)
            for (int i = 0; i < across; ++i)
                for (int j = 0; j < across; ++j) {
                    const double step = width() / across;
                    const Vector x((i + 0.5) * step, (j + 0.5) * step, (k + 0.5) * spacing);
                    positions.push_back(x);
                    cells.push_back(mesh.address_of(x).cell);
                }
        volumes.assign(positions.size(), M_PI / 6);
        mapping.place(positions, cells, volumes);
        const Scalars solids = mapping.solid_volume(volumes);
        for (std::size_t c = 0; c < solids.size(); ++c)
            voidage.push_back(1 - solids[c] / mesh.view().volume[c]);
    }

    static double width() { return 4 * spacing; }
    static double surface() { return 24 * spacing; }

    Scalars seen(const Scalars& of_cells) const
    {
        Scalars values;
        mapping.interpolate(of_cells, values);
        return values;
    }
    /// Mean over the spheres of a layer, 0 the topmost.
    double in_layer(const Scalars& of_spheres, int layer) const
    {
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < of_spheres.size(); ++i) {
            const auto below = static_cast<int>(std::lround((positions.back().z() - positions[i].z()) / spacing));
            if (below != layer) continue;
            sum += of_spheres[i];
            ++count;
        }
        return sum / count;
    }

    inline static const double spacing = diameter * std::cbrt(M_PI / 6 / solid_fraction);

    test::BoxMesh mesh;
    Mapping mapping;
    Vectors positions;
    std::vector<int> cells;
    Scalars volumes, voidage;

private:
    static test::BoxMesh::Planes planes(double side)
    {
        const auto cells = [&](double length) { return static_cast<int>(std::lround(length / side)); };
        return {test::even_planes(0, width(), cells(width())), test::even_planes(0, width(), cells(width())),
                test::even_planes(0, 2 * surface(), cells(2 * surface()))};
    }
};

/// Over U: the interstitial velocity of a gas that flows upwards evenly.
Scalars interstitial(const Scalars& voidage)
{
    Scalars velocity;
    for (const double eps : voidage)
        velocity.push_back(1 / eps);
    return velocity;
}

TEST(GasSeen, AtABedsSurfaceOverTheKernelsWidth)
{
    std::printf("| cells | width | topmost layer | second | third | fifth |\n|---|---|---|---|---|---|\n");
    for (const double side : {4.0, 2.0, 1.0})
        for (const double width : {1.0, 2.0, 4.0, 8.0}) {
            const Column column(side * Column::spacing, width);
            const Scalars velocity = column.seen(interstitial(column.voidage));
            const double inside = 1 / (1 - solid_fraction);
            std::printf("| %g d | %g d |", side, width);
            for (const int layer : {0, 1, 2, 4})
                std::printf(" %+.0f %% |", 100 * (column.in_layer(velocity, layer) / inside - 1));
            std::printf("\n");

            for (const double seen : velocity) {  // a mean of what is there, weights being positive
                EXPECT_LT(seen, inside * 1.05);
                EXPECT_GT(seen, 1.0);
            }
            // Two widths below the surface a kernel's tail holds less than 1 % (Gaussian: 2.35 standard deviations a
            // width).
            const double blurred = std::max(2 * width, 2 * side);
            const auto below = static_cast<int>(blurred / Column::spacing) + 1;
            if (below < 22) {
                EXPECT_NEAR(column.in_layer(velocity, below), inside, 0.02 * inside) << side << " " << width;
            }
        }
}

TEST(GasSeen, ALinearShearWithoutError)
{
    for (const double side : {4.0, 1.0}) {
        const Column column(side * Column::spacing, 2.0);
        Scalars shear;
        for (const Vector& centre : column.mesh.view().centre)
            shear.push_back(centre.z());
        const Scalars seen = column.seen(shear);
        // Alone on uniform boxes symmetric weights would meet it at every point but for their smoothing within a cell;
        // the mean over a layer of cells is met in any case, to the packing's pattern.
        double difference = 0;
        long count = 0;
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (column.positions[i].z() > 8 * Column::spacing && column.positions[i].z() < 16 * Column::spacing) {
                difference += seen[i] - column.positions[i].z();
                ++count;
            }
        EXPECT_NEAR(difference / static_cast<double>(count), 0, 0.01 * Column::spacing) << side;
    }
}

TEST(GasSeen, ASineWaveAsItsKernelDampsIt)
{
    // A shear layer of wave number k: a Gaussian of the asked width takes exp(-k^2 sigma^2/2), on cells well below it.
    const double width = 2.0, variance = width * width / (8 * std::log(2.0)), wave = 2 * M_PI / (12 * Column::spacing);
    const Column column(0.5 * Column::spacing, width);
    Scalars layer;
    for (const Vector& centre : column.mesh.view().centre)
        layer.push_back(std::sin(wave * centre.z()));
    const Scalars seen = column.seen(layer);
    double projected = 0, whole = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double z = column.positions[i].z();
        if (z < 6 * Column::spacing || z > 18 * Column::spacing) continue;
        projected += seen[i] * std::sin(wave * z);
        whole += std::sin(wave * z) * std::sin(wave * z);
    }
    // 2 %: the weights' own variance on top and the finite volumes' at this wave number
    EXPECT_NEAR(projected / whole, std::exp(-wave * wave * variance / 2), 0.02);
}

}  // namespace
