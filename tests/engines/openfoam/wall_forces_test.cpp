// SPDX-License-Identifier: GPL-3.0-or-later
// Proves that the function objects `forces` and `wallShearStress` report what the gas does to a wall: gas of voidage
// eps between plates, one of which moves with V, in a packing that holds it back by K u per volume:
//     eps mu u'' = K u,  u = V sinh(m y) / sinh(m h),  m^2 = K / (eps mu),
// so that the moving plate feels -eps mu V m coth(m h) per area, the one at rest eps mu V m / sinh(m h); and across the
// flow a column at rest, p = rho g y.
#include "engines/openfoam/gas_case.hpp"

namespace interphase::testing_gas {
namespace {

constexpr double voidage = 0.6, viscosity = 0.02, density = 3, height = 0.01, speed = 0.5;  // 1, Pa s, kg/m3, m, m/s
constexpr double drag = 500, gravity = 9.81;                                                // kg/(m3 s), m/s2
constexpr double area = 2e-3 * 1e-3;                                                        // of a plate [m2]

const double m = std::sqrt(drag / (voidage * viscosity));
const double at_moving_plate = -voidage * viscosity * speed * m / std::tanh(m * height);
const double at_resting_plate = voidage * viscosity * speed * m / std::sinh(m * height);

struct Reported {
    std::vector<double> moving, resting;  ///< time, total, pressure, viscous force [N]
};

Scene plates(int cells)
{
    Scene scene;
    scene.size = {2e-3, height, 1e-3};
    scene.cells = {1, cells, 1};
    scene.sides[0] = periodic;
    scene.sides[1] = {"wall",
                      {"type noSlip;", "type fixedValue; value uniform (0.5 0 0);"},
                      {"type fixedFluxPressure; gradient uniform 0; value uniform 0;",
                       "type fixedFluxPressure; gradient uniform 0; value uniform 0;"}};
    scene.density = density;
    scene.viscosity = viscosity;
    scene.pressure_iterations = 0;
    scene.gravity = {0, -gravity, 0};
    scene.gas_step = 2e-3;  // the flow has settled after density * height^2 / viscosity, 0.015 s, many times over
    const std::string on = "; libs (forces); writeControl timeStep; CofR (0 0 0); ";
    scene.functions =
        "moving { type forces; patches (yHigh)" + on + "} resting { type forces; patches (yLow)" + on +
        "} shear { type wallShearStress; patches (yHigh); libs (fieldFunctionObjects); writeControl timeStep; }";
    return scene;
}

Reported reported(int cells)
{
    GasCase gas(plates(cells));
    const Scalars eps(gas.cells(), voidage), rate(gas.cells(), drag), none(3 * gas.cells(), 0.0);
    for (int n = 0; n < 200; ++n)
        gas.step(eps, rate, none);
    Reported found{gas.last_line("moving/0/force.dat"), gas.last_line("resting/0/force.dat")};
    EXPECT_EQ(found.moving.size(), 10u);
    EXPECT_EQ(found.resting.size(), 10u);
    return found;
}

TEST(WallForces, OfShearHoldTheVoidage)
{
    std::vector<double> of_moving, of_resting;
    for (const int cells : {20, 40, 80}) {
        const Reported forces = reported(cells);
        of_moving.push_back(std::abs(forces.moving[7] / (area * at_moving_plate) - 1));
        of_resting.push_back(std::abs(forces.resting[7] / (area * at_resting_plate) - 1));
    }
    // m h is 2.0; the difference over half a cell at the wall is of first order there, or better
    for (const auto& errors : {of_moving, of_resting})
        for (const double order : observed_orders(errors))
            EXPECT_GT(order, 0.9) << errors[0] << " " << errors[1] << " " << errors[2];
    EXPECT_LT(of_moving.back(), 0.015);
    EXPECT_LT(of_resting.back(), 0.015);
}

TEST(WallForces, OfPressureAreThoseOfTheWholeColumn)
{
    const Reported forces = reported(20);
    // p_rgh is 0 in the first cell and thus all over; p is 0 at y = 0. The plates feel p on all of their area: where
    // particles touch them is points.
    const double weight = density * gravity * height * area;
    EXPECT_NEAR(forces.moving[5], -weight, 1e-9 * weight);  // the solver's tolerance
    EXPECT_NEAR(forces.resting[5], 0, 1e-9 * weight);
    EXPECT_NEAR(forces.moving[2], forces.moving[5] + forces.moving[8], 1e-12 * weight);
}

TEST(WallForces, OfPlainShearAreExact)
{
    GasCase gas(plates(8));
    const Scalars one(gas.cells(), 1.0), none(gas.cells(), 0.0), no_source(3 * gas.cells(), 0.0);
    for (int n = 0; n < 200; ++n)
        gas.step(one, none, no_source);
    const double shear = viscosity * speed / height * area;
    EXPECT_NEAR(gas.last_line("moving/0/force.dat")[7], -shear, 1e-9 * shear);  // a linear profile: exact on any mesh
    EXPECT_NEAR(gas.last_line("resting/0/force.dat")[7], shear, 1e-9 * shear);
    // of the fluid on its side of the wall, over density: OpenFOAM's way with an incompressible gas
    const std::vector<double> lowest_and_highest = gas.last_line("shear/0/wallShearStress.dat");
    ASSERT_EQ(lowest_and_highest.size(), 7u);
    for (const std::size_t along : {1, 4})
        EXPECT_NEAR(lowest_and_highest[along], viscosity / density * speed / height, 1e-9);
}

}  // namespace
}  // namespace interphase::testing_gas
