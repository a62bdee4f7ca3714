// SPDX-License-Identifier: GPL-3.0-or-later
//
// Saffman's limit, Mei's correction at points worked out by hand, the side that lift pushes to, and what a parcel
// feels.
#include "forces/saffman_mei_lift/saffman_mei_lift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/measured.hpp"

namespace {

using namespace interphase;

/// A sphere that lags by `slip` behind a gas that flows along x, faster the larger y is by `shear`.
ParticleInGas in_shear(double slip, double shear)
{
    ParticleInGas at;
    at.gas_velocity = Vector(1, 0, 0);
    at.velocity = Vector(1 - slip, 0, 0);
    at.diameter = 1e-3;
    at.volume = M_PI / 6 * 1e-9;
    at.mass = 1e-6;
    at.density = 1000;
    at.viscosity = 1e-3;
    at.velocity_gradient(1, 0) = shear;  // du_x/dy
    return at;
}

Vector lift(const ParticleInGas& at)
{
    Response response;
    SaffmanMeiLift().act(at, response);
    EXPECT_EQ(response.rate, 0);
    EXPECT_EQ(response.added_mass, 0);
    return response.force;
}

/// 1.615 d^2 sqrt(rho mu G) s.
double saffman(const ParticleInGas& at, double slip, double shear)
{
    return 1.615 * at.diameter * at.diameter * std::sqrt(at.density * at.viscosity * shear) * slip;
}

TEST(SaffmanMeiLift, PushesASphereThatLagsToTheFasterSide)
{
    const Vector force = lift(in_shear(1e-3, 5));
    EXPECT_GT(force.y(), 0);
    EXPECT_EQ(force.x(), 0);
    EXPECT_EQ(force.z(), 0);
    EXPECT_LT(lift(in_shear(-1e-3, 5)).y(), 0);  // one that leads to the slower
    EXPECT_LT(lift(in_shear(1e-3, -5)).y(), 0);
}

TEST(SaffmanMeiLift, IsSaffmansWhereReynoldsVanishes)
{
    const double slip = 1e-9, shear = 1e-3;  // Re = 1e-6: C = 1 to Re/10 (1 - 0.3314 sqrt b), b = 500
    const ParticleInGas at = in_shear(slip, shear);
    test::expect_within(
        {"lift at Re 1e-6 over 1.615 d^2 sqrt(rho mu G) s", "", "Saffman, J. Fluid Mech. 22 (1965) 385"},
        lift(at).y() / saffman(at, slip, shear), 1, 1e-5);
}

TEST(SaffmanMeiLift, HasMeisCorrection)
{
    struct {
        double reynolds, b, correction;
    } const by_hand[] = {
        {10, 0.1, (1 - 0.104798) * 0.3678794 + 0.104798},  // 0.3314 sqrt 0.1 = 0.104798, e^-1
        {1, 0.4, (1 - 0.209595) * 0.9048374 + 0.209595},   // 0.3314 sqrt 0.4, e^-0.1
        {100, 0.04, 0.1048},                               // 0.0524 sqrt 4
    };
    double worst = 0;
    for (const auto& point : by_hand) {
        const double slip = point.reynolds * 1e-3, shear = 2 * point.b * slip / 1e-3;  // rho d/mu = 1000 s/m
        const ParticleInGas at = in_shear(slip, shear);
        worst = std::max(worst, std::abs(lift(at).y() / saffman(at, slip, shear) - point.correction));
    }
    test::expect_below({"lift over Saffman's at Re 1, 10, 100, off the correction worked out by hand", "",
                        "Mei, Int. J. Multiphase Flow 18 (1992) 145"},
                       worst, 2e-6);
}

TEST(SaffmanMeiLift, JumpsByLittleBetweenItsBranches)
{
    // at Re = 40 they differ by (1 - 0.3314 sqrt b) e^-4 and by 0.0524 sqrt 40 = 0.33141 for 0.3314
    const auto at_reynolds = [](double reynolds) {
        const double slip = reynolds * 1e-3, shear = 0.2 * slip / 1e-3;
        const ParticleInGas at = in_shear(slip, shear);
        return lift(at).y() / saffman(at, slip, shear);
    };
    EXPECT_NEAR(at_reynolds(40 - 1e-9) - at_reynolds(40 + 1e-9), (1 - 0.3314 * std::sqrt(0.1)) * std::exp(-4), 1e-5);
}

TEST(SaffmanMeiLift, IsNoneWithoutShearOrSlip)
{
    EXPECT_EQ(lift(in_shear(1e-3, 0)), Vector::Zero());
    EXPECT_EQ(lift(in_shear(0, 5)), Vector::Zero());
}

TEST(SaffmanMeiLift, OfAParcelIsThatOfItsParticles)
{
    ParticleInGas parcel = in_shear(1e-3, 5);
    const Vector of_one = lift(parcel);
    parcel.volume *= 27;
    EXPECT_LT((lift(parcel) - 27 * of_one).norm(), 1e-12 * of_one.norm());
}

TEST(SaffmanMeiLift, CountsWhatIsBeyondItsRange)
{
    SaffmanMeiLift term;
    Response response;
    const auto counted = [&] { return term.counts().at(0).number; };
    term.act(in_shear(50e-3, 5), response);  // Re = 50, b = 0.05
    EXPECT_EQ(counted(), 0);
    term.act(in_shear(200e-3, 5), response);  // Re = 200
    EXPECT_EQ(counted(), 1);
    term.act(in_shear(1e-3, 5), response);  // b = 2.5
    EXPECT_EQ(counted(), 2);
}

}  // namespace
