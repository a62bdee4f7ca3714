// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/stopwatch.hpp"
#include "statistics/bins.hpp"
#include "statistics/overlap_counts.hpp"
#include "statistics/solids_energy.hpp"
#include "statistics/window_moments.hpp"

namespace interphase {

namespace {

constexpr const char* group = "/statistics";

}  // namespace

Statistics::Statistics(const Communicator& comm, const StatisticsSettings& settings, Solids& solids, Gas* gas,
                       const Box* gas_bounds)
    : comm_(comm), settings_(settings), solids_(solids), gas_(gas), mesh_(gas ? &gas->mesh() : nullptr)
{
    scene_ = scene_of(comm_, settings_, bed_of(comm_, solids_, gas_bounds), mesh_);
    if (mesh_) {
        cells_ = comm_.sum(static_cast<double>(mesh_->size()));
        voidage_edges_ = even_edges(settings_.voidage.lowest, settings_.voidage.highest,
                                    static_cast<std::size_t>(settings_.voidage.bins));
        if (settings_.voidage.wanted) layers_.emplace(comm_, *mesh_, scene_.vessel);
        if (settings_.bubbles.wanted) bubbles_.emplace(comm_, *mesh_);
        if (settings_.fields.wanted) mean_fields_.emplace(*mesh_);
    }
    ready();
}

void Statistics::ready()
{
    if (settings_.surface.wanted)
        surface_.emplace(scene_.vessel, static_cast<std::size_t>(scene_.columns), settings_.surface.share);
}

void Statistics::describe(Results& results) const
{
    results.describe(group, "interval", settings_.interval);
    if (scene_.windows) {
        const SampleWindows& w = *scene_.windows;
        for (const auto& [name, value] : {std::pair{"windows_count", w.count},
                                          {"windows_left", w.left},
                                          {"windows_right", w.right},
                                          {"windows_centre", w.centre},
                                          {"windows_height", w.height},
                                          {"windows_front", w.front},
                                          {"windows_front_depth", w.front_depth}})
            results.describe(group, name, value);
    }
    if (settings_.overlaps.wanted) {
        results.describe(group, "overlap_edges", overlap_edges());
        results.describe(group, "overlap_shares", settings_.overlaps.shares);
    }
    if (mesh_ && settings_.voidage.wanted) {
        results.describe(group, "voidage_edges", voidage_edges_);
        results.describe(group, "voidage_limits", settings_.voidage.limits);
        results.describe(group, "voidage_cells", cells_);
        results.describe(group, "layer_edges", layers_->edges());
    }
    if (surface_) {
        results.describe(group, "surface_edges", surface_->edges());
        results.describe(group, "surface_share", settings_.surface.share);
    }
    if (bubbles_) results.describe(group, "bubble_voidage", settings_.bubbles.voidage);
}

void Statistics::describe_mean_fields(Results& results) const
{
    if (mean_fields_) mean_fields_->describe(group, results);
}

void Statistics::sample(double time, const CouplingStep* coupling, Results& results)
{
    const double start = wall_clock();
    const Scalars& voidage = coupling ? coupling->voidage() : Scalars{};
    Results::Row row;
    row.add("time", "s", time);
    row.add("spheres", "1", static_cast<double>(comm_.sum(static_cast<long>(solids_.particles().size()))));
    if (scene_.windows) sample_windows(row);
    if (settings_.overlaps.wanted) sample_overlaps(row);
    if (layers_) sample_voidage(row, voidage);
    if (surface_) sample_surface(row, voidage);
    sample_energy(row);
    results.add_row(group, row);
    if (mean_fields_) sample_fields(time, *coupling);
    seconds_ += wall_clock() - start;
}

void Statistics::sample_windows(Results::Row& row)
{
    for (const bool front : {true, false}) {
        const WindowMoments found = window_moments(comm_, solids_.particles(), *scene_.windows, front);
        const std::string depth = front ? "front_slice" : "full_depth";
        row.add(depth + "_number", "1", found.number);
        row.add(depth + "_real", "1", found.real);
        row.add(depth + "_horizontal_sum", "m/s", found.sum[0]);
        row.add(depth + "_vertical_sum", "m/s", found.sum[1]);
        row.add(depth + "_horizontal_temperature", "m2/s2", found.temperature[0]);
        row.add(depth + "_vertical_temperature", "m2/s2", found.temperature[1]);
    }
}

void Statistics::sample_overlaps(Results::Row& row)
{
    const OverlapCounts found =
        overlap_counts(comm_, solids_.particles(), solids_.periods(), settings_.overlaps.shares);
    row.add("overlap_pairs", "1", found.pairs);
    row.add("overlap_largest", "1", found.largest);
    row.add("overlap_counts", "1", found.counts);
    row.add("overlap_below", "1", found.below);
}

void Statistics::sample_voidage(Results::Row& row, const Scalars& voidage) const
{
    row.add("voidage_counts", "1", voidage_counts(comm_, voidage, voidage_edges_));
    row.add("voidage_limit_counts", "1", voidage_counts(comm_, voidage, settings_.voidage.limits));
    row.add("layer_voidage", "1", layers_->means(comm_, voidage));
}

void Statistics::sample_surface(Results::Row& row, const Scalars& voidage)
{
    const Scalars heights = surface_->heights(comm_, solids_.particles());
    row.add("surface_height", "m", heights);
    row.add("mean_surface_height", "m", mean_height(heights));
    if (!bubbles_) return;
    const BubbleSizes found = bubbles_->sizes([&](std::size_t cell) {
        const Vector& centre = mesh_->centre[cell];
        return voidage[cell] > settings_.bubbles.voidage && centre.z() < heights[surface_->column_at(centre.x())];
    });
    row.add("bubble_number", "1", found.number);
    row.add("bubble_volume", "m3", found.volume);
    row.add("largest_bubble_volume", "m3", found.largest);
    row.add("largest_bubble_height", "m", found.height);
}

void Statistics::sample_energy(Results::Row& row)
{
    const Vector g = solids_.gravity();
    double floor = 0;
    if (g.norm() > 0) {
        const Vector up = -g.normalized();
        floor = up.cwiseProduct(scene_.vessel.col(0)).cwiseMin(up.cwiseProduct(scene_.vessel.col(1))).sum();
    }
    const SolidsEnergy energy = solids_energy(comm_, solids_, floor);
    row.add("translation_energy", "J", energy.translation);
    row.add("rotation_energy", "J", energy.rotation);
    row.add("potential_energy", "J", energy.potential);
}

void Statistics::sample_fields(double time, const CouplingStep& coupling)
{
    const double round_off = 1e-9 * settings_.interval;
    if (mean_fields_->samples() == 0 && settings_.fields.from && time < *settings_.fields.from - round_off) return;
    mean_fields_->add(time, coupling.voidage(), gas_->velocity(), coupling.solids_in_cells());
    gas_->write_along(mean_fields_->fields());
}

void Statistics::keep(Archive& archive)
{
    archive.keep("scene", scene_);
    archive.keep_largest("seconds", seconds_);
    if (mean_fields_) archive.keep("mean_fields", *mean_fields_);
    if (!archive.loads()) return;
    ready();
    if (mean_fields_ && mean_fields_->samples() > 0) gas_->write_along(mean_fields_->fields());
}

}  // namespace interphase
