// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_records.hpp"

#include <sys/resource.h>

#include <filesystem>

#include "base/disk_room.hpp"
#include "base/disk_watch.hpp"
#include "base/sphere.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "records/case_inputs.hpp"
#include "records/provenance.hpp"

namespace interphase {

namespace {

constexpr const char* momentum_of_axis[] = {"_momentum_x", "_momentum_y", "_momentum_z"};

/// Columns of what came and went: of each way the number, the volume and the momentum.
void add_passages(std::vector<Results::Entry>& row, const PopulationTotals& totals)
{
    visit_passages(totals, [&](const char* key, const char*, const Passage& passage) {
        const bool of_gas = &passage == &totals.gas_displaced || &passage == &totals.gas_restored;
        if (!of_gas) row.push_back({key, "1", passage.particles});
        row.push_back({key, "m3", passage.volume, "_volume"});
        for (std::size_t axis = 0; axis < 3; ++axis)
            row.push_back({key, "kg m/s", passage.momentum[axis], momentum_of_axis[axis]});
    });
}

/// Of this rank so far [bytes].
double peak_memory()
{
    constexpr double bytes_per_unit = 1024;  // Linux counts in kilobytes
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return bytes_per_unit * static_cast<double>(usage.ru_maxrss);
}

ParticleRows rows_of(const ParticleView& particles)
{
    const std::size_t n = particles.size();
    const auto flat = [n](const VectorsView& vectors) { return Scalars(vectors.data(), vectors.data() + 3 * n); };
    ParticleRows rows{std::vector<int>(particles.id, particles.id + n),
                      std::vector<int>(particles.type, particles.type + n),
                      flat(particles.position),
                      flat(particles.velocity),
                      flat(particles.angular_velocity),
                      flat(particles.force),
                      Scalars(n),
                      Scalars(n),
                      std::nullopt};
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        rows.diameter[i] = 2 * particles.radius[at];
        rows.density[i] = particles.mass[at] / sphere_volume(particles.radius[at]);
    }
    if (!particles.weight.differ()) return rows;
    rows.weight.emplace(n);
    for (std::size_t i = 0; i < n; ++i)
        (*rows.weight)[i] = particles.weight[i];
    return rows;
}

}  // namespace

RunRecords::RunRecords(const Scene& scene, std::optional<double> goes_on_from)
    : scene_(scene),
      results_(scene.comm, goes_on_from),
      snapshots_(scene.comm, goes_on_from),
      rows_(scene.gas_case.time(), scene.settings.record_interval)
{
    if (scene.settings.snapshot_interval > 0)
        own_snapshots_.emplace(scene.gas_case.time(), scene.settings.snapshot_interval);
    const StatisticsSettings& statistics = scene.settings.statistics;
    if (statistics.tap_interval > 0 && scene.gas) taps_.emplace(scene.gas_case.time(), statistics.tap_interval);
    if (statistics.interval == 0) return;
    samples_.emplace(scene.gas_case.time(), statistics.interval);
    const Box bounds = scene.gas ? scene.gas->bounds() : empty_box();
    statistics_.emplace(scene.comm, statistics, scene.solids, scene.gas, scene.gas ? &bounds : nullptr);
}

void RunRecords::describe(double solid_step, double gas_step)
{
    const auto& [comm, settings, gas_case, solids, gas, coupling, without_gas, at_start, processor] = scene_;
    results_.describe("/meta", "case", gas_case.name());
    results_.describe("/meta", "method", settings.method.name);
    results_.describe("/meta", "plugins", solids.plugins());
    results_.describe("/meta", "ranks", comm.size());
    results_.describe("/meta", "particles_at_start", static_cast<double>(at_start.tracked));
    describe_population();
    results_.describe("/meta", "solid_step", solid_step);
    if (const std::optional<double> contact = solids.contact_duration())
        results_.describe("/meta", "contact_duration", *contact);
    results_.describe("/meta", "gas_step", gas_step);
    results_.describe("/meta", "drag_law", settings.drag_law);
    const Version version = this_version();
    results_.describe("/meta", "versions",
                      name_and_number(version) + ", " + solids.version() + ", " + gas_case.engine());
    if (comm.is_master()) record_provenance(results_, version, case_inputs(".", settings.script, settings.variables));
    if (gas) {
        results_.describe_box("/meta", "domain", gas->bounds());
        results_.describe("/meta", "gas_volume", gas->total_volume());
        results_.describe("/meta", "gravity", gas->gravity().norm());
        const GasProperty density = gas->density(), viscosity = gas->viscosity();
        if (!density.varies()) results_.describe("/meta", "gas_density", density.uniform);
        if (!viscosity.varies()) results_.describe("/meta", "gas_viscosity", viscosity.uniform);
    }
    if (statistics_) statistics_->describe(results_);
    if (taps_) {
        Scalars places;
        for (const Vector& tap : settings.pressure_taps)
            places.insert(places.end(), tap.data(), tap.data() + 3);
        results_.describe("/taps", "places", places);
    }
    results_.add_row("/parts", {{"time", "s", gas_case.time()}, {"ranks", "1", static_cast<double>(comm.size())}});
}

