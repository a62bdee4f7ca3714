// SPDX-License-Identifier: GPL-3.0-or-later
// What a particle brings to the gas, and what it takes home.
#include <algorithm>

#include "momentum/drag_response.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

namespace {

/// Whether it rests where it rested a gas step ago: then nobody moves it, whatever pushes it.
bool rests(const ParticleView& particles, std::size_t i)
{
    const ParticleCoupling& own = particles.coupling[i];
    return own.response_time > 0 && particles.velocity.col(static_cast<Eigen::Index>(i)).isZero(0) &&
           to_vector(own.start_velocity).isZero(0);
}

}  // namespace

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

Owed CouplingStep::owed_to(const ParticleView& particles, std::size_t i) const
{
    const Vector taken = solid_step_ * particles.booked_force(i) - impulse_to_take_back(particles, i);
    Owed owed;
    set(owed.impulse, taken - to_vector(particles.coupling[i].assumed_impulse));
    return owed;
}

Restraint CouplingStep::restraint_of(const ParticleView& particles, std::size_t i) const
{
    const auto column = static_cast<Eigen::Index>(i);
    const ParticleCoupling& own = particles.coupling[i];
    const double m = particles.mass[column];
    Restraint restraint;
    if (own.response_time <= 0) {  // new to the gas: what acts on it now beside gravity are contacts
        const Vector pull = m * solids_.gravity();
        set(restraint.by_contacts, solid_step_ * (particles.force.col(column) - pull));
        set(restraint.without_contacts, solid_step_ * pull);
        restraint.weight = solid_step_ * pull.norm();
        return restraint;
    }
    const Vector expected = to_vector(own.free_change);
    const Vector change = starts_[i] - to_vector(own.start_velocity);
    set(restraint.by_contacts, m * (change - expected));
    set(restraint.without_contacts, m * expected);
    restraint.weight = m * own.response_time * solids_.gravity().norm();
    return restraint;
}

void CouplingStep::kick_again(const ParticleView& particles, std::size_t i, const Vector& velocity,
                              const Vector& others)
{
    Vector force = others;
    particles.fluid[i].apply(force.data(), velocity.data(), particles.booked + 3 * i);
    const double half = 0.5 * solid_step_ / particles.mass[static_cast<Eigen::Index>(i)];
    solids_.kick_again(i, velocity + half * force, force);
}

void CouplingStep::take_home(const ParticleView& particles, std::size_t i, const Answer& answer, double added_mass,
                             double dt)
{
    const auto column = static_cast<Eigen::Index>(i);
    const double m = particles.mass[column], k = answer.drag_rate;
    const Vector &v = starts_[i], u = to_vector(answer.gas_velocity), force = to_vector(answer.force);
    const Vector assumed = to_vector(answer.assumed_impulse);
    const bool again = kicks_again_ && !rests(particles, i);
    const Vector total = particles.force.col(column);
    const Vector others = again ? Vector(total - particles.fluid[i].part_of(total, v)) : total;
    if (again) ledger_.momentum.step.taken_by_particles -= impulse_to_take_back(particles, i);

    particles.fluid[i] = FluidForce(m, k, u, force, solid_step_, added_mass);
    std::fill_n(particles.booked + 3 * i, 3, 0.0);
    if (again) kick_again(particles, i, v, others);

    ParticleCoupling& own = particles.coupling[i];
    set(own.assumed_impulse, assumed);
    set(own.start_velocity, v);
    const double time = response_time(m, k, dt, added_mass);
    set(own.free_change, free_change(m, k, u - v, solids_.gravity() + force / m, time));
    own.response_time = static_cast<float>(time);
}

void CouplingStep::leave_without_gas(const ParticleView& particles, std::size_t i)
{
    ParticleCoupling& own = particles.coupling[i];
    particles.fluid[i] = FluidForce{};
    // what the gas still owes for its last step with gas stays on the books until it comes back, or leaves for good
    set(own.assumed_impulse, to_vector(own.assumed_impulse) - solid_step_ * particles.booked_force(i));
    std::fill_n(particles.booked + 3 * i, 3, 0.0);
    own.response_time = 0;
    own.was_outside = true;
}

}  // namespace interphase
