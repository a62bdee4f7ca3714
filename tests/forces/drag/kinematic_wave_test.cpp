// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/kinematic_wave.hpp"

#include <gtest/gtest.h>

#include "forces/drag/drag_law.hpp"

namespace {

using namespace interphase;

TEST(KinematicWave, IsThatOfRichardsonAndZaki)
{
    // w = w_t eps^n with Stokes' drag: k s ~ eps and s = w/eps give k ~ eps^(2 - n)
    for (const double n : {2.4, 4.65})
        for (const double eps : {0.4, 0.7, 0.95}) {
            const auto rate = [n](double voidage, double) { return std::pow(voidage, 2 - n); };
            const double s = 0.3, w = eps * s;
            EXPECT_NEAR(kinematic_wave_speed(rate, eps, s) / (n * (1 - eps) * w / eps), 1,
                        1e-5);  // differences of 1e-3
        }
}

TEST(KinematicWave, IsTheSlopeOfTheHinderedVelocityOfEachLaw)
{
    constexpr double d = 1e-3, density = 1000, viscosity = 1e-3, pull = 9810;  // of buoyancy [N/m3]
    for (const DragLaw& law : drag_laws()) {
        const auto rate = [&](double eps, double s) {
            return drag_rate_per_volume(law, eps, s, d, density, viscosity);
        };
        const auto hindered = [&](double phi) {  // by bisection
            const double eps = 1 - phi;
            double low = 0, high = 10;
            for (int n = 0; n < 200; ++n) {
                const double middle = 0.5 * (low + high);
                (rate(eps, middle) * middle < pull * eps ? low : high) = middle;
            }
            return eps * low;
        };
        constexpr double phi = 0.37, step = 1e-4;  // away from where Gidaspow's and Koch-Hill's parts meet
        const double slope = (hindered(phi + step) - hindered(phi - step)) / (2 * step);
        EXPECT_NEAR(kinematic_wave_speed(rate, 1 - phi, hindered(phi) / (1 - phi)) / (phi * std::abs(slope)), 1, 1e-3)
            << law.name;
    }
}

}  // namespace
