// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/coupling_step.hpp"

#include "base/sphere.hpp"
#include "exchange/moved_cells.hpp"

namespace interphase {

namespace {

/// Summed blockwise, so that round-off does not grow with the number of terms.
double sum(const Scalars& terms)
{
    return Eigen::Map<const Eigen::VectorXd>(terms.data(), static_cast<Eigen::Index>(terms.size())).sum();
}

}  // namespace

CouplingStep::CouplingStep(const Communicator& comm, const Settings& settings, Gas& gas, Solids& solids,
                           Stopwatch& stopwatch)
    : comm_(comm),
      settings_(settings),
      gas_(gas),
      solids_(solids),
      stopwatch_(stopwatch),
      owner_cell_search_(comm, gas.locator()),
      owner_exchange_(comm),
      mapping_(comm, gas.mesh(), settings.mapping),
      forces_(settings, gas, mapping_, solids.gravity()),
      ledger_(comm),
      watch_(comm, gas, solids),
      outlets_(gas, solids.gravity()),
      population_(comm, settings),
      stress_model_(solids.solid_stress()),
      periods_(solids.periods()),
      voidage_(gas.mesh().size(), 1.0),
      solid_volume_(gas.mesh().size(), 0.0),
      demand_(gas.mesh().size()),
      cells_(comm.sum(static_cast<double>(gas.mesh().size())))
{
    if (stress_model_) stress_.emplace(comm_, gas_, mapping_, *stress_model_);
    refuse_other_periods();
}

std::string CouplingStep::mapping_description()
{
    const ParticleView particles = solids_.particles();
    Scalars volumes;
    for (std::size_t i = 0; i < particles.size(); ++i)
        volumes.push_back(sphere_volume(particles.radius[static_cast<Eigen::Index>(i)]));
    for (const double radius : solids_.radii_to_come())
        volumes.push_back(sphere_volume(radius));
    std::string words = mapping_.description(volumes);
    // where in such a cell a sphere is decides how far it sees itself (forces/self_disturbance/README.md)
    if (settings_.two_way && settings_.self_disturbance && mapping_.has_cells_of(0, 3))
        words += "; drag of a lone sphere within 5 % (3 % in cells above 3 diameters)";
    return words;
}

void CouplingStep::advance(double dt, int substeps)
{
    solid_step_ = dt / substeps;
    kicks_again_ = substeps == 1 && solids_.takes_new_forces();
    long_step_ = forces_.is_long(dt);
    if (!inspected_) inspect_start();
    bring_particles_to_their_cells();
    map_voidage();
    map_solid_stress();
    watch_.note_crossing(visitors_, dt);
    ask_for_forces(dt);
    solve_gas(dt);
    return_gas_to_particles(dt);
    watch_.refuse_impossible_flight(solid_step_);
    move_particles(substeps);
    book();
    if (settings_.two_way) watch_.observe(forces_, voidage_, solid_volume_, dt);
}

void CouplingStep::place_in_periods(const ParticleView& particles)
{
    images_.clear();
    if (!periods_.any()) return;
    for (std::size_t i = 0; i < particles.size(); ++i)
        images_.push_back(periods_.wrapped(particles.position.col(static_cast<Eigen::Index>(i))));
}

VectorsView CouplingStep::images_of(const ParticleView& particles) const
{
    if (images_.empty()) return particles.position;
    return VectorsView(images_.front().data(), 3, static_cast<Eigen::Index>(images_.size()));
}

void CouplingStep::bring_particles_to_their_cells()
{
    stopwatch_.switch_to(Phase::exchange);
    const ParticleView particles = solids_.particles();
    const std::size_t n = particles.size();
    population_.remember(particles);

    owner_cells_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        owner_cells_[i] = particles.coupling[i].owner_cell;
    place_in_periods(particles);
    owner_cell_search_.update(images_of(particles), particles.radius, owner_cells_);
    beyond_edge_ += owner_cell_search_.beyond_edge();
    refuse_particles_outside(particles);
    restore_gas_of_those_outside(particles);
    for (std::size_t i = 0; i < n; ++i)
        particles.coupling[i].owner_cell = owner_cells_[i];
    owner_exchange_.plan(owner_cells_);
    note_newcomers(particles);

    const std::size_t travelling = owner_exchange_.order().size();
    travellers_.visitor.resize(travelling);
    if (settings_.two_way) travellers_.owed.resize(travelling);
    if (asks_for_restraint()) travellers_.restraint.resize(travelling);
    if (stress_) travellers_.momentum.resize(travelling);
    RealDiameter real_diameter;
    starts_.resize(n);
    for (std::size_t t = 0; t < travelling; ++t) {
        const std::size_t i = owner_exchange_.order()[t];
        const auto column = static_cast<Eigen::Index>(i);
        starts_[i] = starting_velocity(particles, i);
        Visitor& visitor = travellers_.visitor[t];
        set(visitor.position, images_of(particles).col(column));
        set(visitor.velocity, starts_[i]);
        visitor.diameter = real_diameter(particles.radius[column], particles.weight[i]);
        visitor.volume = sphere_volume(particles.radius[column]);
        visitor.mass = particles.mass[column];
        if (settings_.two_way) travellers_.owed[t] = owed_to(particles, i);
        if (asks_for_restraint()) travellers_.restraint[t] = restraint_of(particles, i);
        if (!stress_) continue;
        const Vector v = kicks_again_ ? starts_[i] : particles.velocity.col(column);
        set(travellers_.momentum[t].momentum, particles.mass[column] * v);
        travellers_.momentum[t].mass = particles.mass[column];
    }
    Message message(travellers_.visitor, visitors_.visitor);
    if (settings_.two_way) message.add(travellers_.owed, visitors_.owed);
    if (asks_for_restraint()) message.add(travellers_.restraint, visitors_.restraint);
    if (stress_) message.add(travellers_.momentum, visitors_.momentum);
    owner_exchange_.gather(message);
    visitors_.cell = owner_exchange_.cells();
}

void CouplingStep::take_voidage(const Scalars& solid_volume)
{
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        voidage_[c] = 1.0 - solid_volume[c] / gas_.mesh().volume[c];
}

void CouplingStep::place_visitors()
{
    positions_.resize(visitors_.size());
    volumes_.resize(visitors_.size());
    for (std::size_t i = 0; i < visitors_.size(); ++i) {
        positions_[i] = to_vector(visitors_.visitor[i].position);
        volumes_[i] = visitors_.visitor[i].volume;
    }
    mapping_.place(positions_, visitors_.cell, volumes_);
}

void CouplingStep::map_voidage()
{
    stopwatch_.switch_to(Phase::mapping);
    place_visitors();
    for (const CellAddress& owner : owner_cells_)
        outside_ += !owner.known();
    if (!needs_solid_volume()) return;

    solid_volume_ = mapping_.solid_volume(volumes_);
    relieved_ += mapping_.cells_relieved();
    if (!settings_.two_way) return;  // the gas does not feel the particles
    take_voidage(solid_volume_);
    if (gas_volume_.empty())
        for (std::size_t c = 0; c < voidage_.size(); ++c)
            gas_volume_.push_back(voidage_[c] * gas_.mesh().volume[c]);
    else
        displace_gas_of_newcomers();

    ledger_.solid_volume.step = {sum(solid_volume_), sum(volumes_)};
}

void CouplingStep::map_solid_stress()
{
    if (stress_) stress_->compute(solid_volume_, visitors_.momentum);
}

void CouplingStep::ask_for_forces(double dt)
{
    const Motion motion = kicks_again_ ? Motion::by_new_forces : Motion::by_drift;
    forces_.ask(visitors_, voidage_, {dt, long_step_, motion}, demand_);
    if (!settings_.two_way) return;
    for (std::size_t c = 0; c < voidage_.size(); ++c) {
        demand_.gas_share[c] = gas_volume_[c] * (1.0 / gas_.mesh().volume[c]);
        demand_.surplus[c] = (demand_.gas_share[c] - voidage_[c]) / dt;
    }
}

void CouplingStep::solve_gas(double dt)
{
    stopwatch_.switch_to(Phase::waiting);
    comm_.barrier();
    stopwatch_.switch_to(Phase::gas);
    if (settings_.two_way) gas_.set_voidage(voidage_);
    gas_.solve(dt, demand_);
    if (!settings_.two_way) return;
    const Scalars outflow = gas_.outflow();
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        gas_volume_[c] -= outflow[c];
    const Crossing crossing = gas_.crossing();
    ledger_.gas_volume.step = {0, crossing.in, crossing.out};
}

void CouplingStep::return_gas_to_particles(double dt)
{
    stopwatch_.switch_to(Phase::mapping);
    forces_.answer(visitors_, answers_.of_visitors, added_masses_.of_visitors);
    if (settings_.two_way) {
        ledger_.momentum.step.given_by_gas = forces_.given_by_gas(solid_volume_, demand_);
        outlets_.observe(visitors_, voidage_, forces_.pressure_gradient());
    }
    if (stress_) stress_->answer(visitors_.cell, of_stress_.of_visitors);

    stopwatch_.switch_to(Phase::exchange);
    const bool with_added_mass = forces_.needs().added_mass;
    Message message(answers_.of_visitors, answers_.arrived);
    if (with_added_mass) message.add(added_masses_.of_visitors, added_masses_.arrived);
    if (stress_) message.add(of_stress_.of_visitors, of_stress_.arrived);
    owner_exchange_.scatter(message);

    const ParticleView particles = solids_.particles();
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (!owner_cells_[i].known()) leave_without_gas(particles, i);
    for (std::size_t t = 0; t < owner_exchange_.order().size(); ++t)
        take_home(particles, owner_exchange_.order()[t], answers_.arrived[t],
                  with_added_mass ? added_masses_.arrived[t].mass : 0.0, dt);
    if (stress_) stress_->begin(answers_.arrived, of_stress_.arrived, owner_exchange_.order(), particles.mass, dt);
}

void CouplingStep::move_particles(int substeps)
{
    stopwatch_.switch_to(Phase::waiting);
    comm_.barrier();
    stopwatch_.switch_to(Phase::solids);
    solids_.advance(substeps);
    stopwatch_.switch_to(Phase::waiting);
    comm_.barrier();
}

void CouplingStep::book()
{
    stopwatch_.switch_to(Phase::exchange);
    const ParticleView particles = solids_.particles();
    comm_.fail_together(trouble(particles));

    population_.book(solids_);
    if (!settings_.two_way) return;
    restore_gas_of_departures();
    ledger_.gas_volume.step.content = sum(gas_volume_);
    ledger_.gas_volume.step.in += restored_;
    ledger_.gas_volume.step.out += displaced_;
    displaced_ = restored_ = 0;

    ExchangeAccount::Step& momentum = ledger_.momentum.step;
    Vector taken = momentum.taken_by_particles, owed = Vector::Zero();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (stress_) {
            const double m = particles.mass[static_cast<Eigen::Index>(i)];
            const Vector force = stress_->returned_by_drag(i, m, solid_step_) / solid_step_;
            Eigen::Map<Vector>(particles.booked + 3 * i) += force;
        }
        const Vector taken_here = solid_step_ * particles.booked_force(i);
        const Vector assumed_here = to_vector(particles.coupling[i].assumed_impulse);
        taken += taken_here;
        owed += taken_here - assumed_here;
    }
    Vector carried_off = Vector::Zero();
    for (const Departure& departure : solids_.departures()) {
        const Vector taken_there = solid_step_ * to_vector(departure.booked);
        taken += taken_there;
        carried_off += to_vector(departure.coupling.assumed_impulse) - taken_there;
    }
    momentum.taken_by_particles = taken;
    momentum.carried_off = carried_off;
    momentum.owed = owed;
    book_solids(particles);
    ledger_.book();
}

