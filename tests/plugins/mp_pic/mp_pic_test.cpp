// SPDX-License-Identifier: GPL-3.0-or-later
// The pure functions of MP-PIC: stress laws against values by hand, the limiter's promises, bounces off walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mp_pic/stress_check.hpp"
#include "mp_pic/stress_law.hpp"
#include "mp_pic/velocity_limiter.hpp"
#include "mp_pic/wall_bounce.hpp"
#include "walls/triangle_wall.hpp"

namespace {

using namespace interphase;
using namespace interphase::mp_pic;

TEST(HarrisCrighton, HasTheValuesOfEquation8)
{
    const HarrisCrighton law{50, 3, 0.6};
    EXPECT_DOUBLE_EQ(law.stress(0), 0);
    EXPECT_NEAR(law.stress(0.5), 50 * 0.125 / 0.1, 1e-11);
    EXPECT_NEAR(law.stress(0.3), 50 * 0.027 / 0.3, 1e-12);
    // beyond close packing alpha (1 - phi) keeps it finite and rising
    EXPECT_NEAR(law.stress(0.7), 50 * 0.343 / (1e-7 * 0.3), 1);
    EXPECT_TRUE(std::isfinite(law.stress(1.0)));
    EXPECT_TRUE(std::isfinite(law.stress(2.0)));  // clamped: a gas cell is never handed more than it holds
}

TEST(HarrisCrighton, RisesWithTheSolidFraction)
{
    for (const double exponent : {2.0, 3.0, 5.0}) {
        const HarrisCrighton law{10, exponent, 0.6};
        double last = -1;
        for (int k = 0; k < 1000; ++k) {
            const double stress = law.stress(k / 1000.0);
            EXPECT_GT(stress, last) << k;
            last = stress;
        }
    }
}

TEST(Lun, HasTheDiluteLimitOfAnIdealGasAndTheContactTermOfTheDense)
{
    const Lun law{1000, 0.01, 0.9, 0.63};
    EXPECT_NEAR(law.stress(1e-6) / (1000 * 1e-6 * 0.01), 1, 1e-5);  // rho phi Theta, contacts 4e-6 of it
    const double g0 = std::pow(1 - 0.4 / 0.63, -2.5 * 0.63);
    EXPECT_NEAR(law.stress(0.4), 1000 * 0.4 * 0.01 * (1 + 2 * 1.9 * 0.4 * g0), 1e-12);
    EXPECT_TRUE(std::isfinite(law.stress(0.8)));
}

TEST(AnyStress, HasTheNumbersInTheirOrder)
{
    const AnyStress lun = any_stress<Lun>("lun");
    ASSERT_EQ(lun.numbers.size(), 3U);
    const StressFunction stress = lun.of({1000, 0.01, 0.9, 0.63});
    EXPECT_EQ(stress(0.4), (Lun{1000, 0.01, 0.9, 0.63}.stress(0.4)));
}

TEST(StressCheck, LooksAtClosePackingAndBothEnds)
{
    const std::vector<double> phi = looked_at(0.61234567);
    EXPECT_EQ(phi.front(), 0);
    EXPECT_EQ(phi.back(), 1);
    EXPECT_TRUE(std::binary_search(phi.begin(), phi.end(), 0.61234567));
    EXPECT_TRUE(std::is_sorted(phi.begin(), phi.end()));
}

TEST(StressCheck, PassesWhatIsPublished)
{
    for (const double packing : {0.3, 0.6, 0.61234567, 0.74, 0.99}) {
        for (const double exponent : {2.0, 3.0, 5.0})
            EXPECT_EQ(complaint_of(
                          [=](double phi) {
                              return HarrisCrighton{100, exponent, packing}.stress(phi);
                          },
                          looked_at(packing)),
                      "");
        EXPECT_EQ(complaint_of(
                      [=](double phi) {
                          return Lun{2500, 0.1, 0.9, packing}.stress(phi);
                      },
                      looked_at(packing)),
                  "");
    }
    EXPECT_EQ(complaint_of([](double) { return 0.0; }, looked_at(0.6)), "");
}

TEST(Limiter, GivesTheWholeStressWhereItIsSmall)
{
    StressState state;
    state.gradient[2] = -200;
    state.solid_fraction = 0.4;
    state.relaxation_time = 0.01;
    state.mean_velocity[2] = 0.1;
    const double dt = 1e-3, density = 1000, expected = dt * 200 / (1000 * 0.4 * 1.1);
    const Vector change = limited_stress_change(state, {0, 0, -0.5}, {0, 0, -0.5}, density, 0.9, dt);
    EXPECT_LT((change - Vector(0, 0, expected)).norm(), 1e-15);
}

TEST(Limiter, NeverFlings)
{
    // Whatever stress and motion are: relative to the mean, no particle is faster afterwards than before, and none
    // turns round but by restitution.
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int n = 0; n < 100000; ++n) {
        const double change = std::pow(10, 8 * any(random)), slope = any(random), e = 0.5 * (1 + any(random)),
                     to_mean = any(random);
        const double wanted = slope <= 0 ? change : -change;
        const double given = limited_change(wanted, slope, {to_mean, to_mean, 0}, e);
        const double before = -to_mean, after = before + given;
        EXPECT_LE(std::abs(after), std::abs(before) * (1 + 1e-15));
        EXPECT_GE(given * wanted, 0);                  // along the stress's force
        EXPECT_LE(std::abs(given), std::abs(wanted));  // and no more than it
        if (before * slope < 0) {
            EXPECT_EQ(given, 0);  // moves down the stress already
        }
        if (after * before < 0) {
            EXPECT_LE(std::abs(after), e * std::abs(before) + 1e-15);
        }
    }
}

