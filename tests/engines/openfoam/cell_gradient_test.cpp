// SPDX-License-Identifier: GPL-3.0-or-later
// The gradient of what a collision model puts on the gas mesh: exact where it is linear, without slope at the
// boundaries (a stress), or from nothing there (a flow of solids, which no boundary lets through).
#include "engines/openfoam/gas_case.hpp"

namespace interphase::testing_gas {
namespace {

constexpr int cells = 10;
constexpr double width = 0.1, slope = 3;

Scene scene()
{
    Scene scene;
    scene.cells = {cells, 1, 1};
    scene.sides[0] = through_flow("(0 0 0)");
    return scene;
}

TEST(CellGradient, OfALinearFieldIsItsSlopeAndHalfOfItBesideABoundary)
{
    GasCase gas(scene());
    const Scalars gradient = gas.gradient(gas.sampled([](const Vector& x) { return slope * x.x(); }));
    for (std::size_t c = 0; c < cells; ++c) {
        const bool at_end = c == 0 || c == cells - 1;
        EXPECT_NEAR(gradient[3 * c], at_end ? slope / 2 : slope, 1e-12) << c;  // round-off
        EXPECT_NEAR(gradient[3 * c + 1], 0, 1e-12);
    }
}

TEST(CellGradient, OfAUniformFieldIsNone)
{
    GasCase gas(scene());
    for (const double slope_there : gas.gradient(Scalars(cells, 1e7)))
        EXPECT_NEAR(slope_there, 0, 1e-6);  // round-off of 1e7 over 0.1 m
}

TEST(Stretching, OfAUniformFlowIsWhereBoundariesStopIt)
{
    GasCase gas(scene());
    const Scalars stretching = gas.stretching(gas.sampled([](const Vector&) { return Vector(-2, 5, 0); }));
    for (std::size_t c = 0; c < cells; ++c) {
        const double expected = c == 0 ? -2 / width : c == cells - 1 ? 2 / width : 0;
        EXPECT_NEAR(stretching[3 * c], expected, 1e-12) << c;
        EXPECT_NEAR(stretching[3 * c + 1], 0, 1e-12);  // no motion along x changes along y
    }
}

}  // namespace
}  // namespace interphase::testing_gas
