// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a sphere sees of itself: the shares of Stokes, Oseen and Brinkman flow against their integrals, the fading with
// solid fraction, and that the corrected rate gives back the drag of the undisturbed slip.
#include "forces/self_disturbance/self_disturbance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "forces/drag/drag.hpp"
#include "support/measured.hpp"

namespace {

using namespace interphase;

/// (1/(2 pi)^3) int exp(-k^2) (1 - c^2) (k^2 + x^2)/((k^2 + x^2)^2 + (Re k c)^2) d^3k: velocity per force along the
/// stream, averaged over the Gaussian, in units of 1/(mu sigma). Midpoints of k and c; `logarithmic` in both, for fast
/// streams, whose integrand is narrow in c.
double velocity_at_the_kernel(double reynolds, double x)
{
    constexpr int points = 800;
    constexpr double k_end = 6, c_least = 1e-7;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
        const double k = (i + 0.5) * k_end / points;
        for (int j = 0; j < points; ++j) {
            const double step = -std::log(c_least) / points;
            const double c = c_least * std::exp((j + 0.5) * step);
            const double damping = k * k + x * x, turning = reynolds * k * c;
            sum += k * k * std::exp(-k * k) * (1 - c * c) * damping / (damping * damping + turning * turning) * c *
                   step * (k_end / points);
        }
    }
    return sum / (2 * M_PI * M_PI);
}

const double in_stokes_flow = 1 / (6 * std::pow(M_PI, 1.5));

TEST(SelfDisturbance, IsThatOfTheRegularisedStokesletInSlowFlow)
{
    EXPECT_NEAR(velocity_at_the_kernel(0, 0) / in_stokes_flow, 1, 1e-4);  // midpoints
    EXPECT_EQ(share_in_stream(0), 1);
    EXPECT_EQ(share_in_packing(0), 1);
}

TEST(SelfDisturbance, FollowsOseensAndBrinkmansEquations)
{
    for (const double reynolds : {0.01, 0.1, 0.5, 1.0, 3.0, 10.0, 100.0, 1000.0})
        EXPECT_NEAR(share_in_stream(reynolds) * in_stokes_flow / velocity_at_the_kernel(reynolds, 0), 1, 2e-3)
            << reynolds;  // 1e-3 of the fit, the rest of the midpoints
    for (const double x : {0.01, 0.1, 0.5, 1.0, 3.0, 10.0})
        EXPECT_NEAR(share_in_packing(x) * in_stokes_flow / velocity_at_the_kernel(0, x), 1, 5e-3) << x;
    for (const double reynolds : {0.3, 1.0, 10.0, 100.0})
        for (const double x : {0.1, 0.3, 1.0, 3.0}) {
            const double ratio =
                share_in_stream_through_packing(reynolds, x) * in_stokes_flow / velocity_at_the_kernel(reynolds, x);
            EXPECT_GT(ratio, 0.84) << reynolds << ", " << x;
            EXPECT_LT(ratio, 1.005) << reynolds << ", " << x;
        }
}

TEST(SelfDisturbance, FadesWithSolidFraction)
{
    EXPECT_EQ(isolation(0), 1);
    EXPECT_NEAR(isolation(0.01), 1 - 8 * 0.01, 5e-3);  // 1 - 8 phi, the volume that others are kept out of
    EXPECT_EQ(isolation(0.4), 0);
    EXPECT_EQ(isolation(0.6), 0);
    for (double phi = 0; phi < 0.4; phi += 0.01)
        EXPECT_LT(isolation(phi + 0.01), isolation(phi)) << phi;
}

/// A sphere of 1 mm in a liquid that streams up past it, where it holds still; its kernel a Gaussian of that many
/// diameters, on a mesh far finer.
ParticleInGas alone(double reynolds, double deviation = 0.85)
{
    ParticleInGas at;
    at.diameter = 1e-3;
    at.volume = M_PI / 6 * std::pow(at.diameter, 3);
    at.mass = 2500 * at.volume;
    at.density = 1000;
    at.viscosity = 1e-2;
    at.gas_velocity.z() = reynolds * at.viscosity / (at.density * at.diameter);
    at.cell_extent.setConstant(0.01 * at.diameter);
    at.cell_volume = at.cell_extent.prod();
    const double sigma = deviation * at.diameter;
    at.kernel_volume.here = at.kernel_volume.on_its_way = kernel_volume(sigma * sigma);
    at.voidage = 1 - at.volume / at.kernel_volume.here;
    at.duration = 1e-9;
    return at;
}

