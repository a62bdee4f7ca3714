// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drag laws that look at more than the flow: spheres of several sizes, and cells that do not resolve clusters.
#include <gtest/gtest.h>

#include <cmath>

#include "forces/drag/beetstra.hpp"
#include "forces/drag/beetstra_polydisperse.hpp"
#include "forces/drag/cluster_length.hpp"
#include "forces/drag/radl_sundaresan.hpp"

namespace {

using namespace interphase;

DragState state(double voidage, double reynolds)
{
    DragState made;
    made.voidage = voidage;
    made.reynolds = reynolds;
    return made;
}

/// With the pressure gradient's share put back, the whole force of van der Hoef et al.: with F the drag of spheres of
/// one size, in units of 3 pi mu d U (U superficial) it is F_total = (eps y + (1 - eps) y^2 + 0.064 eps y^3) F/eps,
/// and -V grad p is (1 - eps) y^2 F/eps of it, since -grad p is F/eps by the number of mean spheres.
TEST(PolydisperseBeetstra, IsTheWholeForceOfItsSourceLessThePressureGradient)
{
    for (const double eps : {0.4, 0.6, 0.9})
        for (const double y : {0.4, 1.0, 1.7}) {
            DragState of_mixture = state(eps, 0);
            of_mixture.diameter_ratio = y;
            const double whole =
                (eps * y + (1 - eps) * y * y + 0.064 * eps * y * y * y) * beetstra(state(eps, 0)) / eps;
            const double pressure = (1 - eps) * y * y * beetstra(state(eps, 0)) / eps;
            EXPECT_NEAR(beetstra_polydisperse(of_mixture) / (whole - pressure), 1, 1e-13) << eps << " " << y;
        }
}

TEST(PolydisperseBeetstra, TakesTheReynoldsNumberOfTheMeanSphere)
{
    DragState of_mixture = state(0.5, 60);
    of_mixture.diameter_ratio = 2;
    EXPECT_NEAR(beetstra_polydisperse(of_mixture) / (2.512 * beetstra(state(0.5, 30))), 1, 1e-13);
    of_mixture.diameter_ratio = 1;
    EXPECT_NEAR(beetstra_polydisperse(of_mixture) / beetstra(state(0.5, 60)), 1.064, 1e-13);
}

/// Igci, Andrews, Sundaresan, Pannala, O'Brien, AIChE J. 54 (2008) 1431, table 1: 75 um, 1500 kg/m3 in a gas of
/// 1.3 kg/m3 and 1.8e-5 Pa s fall at 0.2184 m/s, by the drag of Wen and Yu, which for one sphere is this one.
TEST(ClusterLength, HasThePublishedTerminalVelocity)
{
    EXPECT_NEAR(terminal_velocity(75e-6, 1500, 1.3, 1.8e-5, 9.81) / 0.2184, 1, 0.01);
}

TEST(ClusterLength, TerminalVelocityBalancesWeightAndDragFromStokesToNewton)
{
    for (const double d : {1e-6, 1e-4, 1e-3, 1e-2}) {
        const double v = terminal_velocity(d, 2500, 1.2, 1.8e-5, 9.81);
        const double reynolds = 1.2 * v * d / 1.8e-5;
        const double factor = reynolds < 1000 ? 1 + 0.15 * std::pow(reynolds, 0.687) : 0.44 / 24 * reynolds;
        const double drag = 3 * M_PI * 1.8e-5 * d * v * factor, weight = M_PI / 6 * d * d * d * (2500 - 1.2) * 9.81;
        EXPECT_NEAR(drag / weight, 1, 1e-6) << d;
    }
}

TEST(ClusterLength, IsInfiniteWhereNothingFalls)
{
    EXPECT_TRUE(std::isinf(cluster_length(75e-6, 1500, 1.3, 1.8e-5, 0)));
    EXPECT_TRUE(std::isinf(cluster_length(75e-6, 1000, 1000, 1e-3, 9.81)));
}

TEST(ClusterLength, OfSpheresOneAfterTheOtherIsThatOfEach)
{
    ClusterLength of;
    for (const double d : {75e-6, 75e-6, 150e-6, 75e-6})
        for (const double density : {1500.0, 2500.0})
            EXPECT_EQ(of(d, density, 1.3, 1.8e-5, 9.81), cluster_length(d, density, 1.3, 1.8e-5, 9.81));
}

TEST(RadlSundaresan, IsBeetstraInCellsThatResolveClusters)
{
    for (const double phi : {0.01, 0.2, 0.5}) {
        DragState in_fine_cell = state(1 - phi, 5);
        EXPECT_EQ(radl_sundaresan(in_fine_cell), beetstra(in_fine_cell));
        in_fine_cell.filter_size = 1e-6;
        EXPECT_NEAR(radl_sundaresan(in_fine_cell) / beetstra(in_fine_cell), 1, 1e-6);
    }
}

TEST(RadlSundaresan, TakesMostInCoarseCellsOfModerateFraction)
{
    // h of the source: 0.887 at phi = 0.18, in cells much larger than clusters
    EXPECT_NEAR(radl_sundaresan_correction(0.18, 1e9), 1 - 0.887, 1e-6);
    EXPECT_NEAR(radl_sundaresan_correction(0.34, 1e9), 1 - 0.943, 1e-6);
    // a = 1.79 from phi = 0.4 on: h/(1 + a) in cells as large as the cluster length
    EXPECT_NEAR(radl_sundaresan_correction(0.48, 1), 1 - 0.850 / 2.79, 1e-6);
    EXPECT_NEAR(radl_sundaresan_correction(0, 1), 1, 1e-12);
}

TEST(RadlSundaresan, IsBetweenNoneAndAllAndContinuous)
{
    for (const double filter : {0.1, 1.0, 10.0, 1e6}) {
        double before = radl_sundaresan_correction(0, filter);
        for (double phi = 0; phi <= 0.64; phi += 1e-4) {
            const double c = radl_sundaresan_correction(phi, filter);
            EXPECT_GT(c, 0) << phi;
            EXPECT_LE(c, 1) << phi;
            // the source's cubics meet to three digits, but for a at phi = 0.016 (21.51 to 2.47), where h is 0.13
            EXPECT_NEAR(c, before, std::abs(phi - 0.016) < 2e-4 ? 0.12 : 0.012) << phi << " " << filter;
            before = c;
        }
    }
}

}  // namespace
