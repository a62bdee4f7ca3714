// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/statistics_scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/user_error.hpp"

namespace interphase {

namespace {

constexpr double windows_across = 5;
constexpr double window_in_diameters = 4;  // a window or a column below this many tells single spheres
constexpr double column_in_diameters = 4;
constexpr const char* file = "system/couplingDict, statistics.windows";

void demand_part(const Box& vessel, int axis, double low, double high, const char* keys)
{
    if (high > vessel(axis, 0) && low < vessel(axis, 1)) return;
    throw UserError(std::string("the windows are outside of the vessel: ") + "xyz"[axis] + " = " + text(low) + " to " +
                        text(high) + " m, and it goes from " + text(vessel(axis, 0)) + " to " + text(vessel(axis, 1)) +
                        " m",
                    file, std::string("correct ") + keys + " [m], or leave them away");
}

SampleWindows windows_of(const StatisticsSettings::Windows& given, const Bed& bed)
{
    const Box& vessel = bed.vessel;
    const bool known = bed.largest > 0;
    for (const auto& [key, value, there] : {std::tuple{"centre", &given.centre, bed.count > 0},
                                            {"height", &given.height, known},
                                            {"frontDepth", &given.front_depth, known}})
        if (!*value && !there)
            throw UserError(
                std::string("windows/") + key + " is not given, and there is no particle at the start to choose it by",
                file, std::string("give ") + key + " [m], or `windows none;`");
    const double least = window_in_diameters * bed.largest;
    SampleWindows windows{};
    windows.left = given.left.value_or(vessel(0, 0));
    windows.right = given.right.value_or(vessel(0, 1));
    if (windows.right <= windows.left)
        throw UserError("the windows are empty: x = " + text(windows.left) + " to " + text(windows.right) + " m", file,
                        "correct left or right [m]");
    demand_part(vessel, 0, windows.left, windows.right, "left and right");
    const double fitting = least > 0 ? std::floor((windows.right - windows.left) / least) : windows_across;
    windows.count = given.count > 0 ? given.count : std::clamp(fitting, 1.0, windows_across);
    windows.height = given.height.value_or(
        std::min(std::max((windows.right - windows.left) / windows.count, least), vessel(2, 1) - vessel(2, 0)));
    windows.centre = given.centre.value_or(bed.middle);
    demand_part(vessel, 2, windows.low(), windows.low() + windows.height, "centre and height");
    windows.front = given.front.value_or(vessel(1, 0));
    windows.front_depth = given.front_depth.value_or(std::min(bed.largest, vessel(1, 1) - vessel(1, 0)));
    demand_part(vessel, 1, windows.front, windows.front + windows.front_depth, "front and frontDepth");
    return windows;
}

}  // namespace

Bed bed_of(const Communicator& comm, Solids& solids, const Box* gas_bounds)
{
    const ParticleView particles = solids.particles();
    Bed bed;
    double largest = 0, volume = 0, moment = 0;
    Box around = empty_box();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const double d = 2 * particles.radius[at];
        const Vector x = particles.position.col(at);
        largest = std::max(largest, d);
        volume += d * d * d;
        moment += d * d * d * x.z();
        extend(around, x - Vector::Constant(d / 2));
        extend(around, x + Vector::Constant(d / 2));
    }
    Scalars sums{static_cast<double>(particles.size()), volume, moment};
    comm.sum(sums);
    bed.largest = comm.max(largest);
    bed.vessel.col(0) = comm.min(Vector(around.col(0)));
    bed.vessel.col(1) = comm.max(Vector(around.col(1)));
    if (gas_bounds)
        bed.vessel = *gas_bounds;
    else if (const Box domain = solids.periods().box; domain(0, 1) > domain(0, 0))
        bed.vessel = domain;
    bed.count = sums[0];
    if (bed.count > 0) {
        bed.mean = std::cbrt(sums[1] / sums[0]);
        bed.middle = sums[2] / sums[1];
    } else
        for (const double radius : solids.radii_to_come())
            bed.largest = bed.mean = std::max(bed.largest, 2 * radius);
    return bed;
}

double mean_extent(const Communicator& comm, const MeshView& mesh, int axis)
{
    Scalars sums{0, 0};
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        sums[0] += mesh.extent[c][axis] * mesh.volume[c];
        sums[1] += mesh.volume[c];
    }
    comm.sum(sums);
    return sums[0] / sums[1];
}

StatisticsScene scene_of(const Communicator& comm, const StatisticsSettings& settings, const Bed& bed,
                         const MeshView* mesh)
{
    StatisticsScene scene;
    const bool empty = !(bed.vessel(0, 1) > bed.vessel(0, 0));
    if (empty)
        throw UserError(
            "statistics without a gas, and without a particle at the start: there is no vessel to take them in",
            "system/couplingDict, statistics", "set `interval 0;`, or start with particles");
    scene.vessel = bed.vessel;
    if (settings.windows.wanted) scene.windows = windows_of(settings.windows, bed);
    const double cell = mesh ? mean_extent(comm, *mesh, 0) : 0;
    const double width = std::max({cell, column_in_diameters * bed.mean, 1e-6 * (bed.vessel(0, 1) - bed.vessel(0, 0))});
    scene.columns = settings.surface.columns > 0
                        ? settings.surface.columns
                        : std::max(1.0, std::round((bed.vessel(0, 1) - bed.vessel(0, 0)) / width));
    return scene;
}

void StatisticsScene::keep(Archive& archive)
{
    archive.keep("windows", windows);
    archive.keep("vessel", vessel.data(), 6);
    archive.keep("columns", columns);
}

}  // namespace interphase
