// SPDX-License-Identifier: GPL-3.0-or-later
//
// A particle's answer to drag over a gas step, exact for any ratio of step to relaxation time: the impulse that the gas
// solve assumes, and what the substeps apply.
#include "momentum/drag_response.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "momentum/fluid_force.hpp"

namespace {

using namespace interphase;

/// A few operations, each to 1e-16.
constexpr double rounding = 1e-14;

/// FluidForce keeps its coefficients in single precision: half a unit in its last place, 6e-8, and two of them meet.
constexpr double single = 2e-7;

const double ratios[] = {1e-6, 1e-4, 1e-2, 0.1, 1.0, 10.0, 1e2, 1e4, 1e6};

TEST(RelaxedShare, HasItsLimits)
{
    EXPECT_EQ(relaxed_share(0), 1.0);
    EXPECT_EQ(withheld_share(0), 0.0);
    EXPECT_NEAR(relaxed_share(1), 1 - std::exp(-1.0), rounding);
    EXPECT_NEAR(relaxed_share(1e6) * 1e6, 1.0, rounding);  // (1 - e^-x)/x -> 1/x
    EXPECT_NEAR(relaxed_share(1e300) * 1e300, 1.0, rounding);
    EXPECT_EQ(withheld_share(1e300), 1.0);
}

TEST(RelaxedShare, IsAccurateAtEverySize)
{
    for (double x = 1e-16; x < 1e3; x *= 1.07) {
        // in extended precision; the series where that cancels, up to x^4: the fifth is below 1e-20 there
        const long double y = x;
        const long double withheld =
            x < 1e-3 ? y / 2 - y * y / 6 + y * y * y / 24 - y * y * y * y / 120 : 1 + std::expm1(-y) / y;
        EXPECT_NEAR(withheld_share(x) / static_cast<double>(withheld), 1.0, 1e-13)
            << x;  // 1 - share cancels two digits
        EXPECT_NEAR(relaxed_share(x) / static_cast<double>(1 - withheld), 1.0, rounding) << x;
    }
}

TEST(AssumedDrag, OfAFreeParticleIsTheImpulseOfTheExactSolution)
{
    const double m = 3e-5, dt = 2e-3;
    const Vector u(1.2, -0.4, 3.0), v(0.1, 0.2, -0.5), a(0, 2.0, -9.81);
    for (const double x : ratios) {
        const double k = x * m / dt;
        // m dv/dt = k (u - v) + m a, dissolved in extended precision; drag's impulse is what gravity's does not explain
        const long double gone = -std::expm1(-static_cast<long double>(x));
        const Vector settled = u + m / k * a;
        const Vector change = static_cast<double>(gone) * (settled - v);
        const Vector drag = m * (change - dt * a);
        const AssumedDrag assumed = assume_drag(m, k, 0.0, a, dt);
        // for small x, `drag` above is a difference of terms that are 1/x times as large
        const double tolerance = rounding * (1 + 1 / x) * drag.norm();
        EXPECT_LT((assumed.impulse(u, v, dt) - drag).norm(), tolerance) << x;
        EXPECT_GT(assumed.kappa, 0);
        EXPECT_LE(assumed.kappa, k);
    }
}

TEST(AssumedDrag, OfAHeldParticleIsTheLawsForce)
{
    const double m = 3e-5, dt = 2e-3;
    const Vector u(1.2, -0.4, 3.0), v(0.1, 0.2, -0.5);
    for (const double x : ratios) {
        const double k = x * m / dt;
        const Vector impulse = assume_drag(m, k, 1.0, Vector(0, 0, -9.81), dt).impulse(u, v, dt);
        EXPECT_LT((impulse - k * dt * (u - v)).norm(), rounding * impulse.norm()) << x;
    }
}

TEST(AssumedDrag, WithoutDragThereIsNone)
{
    const AssumedDrag none = assume_drag(3e-5, 0.0, 0.0, Vector(0, 0, -9.81), 2e-3);
    EXPECT_EQ(none.kappa, 0);
    EXPECT_EQ(none.carried, Vector::Zero());
}

Hold judged(const Vector& by_contacts, const Vector& expected, double weight, long times = Hold::enough)
{
    Hold hold;
    hold.steps = 0;
    for (int n = 0; n < times; ++n)
        hold.judge(by_contacts, expected, weight);
    return hold;
}

TEST(Hold, TellsFreeFromHeld)
{
    const Vector expected(0.1, 0, -0.3);
    const double weight = 0.3;
    const Hold free = judged(Vector::Zero(), expected, weight), held = judged(-expected, expected, weight);
    EXPECT_EQ(free.held, 0.0);
    EXPECT_EQ(free.doubt, 0.0);
    EXPECT_EQ(held.held, 1.0);
    EXPECT_EQ(held.doubt, 0.0);
    EXPECT_EQ(judged(-0.9995 * expected, expected, weight).held, 1.0);  // nearly
}

TEST(Hold, IsBelievedStepByStepAndDroppedInOne)
{
    const Vector expected(0.1, 0, -0.3);
    EXPECT_NEAR(judged(-expected, expected, 0.3, Hold::enough / 2).held, 0.5, rounding);
    Hold hold = judged(-expected, expected, 0.3);
    hold.judge(-0.9 * expected, expected, 0.3);
    EXPECT_EQ(hold.held, 0.0);
}

TEST(Hold, StaysWhereForcesComeToBalanceAndNothingMoves)
{
    const Vector expected(0, 0, -0.3), little(0, 0, 1e-3);
    Hold hold = judged(-expected, expected, 0.3);
    hold.judge(-little, little, 0.3);
    EXPECT_EQ(hold.held, 1.0);
    hold.judge(Vector::Zero(), little, 0.3);  // moved, by a three-hundredth of what its weight would
    EXPECT_EQ(hold.held, 0.0);
}

TEST(Hold, BelievesWhatItSeesFirst)
{
    const Vector expected(0.1, 0, -0.3);
    Hold hold;
    hold.judge(-expected, expected, 0.3);
    EXPECT_EQ(hold.held, 1.0);
}

TEST(Hold, IsInDoubtWhereContactsActAndDoNotHold)
{
    const Vector expected(0.1, 0, -0.3);
    for (const Vector& by_contacts : {Vector(-0.5 * expected), Vector(-2 * expected), expected, Vector(0.3, 0, 0.1),
                                      Vector(0, 0, 0.3)}) {  // the last: held along z, free along x
        const Hold hold = judged(by_contacts, expected, 0.3);
        EXPECT_EQ(hold.held, 0.0) << by_contacts.transpose();
        EXPECT_EQ(hold.doubt, 1.0) << by_contacts.transpose();
    }
}

TEST(Hold, BalanceTellsNothing)
{
    const Vector little(0, 0, 1e-3);
    for (const Vector& by_contacts : {Vector(Vector::Zero()), Vector(-little), little}) {
        EXPECT_EQ(judged(by_contacts, little, 1.0).held, 0.0);
        EXPECT_EQ(judged(by_contacts, little, 1.0).doubt, 1.0);
    }
}

TEST(Hold, WithoutGravityAnyAnswerTells)
{
    const Vector little(0, 0, 1e-9);
    EXPECT_EQ(judged(Vector::Zero(), little, 0.0).doubt, 0.0);
    EXPECT_EQ(judged(-little, little, 0.0).held, 1.0);
}

TEST(Hold, WhereNothingIsKnownIsTheSafeGuess)
{
    Hold hold;
    hold.judge(Vector::Zero(), Vector::Zero(), 0.0);
    EXPECT_EQ(hold.held, 1.0);
}

TEST(Stiffening, MakesTheLaggedCorrectionConvergeForFreeAndHeld)
{
    // gas without inertia, at rest in the end: rate_assumed (u - u_last) + true impulse of the last step
    const double m = 3e-5, dt = 2e-3;
    for (const double x : ratios) {
        const double k = x * m / dt, added = stiffening(k, m, 1.0, dt);
        for (const double held : {0.0, 1.0}) {
            const double free_rate = assume_drag(m, k, 0, Vector::Zero(), dt).kappa;
            const double true_rate = assume_drag(m, k, held, Vector::Zero(), dt).kappa;
            double u = 1, last = 1, before = 1;
            const double factor = 1 / std::sqrt(1 + 2 / x);
            for (int n = 0; n < 20; ++n) {
                const double pending = true_rate * u - (free_rate * u + added * (u - last));
                before = last;
                last = u;
                u = (added * last - pending) / (free_rate + added);
            }
            EXPECT_LT(std::hypot(u, last, before), 4 * std::pow(factor, 17)) << x << ", held " << held;
        }
    }
}

TEST(FreeChange, IsTheExactSolutions)
{
    const double m = 3e-5, dt = 2e-3;
    const Vector u(1.2, -0.4, 3.0), v(0.1, 0.2, -0.5), a(0, 2.0, -9.81);
    for (const double x : ratios) {
        const double k = x * m / dt;
        const Vector exact = -std::expm1(-x) * (u + m / k * a - v);
        EXPECT_LT((free_change(m, k, u - v, a, response_time(m, k, dt)) - exact).norm(),
                  rounding * exact.norm() * (1 + 1e-9 / x))
            << x;
    }
}

/// One substep without a drift, as an integrator does it: the velocity changes by f dt/m.
Vector after(const FluidForce& fluid, double mass, double dt, Vector v, const Vector& others, Vector* booked = nullptr)
{
    Vector force = others, fluid_force = Vector::Zero();
    fluid.apply(force.data(), v.data(), fluid_force.data());
    if (booked) *booked += fluid_force;
    return v + dt / mass * force;
}

TEST(FluidForce, DecaysExactlyAtAnyRatioOfStepToRelaxationTime)
{
    const double m = 3e-5, dt = 2e-5;
    const Vector u(1.2, -0.4, 3.0), v(0.1, 0.2, -0.5);
    for (const double x : ratios) {
        const FluidForce fluid(m, x * m / dt, u, Vector::Zero(), dt);
        const Vector change = after(fluid, m, dt, v, Vector::Zero()) - v;
        const Vector exact = -std::expm1(-x) * (u - v);
        EXPECT_LT((change - exact).norm(), single * (u.norm() + v.norm()) * -std::expm1(-x)) << x;
    }
}

TEST(FluidForce, SettlesAtTheTerminalVelocityAtAnyRatio)
{
    const double m = 3e-5, dt = 2e-5;
    const Vector u(0.3, 0, 1.0), g(0, 0, -9.81), pressure_force = -0.1 * m * g;
    for (const double x : ratios) {
        const double k = x * m / dt;
        const Vector settling = (m * g + pressure_force) / k;  // relative to the gas
        const FluidForce fluid(m, k, u, pressure_force, dt);
        // at the terminal velocity nothing changes: the change is that of a slip off by single precision
        const Vector terminal = u + settling;
        const Vector change = after(fluid, m, dt, terminal, m * g) - terminal;
        EXPECT_LT(change.norm(), -std::expm1(-x) * single * (settling.norm() + terminal.norm() + u.norm())) << x;
        if (x < 1) continue;
        Vector v = Vector::Zero();
        for (int step = 0; step < 60; ++step)
            v = after(fluid, m, dt, v, m * g);
        EXPECT_LT((v - terminal).norm(), single * (settling.norm() + terminal.norm() + u.norm())) << x;
    }
}

TEST(FluidForce, TheSettlingSlipItselfIsRight)
{
    // in gas at rest the slip is all there is, however small it is against g dt
    const double m = 3e-5, dt = 2e-5;
    const Vector g(0, 0, -9.81);
    for (const double x : ratios) {
        if (x < 1) continue;
        const double k = x * m / dt;
        const FluidForce fluid(m, k, Vector::Zero(), Vector::Zero(), dt);
        Vector v = Vector::Zero();
        for (int step = 0; step < 60; ++step)
            v = after(fluid, m, dt, v, m * g);
        EXPECT_NEAR(v.z() * k / (m * g.z()), 1.0, single) << x;
    }
}

TEST(FluidForce, SubstepsComposeToTheExactSolution)
{
    const double m = 3e-5, dt = 2e-3;
    const int substeps = 40;
    const Vector u(1.2, -0.4, 3.0), v(0.1, 0.2, -0.5), a(0, 2.0, -9.81);
    for (const double x : {1e-3, 1e-1, 1.0, 10.0, 1e3}) {
        const double k = x * m / dt;
        const FluidForce fluid(m, k, u, Vector::Zero(), dt / substeps);
        Vector now = v, booked = Vector::Zero();
        for (int step = 0; step < substeps; ++step)
            now = after(fluid, m, dt / substeps, now, m * a, &booked);
        const Vector exact = v - std::expm1(-x) * (u + m / k * a - v);
        EXPECT_LT((now - exact).norm(), single * (u.norm() + v.norm() + m / k * a.norm())) << x;
        // what was booked is what the gas solve assumed of a free particle, and to the last bits what the particle took
        const Vector impulse = dt / substeps * booked;
        EXPECT_LT((impulse - assume_drag(m, k, 0, a, dt).impulse(u, v, dt)).norm(), single * m * (4 + a.norm() * dt))
            << x;
        EXPECT_LT((impulse + m * dt * a - m * (now - v)).norm(), 100 * rounding * m * 4) << x;
    }
}

TEST(FluidForce, ByDefaultDoesNothing)
{
    const Vector others(1, -2, 3);
    Vector booked = Vector::Zero();
    EXPECT_EQ(after(FluidForce{}, 2.0, 0.5, Vector(7, 7, 7), others, &booked), Vector(7, 7, 7) + 0.25 * others);
    EXPECT_EQ(booked, Vector::Zero());
}

}  // namespace
