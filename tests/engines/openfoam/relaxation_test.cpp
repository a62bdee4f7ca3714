// SPDX-License-Identifier: GPL-3.0-or-later
// Proves the order of the time schemes on the exchange itself: uniform gas in a periodic box with uniform drag relaxes
// exactly exponentially, u' = -(K/(rho eps)) (u - u_s). And that no ratio of gas step to relaxation time makes it
// overshoot with Euler.
#include "engines/openfoam/gas_case.hpp"

namespace interphase::testing_gas {
namespace {

constexpr double voidage = 0.5, density = 1.2, rate = 6.0;  // K/(rho eps) = 10/s
constexpr double per_second = rate / (density * voidage);
const Vector at_start(1, -2, 0), of_solids(-0.5, 0.25, 0);

Scene box(double gas_step, const std::string& time_scheme)
{
    Scene scene;
    scene.cells = {4, 4, 1};
    scene.sides = {periodic, periodic, unresolved};
    scene.density = density;
    scene.gas_step = gas_step;
    scene.time_scheme = time_scheme;
    scene.velocity = [](const Vector&) { return at_start; };
    return scene;
}

/// The largest difference of a cell's velocity from `expected` after `steps` with K = `drag`, the coupler's way.
double difference(const Scene& scene, int steps, double drag, const Vector& expected)
{
    GasCase gas(scene);
    const Scalars drag_rate(gas.cells(), drag);
    const Scalars source = gas.sampled(VectorField([drag](const Vector&) { return Vector(drag * of_solids); }));
    for (int n = 0; n < steps; ++n)
        gas.step(Scalars(gas.cells(), voidage), drag_rate, source);
    double worst = 0;
    for (std::size_t c = 0; c < gas.cells(); ++c)
        worst = std::max(worst, (gas.velocity(c) - expected).norm());
    return worst;
}

std::vector<double> errors(const std::string& time_scheme)
{
    constexpr double duration = 0.2;  // two relaxation times
    const Vector exact = of_solids + std::exp(-per_second * duration) * (at_start - of_solids);
    std::vector<double> found;
    for (const int steps : {20, 40, 80})
        found.push_back(difference(box(duration / steps, time_scheme), steps, rate, exact));
    return found;
}

TEST(Relaxation, IsFirstOrderWithEuler)
{
    // Euler's own remainder at these steps: x/2 (1 + 5x/6 ...), x = 0.1, 0.05, 0.025; 5 % of the order
    for (const double order : observed_orders(errors("Euler")))
        EXPECT_NEAR(order, 1, 0.1);
}

TEST(Relaxation, IsEulersRuleToRoundOff)
{
    constexpr double gas_step = 0.01;
    constexpr int steps = 20;
    const Vector expected = of_solids + std::pow(1 + per_second * gas_step, -steps) * (at_start - of_solids);
    // a uniform field needs no pressure; the matrix of U is solved to 1e-14, and every step adds to it
    EXPECT_LT(difference(box(gas_step, "Euler"), steps, rate, expected), 1e-12);
}

TEST(Relaxation, IsSecondOrderWithBackward)
{
    // the first step, where there is only one old field, is Euler's: its error is of second order too, once
    for (const double order : observed_orders(errors("backward")))
        EXPECT_NEAR(order, 2, 0.2);
}

TEST(Relaxation, DoesNotOvershootHoweverStiffTheDrag)
{
    for (const double stiffness : {1e-3, 1.0, 1e3, 1e6}) {  // gas step over relaxation time
        const Scene scene = box(1e-3, "Euler");
        const double drag = stiffness * density * voidage / scene.gas_step;
        const Vector expected = of_solids + (at_start - of_solids) / (1 + stiffness);
        EXPECT_LT(difference(scene, 1, drag, expected), 1e-12) << "gas step / relaxation time = " << stiffness;
    }
}

}  // namespace
}  // namespace interphase::testing_gas
