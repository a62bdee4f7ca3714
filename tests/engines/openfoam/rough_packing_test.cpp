// SPDX-License-Identifier: GPL-3.0-or-later
// Gas forced through a packing whose voidage differs from cell to cell, as that of few parcels per cell does: the
// velocity that drag sees there should be U/eps, with the superficial velocity U. How near it comes.
#include <random>

#include "engines/openfoam/gas_case.hpp"
#include "support/measured.hpp"

namespace interphase::testing_gas {
namespace {

constexpr double superficial = 0.8, density = 1.2, viscosity = 1.8e-5, diameter = 1e-3;

/// Ergun's drag of spheres at rest, over u [kg/(m3 s)].
double ergun_rate(double eps)
{
    const double phi = 1 - eps;
    return 150 * phi * phi / eps * viscosity / (diameter * diameter) +
           1.75 * phi * density * superficial / eps / diameter;
}

/// eps u / U of each cell at least eight cells from the ends, of which the outer four are empty.
std::vector<double> relative_velocities(const std::function<double(int)>& voidage_of)
{
    constexpr int cells = 64, ends = 8;
    Scene scene;
    scene.size = {0.32, 0.005, 0.005};
    scene.cells = {cells, 1, 1};
    scene.sides[0] = through_flow("(0.8 0 0)");
    scene.density = density;
    scene.viscosity = viscosity;
    scene.velocity = [](const Vector&) { return Vector(superficial, 0, 0); };
    GasCase gas(scene);
    Scalars eps, rate;
    for (int c = 0; c < cells; ++c) {
        const bool empty = c < ends / 2 || c >= cells - ends / 2;
        eps.push_back(empty ? 1.0 : voidage_of(c));
        rate.push_back(empty ? 0.0 : ergun_rate(eps.back()));
    }
    const Scalars none(3 * gas.cells(), 0.0);
    for (int n = 0; n < 300; ++n)
        gas.step(eps, rate, none);
    std::vector<double> found;
    for (std::size_t c = ends; c < cells - ends; ++c)
        found.push_back(gas.velocity(c).x() * eps[c] / superficial);
    return found;
}

double error(const std::vector<double>& relative)
{
    double squares = 0;
    for (const double r : relative)
        squares += (r - 1) * (r - 1);
    return std::sqrt(squares / static_cast<double>(relative.size()));
}

TEST(RoughPacking, HasTheVelocityOfTheFluxInsideALayerOfFourCells)
{
    const std::vector<double> relative = relative_velocities([](int c) { return c / 4 % 2 ? 0.4 : 0.5; });
    double worst[2] = {0, 0};
    for (std::size_t i = 0; i < relative.size(); ++i)
        worst[i % 4 == 1 || i % 4 == 2] = std::max(worst[i % 4 == 1 || i % 4 == 2], std::abs(relative[i] - 1));
    const std::string name = "layers of four cells, voidage 0.4 and 0.5 in turn: velocity that drag sees, off U/eps, ";
    test::expect_below({name + "inside them", "%", "continuity"}, 100 * worst[true], 1);
    test::expect_below({name + "at their faces", "%", "continuity"}, 100 * worst[false],
                       20);  // shared with the neighbour
}

TEST(RoughPacking, SharesTheDropOfSingleCellsWithTheirNeighbours)
{
    // Limits, not aims: 0.35 and 0.24 are seen. The gradient of the cell's neighbours times the cell's own voidage
    // instead of forces at its faces had 0.47 and 0.32. It makes MP-PIC's beds, whose cells are this rough, denser.
    test::expect_below({"single cells of voidage 0.4 and 0.5 in turn: the same, root mean square", "%", "continuity"},
                       100 * error(relative_velocities([](int c) { return c % 2 ? 0.4 : 0.5; })), 37);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> between(0.38, 0.6);
    EXPECT_LT(error(relative_velocities([&](int) { return between(random); })), 0.26);
}

}  // namespace
}  // namespace interphase::testing_gas
