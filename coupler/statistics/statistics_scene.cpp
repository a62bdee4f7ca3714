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

/// Windows that would never see a sphere. The vessel is the cells of the mesh, by the boxes around them, or, without
/// one, a box.
void refuse_windows_beside_the_vessel(const Communicator& comm, const SampleWindows& windows, const Box& vessel,
                                      const MeshView* mesh)
{
    const std::size_t count = windows.windows();
    Scalars held(count + 1, 0.0);  // whether the vessel has a part in each window, and in the slice of any
    Box slice;
    slice.row(1) << windows.front, windows.front + windows.front_depth;
    slice.row(2) << windows.low(), windows.low() + windows.height;
    const auto look_at = [&](const Vector& centre, const Vector& extent) {
        constexpr double tie = 1 - 1e-6;  // what only touches has no part
        Box cell;
        cell << centre - tie / 2 * extent, centre + tie / 2 * extent;
        for (std::size_t n = 0; n < count; ++n) {
            slice.row(0) << windows.edge(n), windows.edge(n + 1);
            Box window = slice;
            window.row(1) << -1e300, 1e300;
            if (overlap(window, cell)) held[n] = 1;
            if (overlap(slice, cell)) held[count] = 1;
        }
    };
    if (mesh)
        for (std::size_t c = 0; c < mesh->size(); ++c)
            look_at(mesh->centre[c], mesh->extent[c]);
    else
        look_at(vessel.rowwise().mean(), vessel.col(1) - vessel.col(0));
    comm.max(held);
    const auto from_to = [&](int axis) { return text(slice(axis, 0)) + " to " + text(slice(axis, 1)) + " m"; };
    for (std::size_t n = 0; n < count; ++n) {
        slice.row(0) << windows.edge(n), windows.edge(n + 1);
        if (held[n] == 0)
            throw UserError("window " + std::to_string(n + 1) + " of " + std::to_string(count) + ", x = " + from_to(0) +
                                " at z = " + from_to(2) + ", has no part in the vessel: nothing would ever be in it",
                            file, "correct left, right and count, or centre and height [m], or set `windows none;`");
    }
    if (held[count] == 0)
        throw UserError("the slice at the front wall, y = " + from_to(1) + " at z = " + from_to(2) +
                            ", has no part in the vessel: nothing would ever be in it",
                        file, "correct front and frontDepth [m], or set `windows none;`");
}

void refuse_other_up(const StatisticsSettings& settings, const Vector& gravity, bool with_gas)
{
    if (gravity.norm() == 0 || -gravity.z() >= std::max(std::abs(gravity.x()), std::abs(gravity.y()))) return;
    std::vector<std::string> blocks;
    if (settings.windows.wanted) blocks.emplace_back("windows");
    if (settings.voidage.wanted && with_gas) blocks.emplace_back("voidage");  // its layers
    if (settings.surface.wanted) blocks.emplace_back("surface");
    if (settings.bubbles.wanted && with_gas) blocks.emplace_back("bubbles");
    if (blocks.empty()) return;
    std::string remedy;
    for (const std::string& block : blocks)
        remedy += (remedy.empty() ? "" : " ") + block + " none;";
    throw UserError("gravity is " + text(gravity) + " m/s2, and these take z as up: " + listed(blocks),
                    "system/couplingDict, statistics",
                    "turn the case so that gravity points along -z, or set `" + remedy +
                        "`: overlaps, energies and mean fields need no direction");
}

}  // namespace

Bed bed_of(const Communicator& comm, Solids& solids, const Box* gas_bounds)
{
    const ParticleView particles = solids.particles();
    Bed bed;
    bed.gravity = solids.gravity();
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
    refuse_other_up(settings, bed.gravity, mesh != nullptr);
    if (settings.windows.wanted) {
        scene.windows = windows_of(settings.windows, bed);
        refuse_windows_beside_the_vessel(comm, *scene.windows, bed.vessel, mesh);
    }
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