void RunRecords::describe_population()
{
    const auto& [comm, settings, gas_case, solids, gas, coupling, without_gas, at_start, processor] = scene_;
    const ParticleView particles = solids.particles();
    Population now = counted(comm, particles);
    if (now.tracked == 0) now = {0, 0, at_start.lowest_weight, at_start.highest_weight, 0, 0};
    const bool same = now.lowest_weight == now.highest_weight;
    results_.describe("/meta", "weight", now.tracked > 0 || same ? now.mean_weight() : at_start.mean_weight());
    results_.describe("/meta", "lowest_weight", now.lowest_weight);
    results_.describe("/meta", "highest_weight", now.highest_weight);
    results_.describe("/meta", "particles", static_cast<double>(now.tracked));
    results_.describe("/meta", "real_particles", now.real);
    if (gas && gas->gravity().norm() > 0)
        results_.describe("/meta", "bed_weight_per_area", weight_per_area(*gas, comm.sum(particles.mass.sum())));
}

const PopulationTotals& RunRecords::came_and_went() const
{
    return scene_.coupling ? scene_.coupling->population() : scene_.without_gas->of_all_ranks();
}

void RunRecords::add_ledger_row()
{
    if (!scene_.coupling || !scene_.settings.two_way) return;
    const CouplingStep& coupling = *scene_.coupling;
    std::vector<Results::Entry> row{{"time", "s", scene_.gas_case.time()}};
    for (const Account* account : coupling.ledger().accounts())
        row.push_back({account->key().c_str(), "1", account->residual(), "_residual"});
    for (const Count& count : coupling.counts())
        row.push_back({count.kind->key, "1", static_cast<double>(count.number)});
    const Eigen::VectorXd& carried_off = coupling.ledger().momentum.carried_off();
    for (int axis = 0; axis < 3; ++axis)
        row.push_back({"carried_off", "kg m/s", carried_off[axis], momentum_of_axis[axis]});
    add_passages(row, came_and_went());
    results_.add_row("/ledger", row);
}

void RunRecords::record(const Moment& moment)
{
    GasCase& gas_case = scene_.gas_case;
    const double now = gas_case.time();
    const bool row_due = rows_.due(now, moment.gas_step);
    if (row_due || moment.shown || moment.at_end) {
        if (moment.at_start && scene_.coupling) scene_.coupling->look_at_start();
        last_seen_ = observe(scene_.comm, scene_.solids, scene_.gas,
                             scene_.coupling ? scene_.coupling->voidage() : Scalars{}, scene_.settings.pressure_taps);
        const PopulationTotals& totals = came_and_went();
        last_seen_.came = totals.came();
        last_seen_.went = totals.went();
        if (row_due) {
            results_.add_row("/series", last_seen_.row(now));
            add_processor_time_row();
            add_counters_row();
        }
    }
    rows_.pass(now, moment.gas_step);
    take_statistics(moment);

    const bool write_due = gas_case.write_due() || moment.at_end;
    const bool snapshot_due = own_snapshots_ ? own_snapshots_->due(now, moment.gas_step) : write_due;
    if (own_snapshots_) own_snapshots_->pass(now, moment.gas_step);
    const bool writes = snapshot_due || moment.at_start || moment.at_end || write_due;
    if (writes || moment.shown) refuse_full_disk();
    if (writes || results_.flush_due()) flush();  // rows do not wait for what takes long
    if (!writes) return;
    const DiskWatch watch(scene_.comm.rank(), "interphase", full_disk().message());
    if ((snapshot_due || moment.at_start || moment.at_end) && snapshots_.last() != now)
        snapshots_.write(now, rows_of(scene_.solids.particles()));
    if (write_due && !moment.at_start) {
        if (scene_.gas) gas_case.write();
        describe_population();
        results_.flush();
    }
    refuse_full_disk();
}

