// SPDX-License-Identifier: GPL-3.0-or-later
// Solids that come or go without crossing a face: gas gives way to them, or takes their place, where they are, at its
// own velocity. It does so at once and beside the flow, which would else have to carry their whole volume in one step.
#include <algorithm>

#include "base/sphere.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

namespace {

/// Of the gas in a cell, what stays however much is inserted: where more is asked for, the rest has to flow.
constexpr double least_share = 0.5;

/// Sums density * volume * u over cells into a passage, `volume` [m3] of gas a cell.
void add_gas(Passage& passage, const Gas& gas, const Scalars& volume)
{
    const Scalars velocity = gas.velocity();
    const GasProperty density = gas.density();
    for (std::size_t c = 0; c < volume.size(); ++c) {
        if (volume[c] == 0) continue;
        const double mass = volume[c] * density.in(c);
        passage.volume += volume[c];
        for (std::size_t axis = 0; axis < 3; ++axis)
            passage.momentum[axis] += mass * velocity[3 * c + axis];
    }
}

}  // namespace

void CouplingStep::restore_gas_of_those_outside(const ParticleView& particles)
{
    std::vector<CellAddress> homes, last_cells;
    Scalars volumes;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        ParticleCoupling& own = particles.coupling[i];
        if (owner_cells_[i].known() || !own.home.known()) continue;
        const auto column = static_cast<Eigen::Index>(i);
        const double volume = sphere_volume(particles.radius[column]);
        population_.totals().left_gas_mesh.add(volume, particles.mass[column] * particles.velocity.col(column));
        if (settings_.two_way) restored_ += volume;
        volumes.push_back(volume);
        last_cells.push_back(own.owner_cell);
        homes.push_back(own.home);
        own.home = {};
    }
    if (knows_last_step_)
        restore_gas(homes);
    else
        restore_gas_in(last_cells, volumes);
    knows_last_step_ = true;
}

void CouplingStep::restore_gas_of_departures()
{
    std::vector<CellAddress> homes;
    for (const Departure& departure : solids_.departures()) {
        if (!departure.coupling.home.known()) continue;
        restored_ += sphere_volume(departure.radius);
        homes.push_back(departure.coupling.home);
    }
    restore_gas(homes);
}

void CouplingStep::restore_gas(const std::vector<CellAddress>& homes)
{
    if (!settings_.two_way || !comm_.any(!homes.empty())) return;
    OwnerExchange to_homes(comm_);
    to_homes.plan(homes);
    std::vector<double> gone(starts_.size(), 0.0), of_travellers;
    for (const int i : to_homes.cells())
        gone[static_cast<std::size_t>(i)] = 1;
    for (const std::size_t i : owner_exchange_.order())
        of_travellers.push_back(gone[i]);
    Scalars volumes = at_visitors(std::move(of_travellers));
    for (std::size_t v = 0; v < volumes.size(); ++v)
        volumes[v] *= volumes_[v];
    const Scalars restored = mapping_.deposit(volumes);
    for (std::size_t c = 0; c < restored.size(); ++c)
        gas_volume_[c] += restored[c];
    add_gas(population_.totals().gas_restored, gas_, restored);
}

void CouplingStep::restore_gas_in(const std::vector<CellAddress>& cells, const Scalars& volumes)
{
    if (!settings_.two_way || !comm_.any(!cells.empty())) return;
    OwnerExchange to_cells(comm_);
    to_cells.plan(cells);
    Scalars travelling, arrived, restored(gas_volume_.size(), 0.0);
    for (const std::size_t i : to_cells.order())
        travelling.push_back(volumes[i]);
    to_cells.gather(Message(travelling, arrived));
    for (std::size_t v = 0; v < arrived.size(); ++v)
        restored[static_cast<std::size_t>(to_cells.cells()[v])] += arrived[v];
    for (std::size_t c = 0; c < restored.size(); ++c)
        gas_volume_[c] += restored[c];
    add_gas(population_.totals().gas_restored, gas_, restored);
}

void CouplingStep::note_newcomers(const ParticleView& particles)
{
    newcomers_.assign(particles.size(), 0.0);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (!owner_cells_[i].known()) continue;
        ParticleCoupling& own = particles.coupling[i];
        const auto column = static_cast<Eigen::Index>(i);
        newcomers_[i] = !own.home.known();
        if (own.was_outside)
            population_.totals().entered_gas_mesh.add(sphere_volume(particles.radius[column]),
                                                      particles.mass[column] * particles.velocity.col(column));
        own.was_outside = false;
        own.home = {comm_.rank(), static_cast<int>(i)};
    }
}

void CouplingStep::displace_gas_of_newcomers()
{
    const bool some = std::any_of(newcomers_.begin(), newcomers_.end(), [](double is_new) { return is_new > 0; });
    if (!comm_.any(some)) return;
    std::vector<double> of_travellers;
    const ParticleView particles = solids_.particles();
    for (const std::size_t i : owner_exchange_.order()) {
        of_travellers.push_back(newcomers_[i]);
        if (newcomers_[i] > 0) displaced_ += sphere_volume(particles.radius[static_cast<Eigen::Index>(i)]);
    }
    Scalars volumes = at_visitors(std::move(of_travellers));
    for (std::size_t v = 0; v < volumes.size(); ++v)
        volumes[v] *= volumes_[v];
    Scalars displaced = mapping_.deposit(volumes);
    for (std::size_t c = 0; c < displaced.size(); ++c) {
        const double most = gas_volume_[c] - least_share * voidage_[c] * gas_.mesh().volume[c];
        if (displaced[c] > 0 && displaced[c] > most) {
            ++pushed_;
            const double possible = std::max(0.0, most);
            displaced_ -= displaced[c] - possible;
            displaced[c] = possible;
        }
        gas_volume_[c] -= displaced[c];
    }
    add_gas(population_.totals().gas_displaced, gas_, displaced);
}

std::vector<double> CouplingStep::at_visitors(std::vector<double> of_travellers) const
{
    std::vector<double> arrived;
    owner_exchange_.gather(Message(of_travellers, arrived));
    return arrived;
}

}  // namespace interphase
