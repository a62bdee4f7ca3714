// SPDX-License-Identifier: GPL-3.0-or-later
// Who is held under an outlet: in gas and in liquid, for cells and particles of any size, wherever gravity points.
#include "step/outlet_watch.hpp"

#include <gtest/gtest.h>

#include "support/box_gas.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

constexpr double g = 9.81;

struct Fluid {
    const char* name;
    double density, viscosity, solids;  // [kg/m3, Pa s, kg/m3]
};
const Fluid fluids[] = {{"air", 1.2, 1.8e-5, 1131}, {"water", 1000, 1e-3, 1131}, {"steel in water", 1000, 1e-3, 7800}};

/// A sphere in a cell that is open on two sides.
struct Scene {
    Fluid fluid;
    double carried = 2;   ///< what the pressure bears, over what the packing weighs in the fluid
    Vector out{0, 0, 1};  ///< of the outlet
    Vector up = out;      ///< against gravity
    double size = 0.01;   ///< of the cell [m]
    double solid_fraction = 0.55;
    double leaving = 1;  ///< velocity of the fluid [m/s]
    double part = 0;     ///< of that, the sphere's
};

class OpenCell : public BoxGas {
public:
    OpenCell(const BoxMesh& mesh, const Scene& scene)
        : BoxGas(alone(), mesh, scene.fluid.density, scene.fluid.viscosity), out_(scene.out)
    {
        set_velocity(scene.leaving * out_);
    }

    std::vector<OpenFace> open_faces() const override { return {{0, out_}, {0, -out_}}; }

private:
    Vector out_;
};

long held(const Scene& scene)
{
    const Scalars planes{0, scene.size};
    const BoxMesh mesh(alone(), {planes, planes, planes}, 0);
    const OpenCell gas(mesh, scene);
    Visitor sphere{};
    sphere.volume = 1e-3 * scene.size * scene.size * scene.size;
    sphere.mass = scene.fluid.solids * sphere.volume;
    set(sphere.velocity, scene.part * scene.leaving * scene.out);
    Visitors visitors;
    visitors.visitor = {sphere};
    visitors.cell = {0};
    const double beyond_fluid = scene.carried * scene.solid_fraction * (scene.fluid.solids - scene.fluid.density);
    double gradient[3];
    set(gradient, -g * (scene.fluid.density + beyond_fluid) * scene.out);
    OutletWatch watch(gas, -g * scene.up);
    watch.observe(visitors, {1 - scene.solid_fraction}, {gradient[0], gradient[1], gradient[2]});
    return watch.count().number;
}

TEST(OutletWatch, CountsWhatTheFluidBears)
{
    for (const Fluid& fluid : fluids)
        for (const Vector& up : {Vector(0, 0, 1), Vector(1, 0, 0), Vector(0, -0.6, 0.8)})
            for (const double size : {1e-4, 0.01, 1.0}) {
                const auto bears = [&](double carried) { return held({fluid, carried, up, up, size}); };
                EXPECT_EQ(bears(1.01), 1) << fluid.name << ", cell of " << size;
                EXPECT_EQ(bears(0.99), 0) << fluid.name << ", cell of " << size;
                EXPECT_EQ(bears(0), 0) << fluid.name << ", cell of " << size;  // the fluid's own weight bears nothing
            }
}

TEST(OutletWatch, LeavesOutWhatPassesAndWhatIsThin)
{
    for (const Fluid& fluid : fluids) {
        Scene slow{fluid}, thin{fluid}, passing{fluid}, inlet{fluid};
        slow.leaving = 1e-4;
        thin.solid_fraction = 0.1;
        passing.part = 0.5;
        inlet.leaving = -1;
        EXPECT_EQ(held(slow), 1) << fluid.name;
        EXPECT_EQ(held(thin), 0) << fluid.name;
        EXPECT_EQ(held(passing), 0) << fluid.name;
        EXPECT_EQ(held(inlet), 0) << fluid.name;
    }
}

TEST(OutletWatch, LooksAtOutletsAboveOnly)
{
    for (const Fluid& fluid : fluids) {
        Scene beside{fluid}, below{fluid};
        beside.up = Vector::UnitX();
        below.up = -below.out;
        EXPECT_EQ(held(beside), 0) << fluid.name;
        EXPECT_EQ(held(below), 0) << fluid.name;
    }
}

}  // namespace
