// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/coupling_step.hpp"

#include <algorithm>
#include <cmath>

#include "momentum/drag_response.hpp"
#include "step/coupling_records.hpp"

namespace interphase {

namespace {

/// Whether it rests where it rested a gas step ago: then nobody moves it, whatever pushes it.
bool rests(const ParticleView& particles, std::size_t i)
{
    const ParticleCoupling& own = particles.coupling[i];
    return own.response_time > 0 && particles.velocity.col(static_cast<Eigen::Index>(i)).isZero(0) &&
           to_vector(own.start_velocity).isZero(0);
}

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
      watch_(solids.gravity().norm()),
      stress_model_(solids.solid_stress()),
      voidage_(gas.mesh().size(), 1.0),
      solid_volume_(gas.mesh().size(), 0.0),
      hold_(gas.mesh().size()),
      demand_(gas.mesh().size()),
      widest_(
          (comm.max(Vector(gas.locator().bounds().col(1))) - comm.min(Vector(gas.locator().bounds().col(0)))).norm())
{
    if (stress_model_) stress_.emplace(comm_, gas_, mapping_, *stress_model_);
}

std::size_t CouplingStep::visitor_width() const
{
    return (settings_.two_way ? two_way_record : one_way_record) + (stress_ ? momentum_record : 0);
}

std::size_t CouplingStep::homeward_width() const { return homeward_record + (stress_ ? StressExchange::width : 0); }

void CouplingStep::advance(double dt, int substeps)
{
    solid_step_ = dt / substeps;
    kicks_again_ = substeps == 1 && solids_.takes_new_forces();
    // The share of other forces that drag gives back is half of this ratio, or nothing where contacts hold.
    constexpr double long_ratio = 0.02;
    long_step_ = fastest_relaxation_ * dt > long_ratio;
    transactions_ = {};
    if (particle_count_ < 0) inspect_start();
    bring_particles_to_their_cells();
    map_voidage();
    map_solid_stress();
    note_crossing(dt);
    if (settings_.two_way) judge_contacts();
    map_drag(dt);
    solve_gas(dt);
    return_gas_to_particles(dt);
    refuse_impossible_flight();
    move_particles(substeps);
    book();
    if (settings_.two_way) watch(dt);
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
    starts_.resize(n);
    std::size_t r = 0;
    for (const std::size_t i : visits_.order()) {
        const auto column = static_cast<Eigen::Index>(i);
        put(&records_[r + position], particles.position.col(column));
        starts_[i] = starting_velocity(particles, i);
        put(&records_[r + velocity], starts_[i]);
        if (particles.weight[i] != weight) {
            weight = particles.weight[i];
            per_real = 1.0 / std::cbrt(weight);
        }
        records_[r + diameter] = 2 * particles.radius[column] * per_real;
        records_[r + volume] = sphere_volume(particles.radius[column]);
        records_[r + mass] = particles.mass[column];
        if (settings_.two_way) pack_for_two_way(particles, i, &records_[r]);
        r += width;
        if (stress_) {
            const Vector v = kicks_again_ ? starts_[i] : particles.velocity.col(column);
            put(&records_[r - momentum_record], particles.mass[column] * v);
            records_[r - 1] = particles.mass[column];
        }
    }
    visits_.bring(records_, static_cast<int>(width), visitors_);
}

void CouplingStep::pack_for_two_way(const ParticleView& particles, std::size_t i, double* record) const
{
    const auto column = static_cast<Eigen::Index>(i);
    const ParticleCoupling& own = particles.coupling[i];
    const double m = particles.mass[column];
    const Vector taken = solid_step_ * particles.booked_force(i) - impulse_to_take_back(particles, i);
    put(record + pending, taken - to_vector(own.assumed_impulse));
    if (!long_step_) return;       // nobody asks
    if (own.response_time <= 0) {  // new to the gas: what acts on it now beside gravity are contacts
        const Vector pull = m * solids_.gravity();
        put(record + by_contacts, solid_step_ * (particles.force.col(column) - pull));
        put(record + without_contacts, solid_step_ * pull);
        record[weight] = solid_step_ * pull.norm();
        return;
    }
    const Vector expected = to_vector(own.free_change);
    const Vector change = to_vector(record + velocity) - to_vector(own.start_velocity);
    put(record + by_contacts, m * (change - expected));
    put(record + without_contacts, m * expected);
    record[weight] = m * own.response_time * solids_.gravity().norm();
}

Vector CouplingStep::starting_velocity(const ParticleView& particles, std::size_t i) const
{
    const auto column = static_cast<Eigen::Index>(i);
    const Vector v = particles.velocity.col(column);
    if (!solids_.kicks_before_moving() || rests(particles, i)) return v;
    if (kicks_again_ && particles.coupling[i].response_time <= 0) return v;  // no step has kicked it yet
    const Vector half_kick = 0.5 * solid_step_ / particles.mass[column] * particles.force.col(column);
    return kicks_again_ ? Vector(v - half_kick) : Vector(v + half_kick);
}

Vector CouplingStep::impulse_to_take_back(const ParticleView& particles, std::size_t i) const
{
    if (!kicks_again_ || rests(particles, i)) return Vector::Zero();
    const Vector force = particles.force.col(static_cast<Eigen::Index>(i));
    return solid_step_ * particles.fluid[i].part_of(force, starts_[i]);
}

void CouplingStep::kick_again(const ParticleView& particles, std::size_t i, const Vector& velocity,
                              const Vector& others)
{
    Vector force = others;
    particles.fluid[i].apply(force.data(), velocity.data(), particles.booked + 3 * i);
    const double half = 0.5 * solid_step_ / particles.mass[static_cast<Eigen::Index>(i)];
    solids_.kick_again(i, velocity + half * force, force);
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

    transactions_.solid_volume_in_cells = sum(solid_volume_);
    transactions_.solid_volume_of_particles = sum(volumes_);
}

void CouplingStep::map_solid_stress()
{
    if (!stress_) return;
    const std::size_t width = visitor_width();
    Scalars momenta(momentum_record * visits_.visitors());
    for (std::size_t i = 0; i < visits_.visitors(); ++i)
        std::copy_n(&visitors_[(i + 1) * width - momentum_record], momentum_record, &momenta[i * momentum_record]);
    stress_->compute(solid_volume_, momenta);
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
    transactions_.gas_in = crossing.in;
    transactions_.gas_out = crossing.out;
    transactions_.gas_volume = sum(gas_volume_);
}

void CouplingStep::return_gas_to_particles(double dt)
{
    stopwatch_.switch_to(Phase::mapping);
    const Scalars gas_velocity = gas_.velocity();
    const Scalars& gradient = pressure_gradient_ = gas_.pressure_gradient();
    if (settings_.two_way)
        for (std::size_t c = 0; c < voidage_.size(); ++c) {
            const double volume = gas_.mesh().volume[c];
            const Vector drag = demand_.rate[c] * vector_at(gas_velocity, 3 * c) - vector_at(demand_.source, 3 * c);
            const double pressed = solid_volume_[c] - volume * demand_.following[c];
            transactions_.given_by_gas += dt * (volume * drag - pressed * vector_at(gradient, 3 * c));
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
        put(answer + 7,
            settings_.two_way ? assumed_impulse(i, to_vector(answer + 1), to_vector(answer + 4), dt) : Vector::Zero());
        if (stress_) stress_->write_answer(i, visits_.cells()[i], answer + homeward_record);
    }

    stopwatch_.switch_to(Phase::exchange);
    visits_.take_back(answers_, static_cast<int>(width), fluid_);
    const ParticleView particles = solids_.particles();
    const Vector gravity = solids_.gravity();
    assumed_at_start_.setZero();
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (!homes_[i].known()) leave_without_gas(particles, i);
    std::size_t f = 0;
    for (const std::size_t i : visits_.order()) {
        const auto column = static_cast<Eigen::Index>(i);
        const double m = particles.mass[column];
        const Vector& v = starts_[i];
        const Vector u = vector_at(fluid_, f + 1);
        ParticleCoupling& own = particles.coupling[i];

        const double k = fluid_[f];
        const Vector pressure_force = -sphere_volume(particles.radius[column]) * vector_at(fluid_, f + 4);
        const Vector assumed = vector_at(fluid_, f + 7);
        const bool again = kicks_again_ && !rests(particles, i);
        const Vector total = particles.force.col(column);
        const Vector others = again ? Vector(total - particles.fluid[i].part_of(total, v)) : total;
        if (again) transactions_.taken_by_particles -= impulse_to_take_back(particles, i);

        particles.fluid[i] = FluidForce(m, k, u, pressure_force, solid_step_);
        std::fill_n(particles.booked + 3 * i, 3, 0.0);
        if (again) kick_again(particles, i, v, others);
        set(own.assumed_impulse, assumed);
        set(own.start_velocity, v);
        const double time = response_time(m, k, dt);
        set(own.free_change, free_change(m, k, u - v, gravity + pressure_force / m, time));
        own.response_time = static_cast<float>(time);
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
    own.response_time = 0;
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
        if (stress_) {
            const double m = particles.mass[static_cast<Eigen::Index>(i)];
            const Vector force = stress_->returned_by_drag(i, m, solid_step_) / solid_step_;
            Eigen::Map<Vector>(particles.booked + 3 * i) += force;
        }
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
            {comm_.sum(too_long_.crossing_cells), comm_.sum(too_long_.beyond_relaxation)},
            watch_.counts()};
}

std::size_t CouplingStep::doubles_sent() const
{
    return homes_search_.doubles_sent() + visits_.doubles_sent() + mapping_.doubles_sent();
}

}  // namespace interphase