TEST(Limiter, LetsWhatClosesUpBeStoppedAndNoMore)
{
    // a particle that falls with the mean motion at 2 m/s onto what rests: no stress, however large, turns it round
    EXPECT_EQ(limited_change(1e9, -1, {0, 0, 2}, 0.9), 2);
    EXPECT_EQ(limited_change(-1e9, 1, {0, 0, 2}, 0.9), -2);  // mirrored
    EXPECT_EQ(limited_change(0.5, -1, {0, 0, 2}, 0.9), 0.5);
}

TEST(Limiter, HoldsABedAtRestAndDoesNotShakeIt)
{
    // gravity has added 0.01 m/s to a particle that moved with the mean: exactly that is taken away, whatever e is
    for (const double e : {0.0, 0.5, 1.0})
        EXPECT_EQ(limited_change(1e9, -1, {0.01, 0, 0}, e), 0.01);
}

TEST(Limiter, DoesNothingWithoutASlopeOrWithTheMean)
{
    StressState state;
    state.solid_fraction = 0.6;
    state.relaxation_time = 1;
    EXPECT_EQ(limited_stress_change(state, {1, -2, 3}, {1, -2, 3}, 1000, 0.9, 1e-3), Vector(0, 0, 0));
    state.gradient[0] = 1e12;
    state.mean_velocity[0] = 0.25;
    EXPECT_EQ(limited_stress_change(state, {0.25, 0, 0}, {0.25, 0, 0}, 1000, 0.9, 1e-3), Vector(0, 0, 0));
}

TEST(LongestStep, IsThatOfTheShortestAxisAndTheActualDrag)
{
    StressState state;
    state.cell_size[0] = 0.01;
    state.cell_size[1] = 0.02;
    state.cell_size[2] = 0.005;
    state.relaxation_time = 0.3;
    const LongestStep step = longest_step(state, {1, -4, 0}, 0.5, 0.1);
    EXPECT_DOUBLE_EQ(step.crossing, 0.5 * 0.02 / 4);
    EXPECT_DOUBLE_EQ(step.relaxation, 0.03);
    EXPECT_GT(longest_step(state, {0, 0, 0}, 1, 1).crossing, 1e100);
}

using Walls = std::vector<std::unique_ptr<walls::Wall>>;

walls::Place sphere(double x, double y, double z, double radius = 0.01)
{
    walls::Place place;
    place.centre[0] = x;
    place.centre[1] = y;
    place.centre[2] = z;
    place.radius = radius;
    return place;
}

