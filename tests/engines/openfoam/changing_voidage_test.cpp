// SPDX-License-Identifier: GPL-3.0-or-later
// Proves that the gas makes way for solids: in a column closed below, where the voidage is uniform and changes in time, gas
// conservation alone fixes the velocity, u(x) = -x (d eps/dt)/eps.
#include "engines/openfoam/gas_case.hpp"

namespace interphase::testing_gas {
namespace {

Scene column(int cells, double gas_step, const std::string& time_scheme)
{
    Scene scene;
    scene.size = {1, 0.1, 0.1};
    scene.cells = {cells, 1, 1};
    scene.sides[0] = {"wall",
                      {"type fixedValue; value uniform (0 0 0);", "type zeroGradient;"},
                      {"type fixedFluxPressure; gradient uniform 0; value uniform 0;", "type fixedValue; value uniform 0;"}};
    scene.gas_step = gas_step;
    scene.time_scheme = time_scheme;
    return scene;
}

/// The largest difference of u from the exact one in a column after `duration`, relative to the largest u.
double error(const Scene& scene, double duration, const std::function<double(double)>& voidage,
             const std::function<double(double)>& rate_of_change)
{
    GasCase gas(scene);
    const Scalars nothing(gas.cells(), 0.0), no_source(3 * gas.cells(), 0.0);
    gas.step(Scalars(gas.cells(), voidage(0)), nothing, no_source);
    const double start = gas.time();
    while (gas.time() - start < duration - 0.5 * scene.gas_step)
        gas.step(Scalars(gas.cells(), voidage(gas.time() + scene.gas_step - start)), nothing, no_source);

    double worst = 0;
    const double stretch = -rate_of_change(duration) / voidage(duration);
    for (std::size_t c = 0; c < gas.cells(); ++c)
        worst = std::max(worst, std::abs(gas.velocity(c).x() - stretch * gas.centre(c).x()));
    return worst / std::abs(stretch);
}

TEST(ChangingVoidage, PushesTheGasOutOfAColumn)
{
    for (const char* scheme : {"Euler", "backward"}) {
        std::printf("%s %g\n", scheme, error(column(20, 0.01, scheme), 0.2, [](double t) { return 0.8 - t; }, [](double) { return -1.0; }));
    }
}

}  // namespace
}  // namespace interphase::testing_gas
