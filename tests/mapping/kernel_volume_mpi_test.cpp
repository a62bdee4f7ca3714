// SPDX-License-Identifier: GPL-3.0-or-later
//
// The volume over which a sphere is spread, 1/sum_c (w_c^2/V_c): what the mapping says of it beside what its weights
// are.
#include "mapping/kernel_volume.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mapping/mapping.hpp"
#include "support/box_mesh.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::alone;
using test::BoxMesh;
using test::world;

constexpr double side = 1.0;
constexpr int cells = 12;

BoxMesh::Planes planes()
{
    const Scalars even = test::even_planes(0, cells * side, cells);
    return {even, even, even};
}

/// Places anywhere in the middle cells, off the walls by more than the widest kernel.
Vectors places(std::size_t count)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> within(5 * side, 7 * side);
    Vectors all(count);
    for (Vector& x : all)
        x = {within(random), within(random), within(random)};
    return all;
}

/// Of spheres of one size, on whichever rank they are: as said, and as their weights make it. [places]
struct Volumes {
    Scalars said, made;
};

Volumes volumes_of(const Communicator& comm, double diameter, const Vectors& all)
{
    const BoxMesh mesh(comm, planes(), 2);
    Mapping mapping(comm, mesh.view(), {MappingType::kernel, 2, 0, 1e9});
    const double volume = M_PI / 6 * diameter * diameter * diameter;
    Volumes volumes;
    for (const Vector& x : all) {
        const CellAddress address = mesh.address_of(x);
        const bool is_here = address.rank == comm.rank();
        const std::size_t count = is_here ? 1 : 0;
        const std::vector<int> own(count, address.cell);
        mapping.place(Vectors(count, x), own, Scalars(count, volume));
        mapping.solid_volume(Scalars(count, volume));
        double squares = 0;
        for (const double content : mapping.deposit(Scalars(count, 1.0)))
            squares += content * content / (side * side * side);
        volumes.made.push_back(1 / comm.sum(squares));
        const double said = is_here ? mapping.kernel_volume(x, address.cell, volume, Vector::Zero()).here : 0.0;
        volumes.said.push_back(comm.sum(said));
    }
    return volumes;
}

TEST(KernelVolume, IsThatOfTheWeightsOnUniformBoxes)
{
    for (const double diameter : {0.1, 0.3, 0.5, 0.7, 1.0, 1.4, 2.0}) {
        const Volumes volumes = volumes_of(world(), diameter * side, places(60));
        // exact where cells are wide enough for the weights alone; diffusion and points are fitted, within 11 % here
        const double tolerance = diameter <= 0.5 ? 1e-12 : 0.13;
        for (std::size_t i = 0; i < volumes.said.size(); ++i)
            EXPECT_NEAR(volumes.said[i] / volumes.made[i], 1, tolerance) << "d/h = " << diameter;
    }
}

TEST(KernelVolume, IsTheSameOnAnyNumberOfRanks)
{
    const Vectors all = places(20);
    for (const double diameter : {0.3, 1.0}) {
        const Volumes together = volumes_of(world(), diameter * side, all),
                      one = volumes_of(alone(), diameter * side, all);
        for (std::size_t i = 0; i < all.size(); ++i)
            EXPECT_NEAR(together.said[i] / one.said[i], 1, 1e-12);  // sums of some tens of terms, in other orders
    }
}

}  // namespace