void RunRecords::add_processor_time_row()
{
    const Scalars seconds = scene_.processor.seconds();
    std::vector<Results::Entry> row{{"time", "s", scene_.gas_case.time()}};
    for (std::size_t phase = 0; phase < phase_names.size(); ++phase)
        row.push_back({phase_names[phase].data(), "s", seconds[phase]});
    results_.add_row("/processor_time", row);
}

void RunRecords::add_counters_row()
{
    const std::vector<Count> counters = scene_.solids.counters();
    if (counters.empty()) return;
    std::vector<Results::Entry> row{{"time", "s", scene_.gas_case.time()}};
    for (const Count& count : counters)
        row.push_back({count.kind->key, *count.kind->unit ? count.kind->unit : "1", count.value});
    results_.add_row("/counters", row);
}

void RunRecords::take_statistics(const Moment& moment)
{
    const double now = scene_.gas_case.time();
    if (taps_) {
        if (taps_->due(now, moment.gas_step)) add_tap_row();
        taps_->pass(now, moment.gas_step);
    }
    if (!samples_) return;
    if (samples_->due(now, moment.gas_step)) {
        if (moment.at_start && scene_.coupling) scene_.coupling->look_at_start();
        statistics_->sample(now, scene_.coupling, results_);
    }
    samples_->pass(now, moment.gas_step);
}

void RunRecords::add_tap_row()
{
    Results::Row row;
    row.add("time", "s", scene_.gas_case.time());
    Scalars pressures;
    for (const Vector& tap : scene_.settings.pressure_taps)
        pressures.push_back(scene_.gas->pressure_at(tap));
    row.add("pressure", "Pa", pressures);
    results_.add_row("/taps", row);
}

void RunRecords::flush()
{
    results_.describe("/meta", "simulated_time", scene_.gas_case.time());
    if (statistics_) statistics_->describe_mean_fields(results_);
    results_.flush();
}

Problem RunRecords::full_disk() const
{
    Problem problem;
    problem.what = "the disk is full: what was written last may be cut off";
    problem.where = std::filesystem::current_path().string() + ", at t = " + text(scene_.gas_case.time()) + " s";
    problem.remedy =
        "make room, or write less: writeInterval and purgeWrite in system/controlDict, records in "
        "system/couplingDict, dumps in " +
        scene_.settings.script;
    problem.kind = ExitCode::disk;
    return problem;
}

void RunRecords::refuse_full_disk() const
{
    scene_.comm.fail_together(scene_.comm.is_master() && disk_is_full(0) ? std::optional(full_disk()) : std::nullopt);
}

void RunRecords::describe_end(const Ending& ending)
{
    if (!ending.stopped_by.empty()) results_.describe("/meta", "stopped_by", ending.stopped_by);
    for (std::size_t phase = 0; phase < phase_names.size(); ++phase)
        results_.describe("/timing", std::string(phase_names[phase]), ending.spent.seconds[phase]);
    if (scene_.coupling) {
        const auto sent = static_cast<double>(scene_.coupling->bytes_sent());
        results_.describe("/exchange", "bytes_sent_by_busiest_rank", scene_.comm.max(sent));
        results_.describe("/exchange", "bytes_sent", scene_.comm.sum(sent));
    }
    for (const Count& count : ending.warnings)
        results_.describe("/meta", count.kind->key, static_cast<double>(count.number));
    for (const Count& count : ending.counters)
        results_.describe("/counters", count.kind->key, count.value);
    describe_population();
    results_.describe("/meta", "peak_memory", scene_.comm.sum(peak_memory()));
    if (statistics_) results_.describe("/statistics", "wall_time", scene_.comm.max(statistics_->seconds()));
    results_.describe("/meta", "wall_time", ending.spent.wall);
    flush();
}

void RunRecords::keep(Archive& archive)
{
    archive.keep("rows", rows_);
    if (own_snapshots_) archive.keep("snapshots", *own_snapshots_);
    if (taps_) archive.within("taps", [&] { taps_->keep(archive); });
    if (!samples_) return;
    archive.within("samples", [&] { samples_->keep(archive); });
    archive.within("statistics", [&] {
        if (!archive.loads() || archive.has("scene/columns")) statistics_->keep(archive);
    });
}

}  // namespace interphase
