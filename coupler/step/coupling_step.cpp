// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/coupling_step.hpp"

#include <algorithm>
#include <cmath>

#include "momentum/drag_response.hpp"

namespace interphase {

namespace {

/// What a particle brings to its gas cell. One-way scenes send the first eight entries only, those with solid stress
/// the mass, too.
enum VisitorEntry {
    position = 0,
    velocity = 3,
    diameter = 6,  // of the real particle
    volume = 7,    // of solids in the tracked one
    mass = 8,
    held = 9,  // by contacts, 0 to 1
    acceleration = 10,
    pending = 13,
    two_way_record = 16,
    one_way_record = 8,
    one_way_record_with_stress = 9,
};

/// What it takes home: drag rate, gas velocity, pressure gradient, and what a StressExchange adds.
constexpr std::size_t homeward_record = 7;

Vector vector_at(const Scalars& flat, std::size_t start) { return {flat[start], flat[start + 1], flat[start + 2]}; }

void put(double* start, const Vector& v) { std::copy_n(v.data(), 3, start); }

/// Summed blockwise, so that round-off does not grow with the number of terms.
double sum(const Scalars& terms)
{
    return Eigen::Map<const Eigen::VectorXd>(terms.data(), static_cast<Eigen::Index>(terms.size())).sum();
}

double sphere_volume(double radius) { return 4.0 / 3.0 * M_PI * radius * radius * radius; }

}  // namespace

CouplingStep::CouplingStep(const Communicator& comm, const Settings& settings, Gas& gas, Solids& solids,
                           double largest_diameter, Stopwatch& stopwatch)
    : comm_(comm),
      settings_(settings),
      law_(*find_drag_law(settings.drag_law)),
      gas_(gas),
      solids_(solids),
      stopwatch_(stopwatch),
      homes_search_(comm, gas.locator()),
      visits_(comm),
      mapping_(comm, gas.mesh(), settings.mapping,
               settings.kernel_width > 0 ? settings.kernel_width : 2 * largest_diameter, settings.maximum_packing),
      ledger_(comm),
      stress_model_(solids.solid_stress()),
      voidage_(gas.mesh().size(), 1.0),
      solid_volume_(gas.mesh().size(), 0.0),
      exchange_rate_(gas.mesh().size(), 0.0),
      exchange_source_(3 * gas.mesh().size(), 0.0)
{
    if (stress_model_) stress_.emplace(comm_, gas_, mapping_, *stress_model_);
}

std::size_t CouplingStep::visitor_width() const
{
    return settings_.two_way ? two_way_record : stress_ ? one_way_record_with_stress : one_way_record;
}

std::size_t CouplingStep::homeward_width() const { return homeward_record + (stress_ ? StressExchange::width : 0); }

void CouplingStep::advance(double dt, int substeps)
{
    solid_step_ = dt / substeps;
    if (particle_count_ < 0) inspect_start();
    bring_particles_to_their_cells();
    map_voidage();
    map_solid_stress();
    map_drag(dt);
    solve_gas(dt);
    return_gas_to_particles(dt);
    move_particles(substeps);
    book();
}

void CouplingStep::bring_particles_to_their_cells()
{
    stopwatch_.switch_to(Phase::exchange);
    const ParticleView particles = solids_.particles();
    const std::size_t n = particles.size();
    ids_at_start_.assign(particles.id, particles.id + n);
    positions_at_start_.assign(particles.position.data(), particles.position.data() + 3 * n);

    homes_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        homes_[i] = particles.coupling[i].home;
    homes_search_.update(particles.position, homes_);
    refuse_particles_outside(particles);
    for (std::size_t i = 0; i < n; ++i)
        particles.coupling[i].home = homes_[i];
    visits_.plan(homes_);

    double weight = 1, per_real = 1;  // of the last one, which most share: a cube root is dear
    const std::size_t width = visitor_width();
    records_.resize(visits_.order().size() * width);
    std::size_t r = 0;
    for (const std::size_t i : visits_.order()) {
        const auto column = static_cast<Eigen::Index>(i);
        put(&records_[r + position], particles.position.col(column));
        put(&records_[r + velocity], particles.velocity.col(column));
        if (particles.weight[i] != weight) {
            weight = particles.weight[i];
            per_real = 1.0 / std::cbrt(weight);
        }
        records_[r + diameter] = 2 * particles.radius[column] * per_real;
        records_[r + volume] = sphere_volume(particles.radius[column]);
        if (stress_) records_[r + mass] = particles.mass[column];
        if (settings_.two_way) pack_for_two_way(particles, i, &records_[r]);
        r += width;
    }
    visits_.bring(records_, static_cast<int>(width), visitors_);
}

void CouplingStep::pack_for_two_way(const ParticleView& particles, std::size_t i, double* record) const
{
    const auto column = static_cast<Eigen::Index>(i);
    const ParticleCoupling& own = particles.coupling[i];
    const double m = particles.mass[column];
    record[mass] = m;
    record[held] =
        held_by_contacts(particles.velocity.col(column) - to_vector(own.start_velocity), to_vector(own.free_change));
    put(record + acceleration, solids_.gravity() + to_vector(own.pressure_force) / m);
    put(record + pending, solid_step_ * particles.booked_force(i) - to_vector(own.assumed_impulse));
}

void CouplingStep::map_voidage()
{
    stopwatch_.switch_to(Phase::mapping);
    const std::size_t width = visitor_width();
    positions_.resize(3 * visits_.visitors());
    volumes_.resize(visits_.visitors());
    for (std::size_t i = 0; i < visits_.visitors(); ++i) {
        std::copy_n(&visitors_[i * width + position], 3, &positions_[3 * i]);
        volumes_[i] = visitors_[i * width + volume];
    }
    mapping_.place(positions_, visits_.cells());
    for (const CellAddress& home : homes_)
        outside_ += !home.known();
    if (!needs_solid_volume()) return;

    solid_volume_ = mapping_.solid_volume(volumes_);
    relieved_ += mapping_.cells_relieved();
    if (!settings_.two_way) return;  // the gas does not feel the particles
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        voidage_[c] = 1.0 - solid_volume_[c] / gas_.mesh().volume[c];

    transactions_ = {};
    transactions_.solid_volume_in_cells = sum(solid_volume_);
    transactions_.solid_volume_of_particles = sum(volumes_);
}

void CouplingStep::map_solid_stress()
{
    if (!stress_) return;
    const std::size_t width = visitor_width();
    Scalars momenta(4 * visits_.visitors());
    for (std::size_t i = 0; i < visits_.visitors(); ++i) {
        const double m = visitors_[i * width + mass];
        put(&momenta[4 * i], m * vector_at(visitors_, i * width + velocity));
        momenta[4 * i + 3] = m;
    }
    stress_->compute(solid_volume_, momenta);
}

void CouplingStep::map_drag(double dt)
{
    const std::size_t width = visitor_width();
    const Scalars gas_velocity = gas_.velocity();
    Scalars seen_by_cells(4 * voidage_.size());
    for (std::size_t c = 0; c < voidage_.size(); ++c) {
        seen_by_cells[4 * c] = voidage_[c];
        std::copy_n(&gas_velocity[3 * c], 3, &seen_by_cells[4 * c + 1]);
    }
    mapping_.to_particles(seen_by_cells, 4, seen_);

    drag_rates_.resize(visits_.visitors());
    demands_.resize(settings_.two_way ? 4 * visits_.visitors() : 0);
    for (std::size_t i = 0; i < visits_.visitors(); ++i) {
        const double* record = &visitors_[i * width];
        const double eps = seen_[4 * i];
        const Vector own_velocity = vector_at(visitors_, i * width + velocity);
        const double slip = (vector_at(seen_, 4 * i + 1) - own_velocity).norm();
        const double d = record[diameter];
        const double reynolds = eps * gas_.density() * slip * d / gas_.viscosity();
        beyond_range_ += eps < law_.voidage_min || eps > law_.voidage_max || reynolds > law_.reynolds_max;
        drag_rates_[i] = record[volume] * drag_rate_per_volume(law_, eps, slip, d, gas_.density(), gas_.viscosity());
        if (!settings_.two_way) continue;

        const AssumedDrag drag =
            assume_drag(record[mass], drag_rates_[i], record[held], vector_at(visitors_, i * width + acceleration), dt);
        // kappa, and the part of the force that does not wait for the gas solve
        demands_[4 * i] = drag.kappa;
        put(&demands_[4 * i + 1],
            drag.kappa * own_velocity + (drag.carried - vector_at(visitors_, i * width + pending)) / dt);
    }
    if (!settings_.two_way) return;

    const Scalars contents = mapping_.to_cells(demands_, 4);
    for (std::size_t c = 0; c < voidage_.size(); ++c) {
        const double per_volume = 1.0 / gas_.mesh().volume[c];
        exchange_rate_[c] = contents[4 * c] * per_volume;
        put(&exchange_source_[3 * c], per_volume * vector_at(contents, 4 * c + 1));
    }
}

void CouplingStep::solve_gas(double dt)
{
    stopwatch_.switch_to(Phase::waiting);
    comm_.barrier();
    stopwatch_.switch_to(Phase::gas);
    if (settings_.two_way) gas_.set_voidage(voidage_);
    gas_.solve(dt, exchange_rate_, exchange_source_);
}

void CouplingStep::return_gas_to_particles(double dt)
{
    stopwatch_.switch_to(Phase::mapping);
    const Scalars gas_velocity = gas_.velocity();
    const Scalars gradient = gas_.pressure_gradient();
    if (settings_.two_way)
        for (std::size_t c = 0; c < voidage_.size(); ++c) {
            const Vector drag = exchange_rate_[c] * vector_at(gas_velocity, 3 * c) - vector_at(exchange_source_, 3 * c);
            transactions_.given_by_gas +=
                dt * (gas_.mesh().volume[c] * drag - solid_volume_[c] * vector_at(gradient, 3 * c));
        }

    Scalars seen_by_cells(6 * voidage_.size());
    for (std::size_t c = 0; c < voidage_.size(); ++c) {
        std::copy_n(&gas_velocity[3 * c], 3, &seen_by_cells[6 * c]);
        std::copy_n(&gradient[3 * c], 3, &seen_by_cells[6 * c + 3]);
    }
    mapping_.to_particles(seen_by_cells, 6, seen_);
    const std::size_t width = homeward_width();
    answers_.resize(width * visits_.visitors());
    for (std::size_t i = 0; i < visits_.visitors(); ++i) {
        double* answer = &answers_[width * i];
        answer[0] = drag_rates_[i];
        std::copy_n(&seen_[6 * i], 6, answer + 1);
        if (stress_) stress_->write_answer(i, visits_.cells()[i], answer + homeward_record);
    }

    stopwatch_.switch_to(Phase::exchange);
    visits_.take_back(answers_, static_cast<int>(width), fluid_);
    const ParticleView particles = solids_.particles();
    assumed_at_start_.setZero();
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (!homes_[i].known()) leave_without_gas(particles, i);
    std::size_t f = 0;
    for (const std::size_t i : visits_.order()) {
        const auto column = static_cast<Eigen::Index>(i);
        const double m = particles.mass[column];
        const Vector v = particles.velocity.col(column);
        const Vector u = vector_at(fluid_, f + 1);
        ParticleCoupling& own = particles.coupling[i];

        const double was_held = held_by_contacts(v - to_vector(own.start_velocity), to_vector(own.free_change));
        const Vector old_acceleration = solids_.gravity() + to_vector(own.pressure_force) / m;
        const Vector pressure_force = -sphere_volume(particles.radius[column]) * vector_at(fluid_, f + 4);
        const Vector assumed =
            assume_drag(m, fluid_[f], was_held, old_acceleration, dt).impulse(u, v, dt) + dt * pressure_force;

        particles.fluid[i] = FluidForce(m, fluid_[f], u, pressure_force, solid_step_);
        std::fill_n(particles.booked + 3 * i, 3, 0.0);
        set(own.pressure_force, pressure_force);
        set(own.assumed_impulse, assumed);
        set(own.start_velocity, v);
        set(own.free_change, free_change(m, fluid_[f], u - v, solids_.gravity() + pressure_force / m, dt));
        assumed_at_start_ += assumed;
        f += width;
    }
    if (stress_) begin_solid_stress(particles, dt);
}

void CouplingStep::begin_solid_stress(const ParticleView& particles, double dt)
{
    const StepTooLong found = stress_->begin(fluid_, homeward_record, visits_.order(), particles.mass, dt);
    too_long_.crossing_cells += found.crossing_cells;
    too_long_.beyond_relaxation += found.beyond_relaxation;
    longest_step_ = comm_.min(found.longest);
}

void CouplingStep::leave_without_gas(const ParticleView& particles, std::size_t i)
{
    ParticleCoupling& own = particles.coupling[i];
    particles.fluid[i] = FluidForce{};
    // what the gas still owes for its last step with gas stays on the books until it comes back, or leaves for good
    set(own.assumed_impulse, to_vector(own.assumed_impulse) - solid_step_ * particles.booked_force(i));
    std::fill_n(particles.booked + 3 * i, 3, 0.0);
    set(own.pressure_force, Vector::Zero());
    set(own.free_change, Vector::Zero());
    assumed_at_start_ += to_vector(own.assumed_impulse);
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

    const long count = comm_.sum(static_cast<long>(particles.size()));
    const bool fewer = count < particle_count_;
    if (fewer && !solids_.may_remove_particles()) refuse_loss(particles, particle_count_ - count);
    particle_count_ = count;
    if (!settings_.two_way) return;

    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vector taken = solid_step_ * particles.booked_force(i);
        const Vector assumed = to_vector(particles.coupling[i].assumed_impulse);
        transactions_.taken_by_particles += taken;
        transactions_.assumed_of_particles += assumed;
        transactions_.pending += taken - assumed;
    }
    ledger_.book(transactions_, assumed_at_start_, fewer);
}

Interventions CouplingStep::interventions() const
{
    return {comm_.sum(relieved_),
            comm_.sum(outside_),
            comm_.sum(beyond_range_),
            comm_.sum(stress_ ? stress_->cells_overpacked() : 0L),
            {comm_.sum(too_long_.crossing_cells), comm_.sum(too_long_.beyond_relaxation)}};
}

std::size_t CouplingStep::doubles_sent() const
{
    return homes_search_.doubles_sent() + visits_.doubles_sent() + mapping_.doubles_sent();
}

}  // namespace interphase