void CouplingStep::book_solids(const ParticleView& particles)
{
    Scalars volumes;
    volumes.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i)
        volumes.push_back(sphere_volume(particles.radius[static_cast<Eigen::Index>(i)]));
    const PopulationTotals& now = population_.totals();
    const double in = now.inserted.volume;
    const double out = now.left_through_boundary.volume + now.deleted_by_mesh.volume + now.deleted_by_script.volume;
    ledger_.solids.step = {sum(volumes), in - booked_in_, out - booked_out_};
    booked_in_ = in;
    booked_out_ = out;
}

std::vector<CellSolids> CouplingStep::solids_in_cells() const
{
    std::vector<CellSolids> of_visitors(visitors_.size());
    for (std::size_t i = 0; i < visitors_.size(); ++i) {
        const Visitor& visitor = visitors_.visitor[i];
        of_visitors[i].volume = visitor.volume;
        set(of_visitors[i].flow, visitor.volume * to_vector(visitor.velocity));
    }
    return mapping_.deposit(of_visitors);
}

std::size_t CouplingStep::bytes_sent() const
{
    return owner_cell_search_.bytes_sent() + owner_exchange_.bytes_sent() + mapping_.bytes_sent();
}

void CouplingStep::keep(Archive& archive)
{
    archive.keep("mapping", mapping_);
    archive.keep("forces", forces_);
    archive.keep("ledger", ledger_);
    archive.keep("watch", watch_);
    if (!archive.loads() || archive.has("outlets")) archive.keep("outlets", outlets_);
    archive.keep("population", population_);
    if (stress_) archive.keep("stress", *stress_);
    archive.keep_cells("gas_volume", gas_volume_);
    archive.keep("inspected", inspected_);
    archive.keep_share("outside", outside_);
    archive.keep_share("beyond_edge", beyond_edge_);
    archive.keep_share("relieved", relieved_);
    archive.keep_share("pushed", pushed_);
    archive.keep_share("booked_in", booked_in_);
    archive.keep_share("booked_out", booked_out_);
    if (!archive.loads()) return;
    knows_last_step_ = false;
    if (!archive.moved_cells()) return;
    const ParticleView particles = solids_.particles();
    owner_cells_.clear();
    for (std::size_t i = 0; i < particles.size(); ++i)
        owner_cells_.push_back(particles.coupling[i].owner_cell);
    move_addresses(comm_, archive, owner_cells_);
    for (std::size_t i = 0; i < particles.size(); ++i)
        particles.coupling[i].owner_cell = owner_cells_[i];
}

}  // namespace interphase