double rate_of(Drag& drag, const ParticleInGas& at)
{
    Response response;
    drag.act(at, response);
    return response.rate;
}

TEST(SelfDisturbance, GivesBackTheDragOfTheUndisturbedSlip)
{
    double worst = 0;
    for (const char* name : {"SchillerNaumann", "WenYu", "BVK", "DiFelice"}) {
        Drag drag(*find_drag_law(name));
        for (const double reynolds : {1e-3, 0.1, 1.0, 10.0, 100.0}) {
            ParticleInGas at = alone(reynolds);
            const double slip = at.gas_velocity.z(), sigma = kernel_deviation(at.kernel_volume.here);
            const double force = drag.rate_at(at, 1.0, slip) * slip;
            const double own = at.volume / at.kernel_volume.here;
            // what it drags along, and the way that the gas makes for it
            const double seen = slip * (1 + own / 3) - force * (1 - own / 3) * in_stokes_flow / (at.viscosity * sigma) *
                                                           share_in_stream(reynolds * sigma / at.diameter);
            at.gas_velocity.z() = seen;
            // with the push of the pressure that the force itself makes, a third of the own solid fraction of it
            worst = std::max(worst, std::abs(rate_of(drag, at) * seen / (force * (1 - own / 3)) - 1));
        }
        EXPECT_EQ(drag.counts()[1].number, 0) << name;
    }
    test::expect_below(
        {"drag on a sphere that sees its own wake, corrected, off that of the undisturbed slip, Re 1e-3 to 100", "%",
         "regularised Stokes and Oseen flow"},
        100 * worst, 0.1);
}

TEST(SelfDisturbance, IsNoneWithoutAKernelAndInAPacking)
{
    Drag drag(*find_drag_law("BVK"));
    ParticleInGas at = alone(10);
    at.voidage = 0.45;
    const double rate = drag.rate_at(at, at.voidage, at.gas_velocity.z());
    EXPECT_DOUBLE_EQ(rate_of(drag, at), rate);
    at.voidage = 0.8;
    at.kernel_volume = {};
    EXPECT_DOUBLE_EQ(rate_of(drag, at), drag.rate_at(at, at.voidage, at.gas_velocity.z()));
}

/// A packing that grows loose gains the correction without a jump. What others take of it goes with the root of their
/// solid fraction: 0.3 sqrt(18 x 0.72 x 1e-4) = 1 % in the first step of 1e-4.
TEST(SelfDisturbance, ComesAndGoesWithoutAJump)
{
    Drag drag(*find_drag_law("WenYu"));
    ParticleInGas at = alone(1);
    double last = 0;
    for (double phi = 0.02; phi < 0.5; phi += 1e-4) {
        at.voidage = 1 - phi;
        const double rate = rate_of(drag, at);
        if (last > 0) {
            EXPECT_NEAR(rate / last, 1, 0.015) << phi;
        }
        last = rate;
    }
}

TEST(SelfDisturbance, IsLimitedAndCountedWhereAParticleTakesAllOfTheSlipAlong)
{
    Drag drag(*find_drag_law("SchillerNaumann"));
    // Wholly in one cell of 1.24 diameters (`type cellCentre`): a kernel of 0.35 diameters, of which a mesh makes twice
    // the velocity, takes 1.6 of the slip along.
    ParticleInGas at = alone(1e-3, 0.35);
    at.cell_volume = at.kernel_volume.here;
    at.cell_extent.setConstant(std::cbrt(at.cell_volume));
    const double slip = at.gas_velocity.z();
    EXPECT_LT(rate_of(drag, at), drag.rate_at(at, 1.0, slip) / (1 - SelfDisturbance::most_taken));
    EXPECT_EQ(drag.counts()[1].number, 1);
    EXPECT_STREQ(drag.counts()[1].kind->key, "self_disturbance_limited");
}

TEST(SelfDisturbance, OfAParcelIsThatOfOneOfItsParticles)
{
    Drag drag(*find_drag_law("SchillerNaumann"));
    constexpr double weight = 8;
    const ParticleInGas one = alone(1.0, 2);
    ParticleInGas parcel = one;  // what each of eight spheres in its place sees
    parcel.volume *= weight;
    parcel.mass *= weight;
    parcel.voidage = 1 - parcel.volume / parcel.kernel_volume.here;
    ParticleInGas single = one;
    single.voidage = parcel.voidage;
    EXPECT_NEAR(rate_of(drag, parcel) / (weight * rate_of(drag, single)), 1, 1e-9);
}

}  // namespace
