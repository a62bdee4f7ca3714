// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sphere that moves changes no cell's value by a jump: through faces, at edges and corners of cells of every shape.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/mesh_zoo.hpp"
#include "support/sizings.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

/// In cells of about 1: spheres that are single points in most of them, with little diffusion that could hide a jump,
/// and such that are several.
constexpr double small = 0.4, large = 1.0;

/// Several fields at once, so that a jump does not hide in one.
struct Fields {
    double of[8];
};
Fields fields(std::size_t c)
{
    Fields values;
    for (std::size_t k = 0; k < 8; ++k)
        values.of[k] = noise(8 * c + k);
    return values;
}

double largest_difference(const Fields& a, const Fields& b) { return (numbers(a) - numbers(b)).abs().maxCoeff(); }

/// Interpolated at points on their way, which must lie within the mesh. Every rank on its own.
class Walk {
public:
    Walk(const NamedMesh& each, double diameter)
        : mesh_(each.mesh), convex_(each.convex), volume_(sphere_volume(diameter)), finder_(whole_view(mesh_))
    {}

    void visit(const Vector& point)
    {
        spheres_.add(point, convex_ ? finder_.cell_at(point) : l_shaped_cell_at(point), volume_);
    }

    std::vector<Fields> values() const
    {
        MappingRules rules;
        rules.maximum_packing = no_limit;
        const MappedSpheres p(alone(), mesh_, spheres_, rules);
        return p.at_particles(p.of_cells(fields));
    }

private:
    static int l_shaped_cell_at(const Vector& point)
    {
        const std::array<int, 3>& n = l_shaped_blocks;
        const auto block = [&](std::size_t axis, double side) {
            return std::clamp(static_cast<int>(point[static_cast<Eigen::Index>(axis)] / side), 0, n[axis] - 1);
        };
        const int i = block(0, 2), j = block(1, 2), k = block(2, 1);
        const bool in_corner = point.x() > 2 * i + 1 && point.y() > 2 * j + 1;
        return 2 * (i + n[0] * (j + n[1] * k)) + in_corner;
    }

    const WholeMesh& mesh_;
    bool convex_;
    double volume_;
    CellFinder finder_;
    Spheres spheres_;
};

/// The largest change from one of `steps` steps to the next, along lines between places of two cells, some on each
/// rank. Meshes that fill a box only, so that the lines stay within.
double largest_change(const NamedMesh& each, double diameter, int lines, int steps)
{
    const int lines_here = (lines + world().size() - 1) / world().size();
    const auto seed = static_cast<unsigned>(5 + world().rank());
    const Spheres ends = scattered(
        each.mesh, static_cast<std::size_t>(2 * lines_here), [](std::size_t) { return 1.0; }, seed);
    Walk walk(each, diameter);
    for (std::size_t n = 0; n < ends.size(); n += 2)
        for (int i = 0; i <= steps; ++i)
            walk.visit(ends.positions[n] + (ends.positions[n + 1] - ends.positions[n]) * i / steps);
    const std::vector<Fields> values = walk.values();
    double largest = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (i % static_cast<std::size_t>(steps + 1) != 0)
            largest = std::max(largest, largest_difference(values[i - 1], values[i]));
    return world().max(largest);
}

/// The largest change over a step of that length in any direction across the centre of a face, a place of it, one of an
/// edge, its middle, and a corner; for each of the inner faces.
double largest_change_across(const NamedMesh& each, double diameter, double step)
{
    const MeshView view = whole_view(each.mesh);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> part(0, 1);
    Walk walk(each, diameter);
    Box box = empty_box();
    for (const Vector& x : view.points)
        extend(box, x);
    for (const MeshView::Face& face : view.faces) {
        if (face.neighbour < 0) continue;
        const std::size_t k = std::uniform_int_distribution<std::size_t>(0, face.points.size() - 1)(random);
        const Vector &one = view.points[static_cast<std::size_t>(face.points[k])],
                     &other = view.points[static_cast<std::size_t>(face.points[(k + 1) % face.points.size()])];
        const double a = part(random), b = part(random) * (1 - a);
        const Vector on_face = face.centre + a * (one - face.centre) + b * (other - face.centre);
        const Vector on_edge = a * one + (1 - a) * other, middle = 0.5 * (one + other);
        for (const Vector& x : {face.centre, on_face, on_edge, middle, one}) {
            const Vector across = Vector(normal(random), normal(random), normal(random)).normalized();
            for (const double side : {-0.5, 0.5})  // no farther than the walls
                walk.visit((x + side * step * across).cwiseMax(box.col(0)).cwiseMin(box.col(1)));
        }
    }
    const std::vector<Fields> values = walk.values();
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); i += 2)
        largest = std::max(largest, largest_difference(values[i], values[i + 1]));
    return largest;
}

TEST(Continuity, HalfTheStepIsHalfTheChange)
{
    for (const NamedMesh& each : plane_meshes()) {
        if (each.name == "hexagonalPrisms" || each.name == "truncatedOctahedra" || each.name == "baffle") continue;
        for (const double diameter : {small, large}) {
            const double whole = largest_change(each, diameter, 12, 1000),
                         half = largest_change(each, diameter, 12, 2000);
            // where a value changes fastest it does so over more than both steps, but for a part of them in the tips of
            // tetrahedra
            EXPECT_NEAR(half / whole, 0.5, 0.03) << each.name << ", d = " << diameter << ": " << whole << ", " << half;
        }
    }
}

TEST(Continuity, FacesEdgesAndCornersAreCrossedWithoutAJump)
{
    // Values between -1 and 1 differ by 2 over a cell at most: over 0.4, the thinnest layer, or a tenth of a cell, the
    // height of the flattest tetrahedra.
    constexpr double steepest = 2 / 0.1, step = 1e-7;
    for (const NamedMesh& each : plane_meshes()) {
        if (each.name == "baffle") continue;  // its two sides have nothing to do with one another
        EXPECT_LT(largest_change_across(each, small, step), steepest * step) << each.name;
        // Paths right and left of an edge where walls jut out part for good: points of a sphere that pass it jump.
        if (each.name == "hexagonalPrisms" || each.name == "truncatedOctahedra") continue;
        EXPECT_LT(largest_change_across(each, large, step), steepest * step) << each.name << ", several points";
    }
}

TEST(Continuity, BetweenWarpedFacesJumpsAreInProportionToTheWarp)
{
    // Faces count as planes, which their corners miss by up to `by`; the nearer vertices are half a cell apart, of
    // values between -1 and 1. The factor is measured: 0.6 to 0.85, and no larger at half the warp.
    constexpr int steps = 5000;
    const double steady = largest_change({"even", shaken_boxes({6, 5, 4}, 0)}, small, 10, steps);
    for (const double by : {0.02, 0.04, 0.08, 0.16}) {
        const NamedMesh shaken{"shaken", shaken_boxes({6, 5, 4}, by), false};
        EXPECT_LT(largest_change(shaken, small, 10, steps), by + steady) << "moved by " << by;
    }
}

}  // namespace