TEST(Bounce, OffAPlaneIsExactInTimeAndPlace)
{
    Walls walls;
    walls.push_back(std::make_unique<walls::PlaneWall>(0, 2, 0.0));
    const std::vector<WallLaw> laws{{0.8, 0.5}};
    // touches after 0.01 s, has 0.02 s left
    const Drift moved = drift(sphere(0, 0, 0.02), {0.3, 0, -1}, 0.03, walls, laws);
    EXPECT_LT((moved.velocity - Vector(0.15, 0, 0.8)).norm(), 1e-15);
    EXPECT_LT((moved.position - Vector(0.01 * 0.3 + 0.02 * 0.15, 0, 0.01 + 0.02 * 0.8)).norm(), 1e-15);
    EXPECT_EQ(moved.bounces.size(), 1u);
    EXPECT_EQ(moved.pushed, 0);
}

TEST(Bounce, OffTrianglesIsAsOffThePlaneTheyMake)
{
    std::vector<walls::Triangle> triangles{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(-1, 1, 0)},
                                           {Vector(1, 1, 0), Vector(-1, 1, 0), Vector(1, -1, 0)}};
    Walls plane, mesh;
    plane.push_back(std::make_unique<walls::PlaneWall>(0, 2, 0.0));
    mesh.push_back(std::make_unique<walls::TriangleWall>(0, walls::Surface{triangles, {}, false}));
    const std::vector<WallLaw> laws{{0.9, 0.7}};
    for (const double across : {-0.4, 0.0, 0.3}) {
        const Drift a = drift(sphere(across, 0.1, 0.015), {0.5, -0.2, -2}, 0.01, plane, laws);
        const Drift b = drift(sphere(across, 0.1, 0.015), {0.5, -0.2, -2}, 0.01, mesh, laws);
        EXPECT_EQ(b.bounces.size(), 1u);
        // round-off of coordinates of the triangles' size, over the radius: it tilts the normal
        EXPECT_LT((a.position - b.position).norm() + (a.velocity - b.velocity).norm(), 1e-12);
    }
}

TEST(Bounce, NothingGetsThroughAWall)
{
    // however far it moves in a step: 100 radii, from anywhere in a box, a cylinder with two ends
    Walls box, cylinder;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-0.1, 0.1})
            box.push_back(std::make_unique<walls::PlaneWall>(0, axis, side));
    cylinder.push_back(std::make_unique<walls::CylinderWall>(0, 2, 0.1, 0, 0));
    for (const double side : {-0.1, 0.1})
        cylinder.push_back(std::make_unique<walls::PlaneWall>(0, 2, side));
    const std::vector<WallLaw> laws{{0.9, 0.95}};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int n = 0; n < 2000; ++n) {
        const Vector velocity = 100 * Vector(any(random), any(random), any(random));
        const auto start = sphere(0.06 * any(random), 0.06 * any(random), 0.08 * any(random));
        for (const Walls* walls : {&box, &cylinder}) {
            const Drift moved = drift(start, velocity, 1e-2, *walls, laws);
            // in the cylinder's edge it may be pushed out of one wall into another by less than half a radius
            EXPECT_LT(moved.position.cwiseAbs().maxCoeff(), 0.095) << velocity.transpose();
            EXPECT_LE(moved.velocity.norm(), velocity.norm() * (1 + 1e-12));
        }
    }
}

TEST(Bounce, ASphereThatBeginsInAWallIsPutOutWithoutGainingSpeed)
{
    Walls walls;
    walls.push_back(std::make_unique<walls::PlaneWall>(0, 0, 0.0));
    const Drift leaving = drift(sphere(0.004, 0, 0), {0.1, 0, 0}, 1e-3, walls, {{0.5, 1}});
    EXPECT_NEAR(leaving.position[0], 0.01, 1e-15);
    EXPECT_EQ(leaving.velocity[0], 0.1);
    EXPECT_EQ(leaving.pushed, 1);
    const Drift entering = drift(sphere(0.004, 0, 0), {-0.1, 0, 0}, 1e-3, walls, {{0.5, 1}});
    EXPECT_GE(entering.position[0], 0.01 - 1e-15);
    EXPECT_NEAR(entering.velocity[0], 0.05, 1e-16);
}

}  // namespace
