// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proves that cutting the mesh among ranks changes nothing of the gas but round-off and what the pressure's tolerance
// leaves: a flow in three dimensions through a voidage that moves, periodic across one cut, against the same with
// all cells on one of the ranks. And that parts keep gas volume and momentum as a whole does.
#include <tuple>

#include "engines/openfoam/gas_case.hpp"
#include "support/world.hpp"

namespace interphase::testing_gas {
namespace {

using test::world;

constexpr double k = 2 * M_PI, density = 1.2, gas_step = 5e-3;
constexpr std::array<int, 3> cells{8, 8, 4};
constexpr int steps = 8;

double voidage(const Vector& x, double t)
{
    return 0.6 + 0.2 * std::sin(k * x.x() + 2 * t) * std::cos(k * x.y()) * std::cos(k * x.z());
}

Scene scene()
{
    Scene s;
    s.cells = cells;
    s.sides = {periodic, periodic, periodic};
    s.density = density;
    s.viscosity = 2e-3;
    s.gas_step = gas_step;
    s.outer_correctors = 4;  // with which a whole mesh keeps momentum to round-off (gas_momentum_test.cpp)
    s.correctors = 3;
    s.velocity = [](const Vector&) { return Vector(1, 0.5, 0.25); };
    return s;
}

/// Of a cell, by its centre.
std::size_t number_in_whole(const Vector& centre)
{
    std::size_t number = 0;
    for (int axis = 2; axis >= 0; --axis)
        number = number * static_cast<std::size_t>(cells[axis]) + static_cast<std::size_t>(centre[axis] * cells[axis]);
    return number;
}

/// What is left in the end, of this rank's cells, and the balances over all cells of all ranks that share the case.
struct Solution {
    std::vector<Vector> centre;
    Scalars velocity, gradient, outflow;
    double momentum_residual = 0;  ///< relative to the impulse exchanged
    double volume_residual = 0;    ///< of a cell's gas in a step, at most, relative to the volume of a cell
    double crossed = 0;            ///< the outer boundary [m3]
};

Solution solve(GasCase& gas)
{
    const auto sum = [](double x) { return world().sum(x); };
    const auto total = [&](Vector v) { return Vector(sum(v.x()), sum(v.y()), sum(v.z())); };
    const auto eps_at = [&](double t) { return gas.sampled([t](const Vector& x) { return voidage(x, t); }); };
    const auto momentum = [&](const Scalars& eps) {
        Vector here(0, 0, 0);
        for (std::size_t c = 0; c < gas.cells(); ++c)
            here += density * eps[c] * gas.volume(c) * gas.velocity(c);
        return total(here);
    };
    const Scalars rate = gas.sampled([](const Vector& x) { return 20 * (1 - voidage(x, 0)); });
    const Scalars source = gas.sampled(VectorField([](const Vector& x) {
        return Vector(20 * (1 - voidage(x, 0)) * Vector(0.2 * std::sin(k * x.y()), -0.4, 0.1));
    }));
    Solution found;
    Scalars eps = eps_at(0);
    gas.step(eps, rate, source);
    double lost = 0, exchanged = 0;
    for (int n = 1; n <= steps; ++n) {
        const Vector before = momentum(eps);
        const Scalars eps_before = eps;
        eps = eps_at(n * gas_step);
        gas.step(eps, rate, source);
        const Scalars u = gas.velocities(), gradient = gas.pressure_gradients(), outflow = gas.outflows();
        Vector impulse(0, 0, 0);
        double size = 0;
        for (std::size_t c = 0; c < gas.cells(); ++c) {
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t i = 3 * c + static_cast<std::size_t>(axis);
                const double on_solids = rate[c] * u[i] - source[i] - (1 - eps[c]) * gradient[i];
                impulse[axis] -= gas_step * gas.volume(c) * on_solids;
                size += gas_step * gas.volume(c) * std::abs(on_solids);
            }
            const double kept = eps[c] - eps_before[c] + outflow[c] / gas.volume(c);
            found.volume_residual = std::max(found.volume_residual, std::abs(kept));
        }
        lost += (momentum(eps) - before - total(impulse)).norm();
        exchanged += sum(size);
        found.crossed += sum(gas.crossing().in + gas.crossing().out);
    }
    found.momentum_residual = lost / exchanged;
    found.velocity = gas.velocities();
    found.gradient = gas.pressure_gradients();
    found.outflow = gas.outflows();
    for (std::size_t c = 0; c < gas.cells(); ++c)
        found.centre.push_back(gas.centre(c));
    return found;
}

/// Each rank's cells: of blocks along x and y, with as many along x as there are ranks over two.
std::vector<int> blocks()
{
    const int along_x = world().size() / 2;
    std::vector<int> owner;
    for (int z = 0; z < cells[2]; ++z)
        for (int y = 0; y < cells[1]; ++y)
            for (int x = 0; x < cells[0]; ++x)
                owner.push_back(x * along_x / cells[0] + along_x * (y * 2 / cells[1]));
    return owner;
}

Solution solved(const std::vector<int>& rank_of_cell)
{
    GasCase gas(scene(), rank_of_cell);
    return solve(gas);
}

void share(Scalars& values)
{
    int size = static_cast<int>(values.size());
    MPI_Bcast(&size, 1, MPI_INT, 0, world().handle());
    values.resize(static_cast<std::size_t>(size));
    MPI_Bcast(values.data(), size, MPI_DOUBLE, 0, world().handle());
}

/// On all ranks, all of it.
Solution of_the_whole()
{
    Solution whole = solved(std::vector<int>(static_cast<std::size_t>(cells[0] * cells[1] * cells[2]), 0));
    Scalars centres;
    for (const Vector& x : whole.centre)
        centres.insert(centres.end(), x.data(), x.data() + 3);
    for (Scalars* values : {&centres, &whole.velocity, &whole.gradient, &whole.outflow})
        share(*values);
    whole.centre.clear();
    for (std::size_t c = 0; 3 * c < centres.size(); ++c)
        whole.centre.emplace_back(centres[3 * c], centres[3 * c + 1], centres[3 * c + 2]);
    return whole;
}

/// The whole mesh on rank 0, and cut into as many parts as there are ranks; each solved once.
const std::pair<Solution, Solution>& solutions()
{
    static const std::pair<Solution, Solution> both(of_the_whole(), solved(blocks()));
    return both;
}

class GasOnRanks : public testing::Test {
protected:
    void SetUp() override
    {
        if (world().size() == 1) GTEST_SKIP() << "one rank has the whole mesh, which the serial tests look at";
        std::tie(whole, parts) = solutions();
    }
    Solution whole, parts;
};

TEST_F(GasOnRanks, EveryCellIsOnOneRank)
{
    EXPECT_EQ(world().sum(static_cast<long>(parts.centre.size())), cells[0] * cells[1] * cells[2]);
    EXPECT_EQ(parts.centre.size() * static_cast<std::size_t>(world().size()), whole.centre.size());
}

TEST_F(GasOnRanks, TheSolutionIsThatOfTheWholeMesh)
{
    for (std::size_t c = 0; c < parts.centre.size(); ++c) {
        const std::size_t same = number_in_whole(parts.centre[c]);
        ASSERT_LT((parts.centre[c] - whole.centre[same]).norm(), 1e-12);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // 5e-12 is seen at most, of velocities of 1 m/s and gradients of some Pa/m: the pressure's tolerance is
            // 1e-12
            EXPECT_NEAR(parts.velocity[3 * c + axis], whole.velocity[3 * same + axis], 1e-10);
            EXPECT_NEAR(parts.gradient[3 * c + axis], whole.gradient[3 * same + axis], 1e-10);
        }
        EXPECT_NEAR(parts.outflow[c], whole.outflow[same], 1e-14);
    }
}

TEST_F(GasOnRanks, TheFlowIsOneThatRanksCouldGetWrong)
{
    // it crosses the cuts, and differs from cell to cell
    double least = 1e300, most = -1e300;
    for (std::size_t c = 0; c < whole.centre.size(); ++c) {
        least = std::min(least, whole.velocity[3 * c + 1]);
        most = std::max(most, whole.velocity[3 * c + 1]);
    }
    EXPECT_GT(most - least, 0.05);
}

TEST_F(GasOnRanks, GasVolumeIsKeptInEveryCell)
{
    EXPECT_LT(world().max(parts.volume_residual), 1e-12);
    EXPECT_EQ(parts.crossed, 0) << "a cut is no outer boundary";
}

TEST_F(GasOnRanks, MomentumIsKept) { EXPECT_LT(parts.momentum_residual, 1e-11) << whole.momentum_residual; }

}  // namespace
}  // namespace interphase::testing_gas
