// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parcels of different weights in one scene: each moves as the real particles that it stands for, and the gas gives to
// a mixture what it gives to as much solid of single particles. (That the books close and ranks agree with weights
// drawn at random: balance_mpi_test.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "support/measured.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::Scene;
using test::world;

constexpr double cell = 0.02, gas_density = 1.2, viscosity = 1.8e-5, diameter = 5e-4, density = 1131;
constexpr double solid_step = 1e-4;
constexpr int substeps = 10;
const Vector gravity(0, 0, -9.81);

test::BoxMesh::Planes planes()
{
    return {test::even_planes(0, 4 * cell, 4), test::even_planes(0, 4 * cell, 4), test::even_planes(0, 12 * cell, 12)};
}

/// A parcel of `weight` of the same real particles.
Particle parcel(int id, double weight, const Vector& position)
{
    Particle p;
    p.id = id;
    p.position = position;
    p.diameter = diameter * std::cbrt(weight);
    p.density = density;
    p.weight = weight;
    return p;
}

std::unique_ptr<Scene> scene(const std::vector<Particle>& all, const Settings& rules)
{
    auto made = std::make_unique<Scene>(world(), planes(), gas_density, viscosity, all, gravity, solid_step, rules);
    made->gas.set_pressure_gradient({2, -1, -12});
    return made;
}

/// By number from 0, on all ranks [n x 3, m/s].
Scalars velocities(const Scene& s, std::size_t count)
{
    Scalars found(3 * count, 0.0);
    for (std::size_t i = 0; i < s.particles.size(); ++i)
        for (Eigen::Index k = 0; k < 3; ++k)
            found[3 * static_cast<std::size_t>(s.particles.id(i) - 1) + static_cast<std::size_t>(k)] =
                s.particles.velocity(i)[k];
    world().sum(found);
    return found;
}

TEST(Weights, ParcelsFlyAsTheirParticlesDo)
{
    // far from each other at the same height, in gas that is the same at each height and held as it is
    std::vector<Particle> all;
    for (const double weight : {1.0, 8.0, 27.0, 1000.0, 2.5})
        all.push_back(parcel(static_cast<int>(all.size()) + 1, weight,
                             Vector(0.3 + 0.7 * static_cast<double>(all.size()), 1.7, 9.4) * cell));
    double worst = 0;
    for (const MappingType mapping : {MappingType::cell_centre, MappingType::kernel}) {
        Settings rules;
        rules.mapping.type = mapping;
        rules.two_way = false;
        const auto s = scene(all, rules);
        for (std::size_t c = 0; c < s->mesh.view().size(); ++c)
            s->gas.set_velocity(c, {0.2, 0.1 * s->mesh.view().centre[c].z() / cell, 1});
        s->gas.hold_velocity();
        for (int n = 0; n < 60; ++n)
            s->advance(substeps);
        const Scalars v = velocities(*s, all.size());
        EXPECT_GT(Vector(v[0], v[1], v[2]).norm(), 0.1);
        for (std::size_t i = 0; i < v.size(); ++i)
            worst = std::max(worst, std::abs(v[i] - v[i % 3]));
    }
    // the fluid force is kept in single precision: 6e-8 of 1 m/s
    test::expect_below(
        {"parcels of W = 1 to 1000 of the same particles falling side by side: velocities apart", "m/s", "each other"},
        worst, 1e-7);
}

/// In each cell 64 real particles at its centre, all with the same velocity: as parcels of the weights given.
std::vector<Particle> mixture(const std::vector<double>& weights)
{
    std::vector<Particle> all;
    for (int layer = 2; layer < 6; ++layer)
        for (int row = 0; row < 4; ++row)
            for (const double weight : weights) {
                Particle p =
                    parcel(static_cast<int>(all.size()) + 1, weight, Vector(1.5, row + 0.5, layer + 0.5) * cell);
                p.velocity = Vector(0.1 * layer, 0, 0.05 * row);
                all.push_back(p);
            }
    return all;
}

TEST(Weights, AMixtureTakesFromTheGasWhatSingleParticlesTake)
{
    double worst = 0;
    for (const MappingType mapping : {MappingType::cell_centre, MappingType::kernel}) {
        Settings rules;
        rules.mapping.type = mapping;
        rules.mapping.width = 1.5 * cell;  // not that of the largest
        double exchanged = 0;
        const auto momentum_given = [&](const std::vector<double>& weights) {
            const auto s = scene(mixture(weights), rules);
            s->gas.set_velocity({0.5, 0, 3});
            for (int n = 0; n < 5; ++n)
                s->advance(substeps);
            EXPECT_LT(s->step.ledger().momentum.residual(), 1e-12);
            EXPECT_LT(s->step.ledger().solid_volume.residual(), 1e-12);
            exchanged = s->step.ledger().momentum.exchanged();
            return s->gas.momentum();
        };
        const Vector of_single = momentum_given(std::vector<double>(64, 1.0));
        for (const auto& weights : {std::vector<double>{64}, {32, 16, 8, 4, 2, 1, 1}, {27, 27, 3.5, 1.5, 5}}) {
            const Vector of_mixture = momentum_given(weights);
            worst = std::max(worst, (of_mixture - of_single).norm() / exchanged);
        }
    }
    // the fluid force is kept in single precision, 6e-8 of what is exchanged
    test::expect_below({"momentum that parcels of mixed weights take from the gas, off that of single particles", "",
                        "as much solid of W = 1"},
                       worst, 1e-7);
}

}  // namespace
