// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/point_particles.hpp"

#include <algorithm>
#include <cmath>

namespace interphase::test {

PointParticles::PointParticles(const Communicator& comm, const std::vector<Particle>& mine, const Vector& gravity,
                               double solid_step, SolidStress* stress)
    : comm_(comm), gravity_(gravity), solid_step_(solid_step), stress_(stress)
{
    for (const Particle& particle : mine)
        append(particle);
}

void PointParticles::append(const Particle& p)
{
    const std::size_t i = size();
    for (auto* field : {&position_, &velocity_, &spin_, &force_, &fluid_force_}) {
        field->conservativeResize(3, column(i + 1));
        field->col(column(i)).setZero();
    }
    for (auto* field : {&radius_, &mass_, &weight_})
        field->conservativeResize(column(i + 1));
    position_.col(column(i)) = p.position;
    velocity_.col(column(i)) = p.velocity;
    radius_[column(i)] = 0.5 * p.diameter;
    mass_[column(i)] = p.density * M_PI / 6 * p.diameter * p.diameter * p.diameter;
    weight_[column(i)] = p.weight;
    if (!p.held) force_.col(column(i)) = mass_[column(i)] * gravity_;  // as LIGGGHTS's set-up leaves it
    id_.push_back(p.id);
    type_.push_back(1);
    held_.push_back(p.held);
    fluid_.emplace_back();
    booked_.resize(3 * size(), 0.0);
    coupling_.emplace_back();
}

ParticleView PointParticles::particles()
{
    const auto n = static_cast<Eigen::Index>(size());
    const auto vectors = [n](const Eigen::Matrix3Xd& field) { return VectorsView(field.data(), 3, n); };
    return {vectors(position_),
            vectors(velocity_),
            vectors(spin_),
            vectors(force_),
            ScalarsView(radius_.data(), n),
            ScalarsView(mass_.data(), n),
            ParticleWeights::of_each(weight_.data()),
            id_.data(),
            type_.data(),
            fluid_.data(),
            booked_.data(),
            coupling_.data()};
}

void PointParticles::add_forces(std::size_t i)
{
    const auto c = column(i);
    Vector others = mass_[c] * gravity_;
    if (held_[i]) {
        // the contact force with which the fluid force of FluidForce::apply leaves no force at all
        Vector fluid = Vector::Zero(), unit = Vector::Ones(), booked = Vector::Zero();
        fluid_[i].apply(fluid.data(), velocity_.col(c).data(), booked.data());
        fluid_[i].apply(unit.data(), velocity_.col(c).data(), booked.data());
        others = -fluid.cwiseQuotient(unit - fluid);
    }
    force_.col(c) = others;
    fluid_[i].apply(force_.col(c).data(), velocity_.col(c).data(), &booked_[3 * i]);
    fluid_force_.col(c) = force_.col(c) - others;
    if (held_[i]) impulse_on_held_ += solid_step_ * fluid_force_.col(c);
}

void PointParticles::advance(int substeps)
{
    departures_.clear();
    arrivals_.clear();
    std::vector<int> made;
    for (const Particle& particle : coming_) {
        append(particle);
        made.push_back(particle.id);
    }
    const auto was_made = [&made](int id) { return std::find(made.begin(), made.end(), id) != made.end(); };
    coming_.clear();
    for (int step = 0; step < substeps; ++step)
        for (std::size_t i = 0; i < size(); ++i) {
            const auto c = column(i);
            const double half_kick = 0.5 * solid_step_ / mass_[c];
            if (!held_[i]) {
                velocity_.col(c) += half_kick * force_.col(c);
                position_.col(c) += solid_step_ * velocity_.col(c);
            }
            add_forces(i);
            if (!held_[i]) velocity_.col(c) += half_kick * force_.col(c);
        }
    for (std::size_t i = 0; i < size(); ++i) {
        if (id_[i] != broken_) continue;
        velocity_(1, column(i)) = std::nan("");
        if (breaks_position_) position_(2, column(i)) = std::nan("");
    }
    for (std::size_t i = size(); i-- > 0;)
        if (id_[i] == doomed_) {
            if (may_remove_) departures_.push_back(departure_of(i));
            if (may_remove_) departures_.back().is_new = was_made(id_[i]);
            erase(i);
        }
    for (std::size_t i = 0; i < size(); ++i)
        if (was_made(id_[i])) arrivals_.push_back(i);
}

Departure PointParticles::departure_of(std::size_t i) const
{
    Departure departure{};
    departure.exit = exit_;
    departure.id = id_[i];
    set(departure.position, position_.col(column(i)));
    set(departure.velocity, velocity_.col(column(i)));
    departure.mass = mass_[column(i)];
    departure.radius = radius_[column(i)];
    set(departure.booked, Eigen::Map<const Vector>(&booked_[3 * i]));
    departure.coupling = coupling_[i];
    return departure;
}

void PointParticles::erase(std::size_t i)
{
    const std::size_t last = size() - 1;
    for (auto* field : {&position_, &velocity_, &spin_, &force_, &fluid_force_}) {
        field->col(column(i)) = field->col(column(last)).eval();
        field->conservativeResize(3, column(last));
    }
    for (auto* field : {&radius_, &mass_, &weight_}) {
        (*field)[column(i)] = (*field)[column(last)];
        field->conservativeResize(column(last));
    }
    for (std::size_t k = 0; k < 3; ++k)
        booked_[3 * i + k] = booked_[3 * last + k];
    id_[i] = id_[last];
    held_[i] = held_[last];
    fluid_[i] = fluid_[last];
    coupling_[i] = coupling_[last];
    id_.pop_back();
    type_.pop_back();
    held_.pop_back();
    fluid_.pop_back();
    coupling_.pop_back();
    booked_.resize(3 * last);
}

Vector PointParticles::momentum() const
{
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < size(); ++i)
        if (!held_[i])
            sum += mass_[column(i)] * velocity_.col(column(i)) + 0.5 * solid_step_ * fluid_force_.col(column(i));
    return comm_.sum(sum);
}

Vector PointParticles::pending() const
{
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < size(); ++i)
        sum += solid_step_ * Eigen::Map<const Vector>(&booked_[3 * i]) - to_vector(coupling_[i].assumed_impulse);
    return comm_.sum(sum);
}

}  // namespace interphase::test
