// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/population_watch.hpp"

#include <algorithm>
#include <cmath>

#include "base/sphere.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"

namespace interphase {

namespace {

constexpr const char* remedy =
    "check walls and boundaries in the script, and the solid step; a scene that removes particles on purpose says so "
    "with a fix massflow/mesh ... delete_atoms yes, one that lets them leave through the boundary of their domain with "
    "`outsideMesh ignore;` in system/couplingDict";

std::string how_many_lost(long lost, long all)
{
    return std::to_string(lost) + " of " + std::to_string(all) +
           " particles were lost in this gas step: they were outside the particles' domain and were dropped";
}

}  // namespace

PopulationWatch::PopulationWatch(const Communicator& comm, const Settings& settings)
    : comm_(comm),
      settings_(settings),
      may_leave_through_boundary_(settings.gas == GasModel::none || settings.outside_mesh == OutsideMesh::ignore)
{}

void PopulationWatch::remember(const ParticleView& particles)
{
    summed_.reset();
    if (count_ < 0) count_ = comm_.sum(static_cast<long>(particles.size()));
    ids_.assign(particles.id, particles.id + particles.size());
    positions_.resize(particles.size());
    for (std::size_t i = 0; i < positions_.size(); ++i)
        positions_[i] = particles.position.col(static_cast<Eigen::Index>(i));
}

void PopulationWatch::book(Solids& solids)
{
    const ParticleView particles = solids.particles();
    const std::vector<Departure>& departures = solids.departures();
    const std::vector<std::size_t>& arrivals = solids.arrivals();
    struct Numbers {
        double there, came, went, through_boundary;
    } all{static_cast<double>(particles.size()), static_cast<double>(arrivals.size()),
          static_cast<double>(departures.size()), 0};
    for (const Departure& departure : departures) {
        all.came += departure.is_new;
        all.through_boundary += departure.exit == Exit::boundary;
    }
    comm_.sum(all);
    if (all.through_boundary > 0 && !may_leave_through_boundary_) refuse_boundary(departures);
    const long lost = count_ + std::lround(all.came - all.went - all.there);
    if (lost != 0) refuse_loss(solids, lost);
    if (all.came > 0) refuse_parcels(particles, arrivals);
    wholes_.gas_steps += 1;
    wholes_.particle_steps += static_cast<double>(count_);
    count_ = std::lround(all.there);
    add_departures(departures);
    add_arrivals(particles, arrivals);
}

void PopulationWatch::add_departures(const std::vector<Departure>& departures)
{
    for (const Departure& departure : departures) {
        const double volume = sphere_volume(departure.radius);
        const Vector momentum = departure.mass * to_vector(departure.velocity);
        if (departure.is_new) totals_.inserted.add(volume, momentum);
        switch (departure.exit) {
            case Exit::boundary:
                totals_.left_through_boundary.add(volume, momentum);
                break;
            case Exit::mesh:
                totals_.deleted_by_mesh.add(volume, momentum);
                break;
            case Exit::script:
                totals_.deleted_by_script.add(volume, momentum);
                break;
        }
    }
}

void PopulationWatch::add_arrivals(const ParticleView& particles, const std::vector<std::size_t>& arrivals)
{
    for (const std::size_t i : arrivals) {
        const auto column = static_cast<Eigen::Index>(i);
        totals_.inserted.add(sphere_volume(particles.radius[column]),
                             particles.mass[column] * particles.velocity.col(column));
    }
}

const PopulationTotals& PopulationWatch::of_all_ranks() const
{
    if (!summed_) {
        summed_ = totals_;
        comm_.sum(*summed_);
    }
    return *summed_;
}

void PopulationWatch::refuse_boundary(const std::vector<Departure>& departures) const
{
    const auto is_lost = [](const Departure& departure) { return departure.exit == Exit::boundary; };
    const long lost = comm_.sum(static_cast<long>(std::count_if(departures.begin(), departures.end(), is_lost)));
    const auto found = std::find_if(departures.begin(), departures.end(), is_lost);
    std::optional<Problem> problem;
    if (found != departures.end())
        problem = Problem{how_many_lost(lost, count_),
                          "particle " + std::to_string(found->id) + " (rank " + std::to_string(comm_.rank()) +
                              ") is one of them; it was last seen at " + text(to_vector(found->position)),
                          remedy};
    comm_.fail_together(problem);
}

void PopulationWatch::refuse_parcels(const ParticleView& particles, const std::vector<std::size_t>& arrivals) const
{
    if (settings_.method.tracks_parcels || !particles.weight.differ()) return;
    std::optional<Problem> problem;
    for (const std::size_t i : arrivals) {
        if (problem || !(particles.weight[i] > 1)) continue;
        problem = Problem{
            "particle " + std::to_string(particles.id[i]) + " was inserted with a weight of " +
                text(particles.weight[i]) + ", and method " + settings_.method.name + " tracks real particles",
            "at " + text(Vector(particles.position.col(static_cast<Eigen::Index>(i)))) + "; " + settings_.script,
            or_with_parcels("leave the property `weight` of what inserts it away", settings_.method)};
    }
    comm_.fail_together(problem);
}

void PopulationWatch::refuse_loss(Solids& solids, long lost) const
{
    if (lost < 0)
        throw UserError(std::to_string(-lost) + " particles appeared in this gas step that nobody inserted",
                        settings_.script, "insert particles by fix insert/*, or before the run");
    // Which one: over all ranks, an array as long as the highest id. The run ends here, so that size does not matter.
    const ParticleView particles = solids.particles();
    const auto highest = std::max_element(ids_.begin(), ids_.end());
    const double last_id = comm_.max(highest == ids_.end() ? 0.0 : *highest);
    Scalars there(static_cast<std::size_t>(last_id) + 1, 0.0);
    const auto see = [&](int id) {
        if (id <= last_id) there[static_cast<std::size_t>(id)] = 1;
    };
    for (std::size_t i = 0; i < particles.size(); ++i)
        see(particles.id[i]);
    for (const Departure& departure : solids.departures())
        see(departure.id);
    comm_.sum(there);
    std::optional<Problem> problem;
    for (std::size_t i = 0; i < ids_.size() && !problem; ++i)
        if (there[static_cast<std::size_t>(ids_[i])] == 0)
            problem = Problem{how_many_lost(lost, count_),
                              "particle " + std::to_string(ids_[i]) + " (rank " + std::to_string(comm_.rank()) +
                                  ") is one of them; it started the step at " + text(positions_[i]),
                              remedy};
    comm_.fail_together(problem);
    throw UserError(how_many_lost(lost, count_), "among particles that the script had just inserted", remedy);
}

}  // namespace interphase
