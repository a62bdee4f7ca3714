// SPDX-License-Identifier: GPL-3.0-or-later
// What the stability watch is told of a coupling step.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "step/coupling_records.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

namespace {

/// The largest of a quantity on this rank, and what goes with it.
struct Largest {
    double value = 0;
    Vector where = Vector::Zero();
    double id = 0;

    void see(double seen, const Vector& at, double of = 0)
    {
        if (!(seen > value)) return;
        value = seen;
        where = at;
        id = of;
    }
};

/// Of all ranks; the lowest rank's where several have it.
Largest of_all(const Communicator& comm, const Largest& mine)
{
    const Scalars all = comm.all_gather({mine.value, mine.where[0], mine.where[1], mine.where[2], mine.id});
    Largest largest;
    for (std::size_t rank = 0; rank < all.size() / 5; ++rank) {
        const double* of_rank = &all[5 * rank];
        largest.see(of_rank[0], to_vector(of_rank + 1), of_rank[4]);
    }
    return largest;
}

}  // namespace

void CouplingStep::note_crossing(double dt)
{
    const std::size_t width = visitor_width();
    crossing_ = 0;
    for (std::size_t i = 0; i < visits_.visitors(); ++i) {
        const double* v = &visitors_[i * width + velocity];
        const Vector& extent = gas_.mesh().extent[static_cast<std::size_t>(visits_.cells()[i])];
        for (int axis = 0; axis < 3; ++axis)
            if (dt * std::abs(v[axis]) > crossing_ * extent[axis]) crossing_ = dt * std::abs(v[axis]) / extent[axis];
    }
}

StepState CouplingStep::state_of_step(double dt)
{
    StepState state;
    state.time = time_ += dt;
    state.duration = dt;

    const ParticleView particles = solids_.particles();
    double energy = 0;
    Vector momentum = Vector::Zero();
    Largest fastest, steepest;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const Vector v = particles.velocity.col(column);
        momentum += particles.mass[column] * v;
        energy += 0.5 * particles.mass[column] * v.squaredNorm();
        fastest.see(v.squaredNorm(), particles.position.col(column), particles.id[i]);
    }

    const Scalars gas_velocity = gas_.velocity();
    double gas_speed2 = 0, solids = 0, crowded = 0;
    Vector gradient = Vector::Zero();
    for (std::size_t c = 0; c < voidage_.size(); ++c) {
        const Vector here = vector_at(pressure_gradient_, 3 * c);
        gas_speed2 = std::max(gas_speed2, vector_at(gas_velocity, 3 * c).squaredNorm());
        if (solid_volume_[c] <= 0) continue;
        solids += solid_volume_[c];
        crowded += solid_volume_[c] * (1 - voidage_[c]);
        gradient += solid_volume_[c] * here;
        steepest.see(here.squaredNorm(), gas_.mesh().centre[c]);
    }

    Scalars sums{particles.mass.sum(), energy, solids, crowded};
    for (const Vector* v : {&momentum, &gradient})
        sums.insert(sums.end(), v->data(), v->data() + 3);
    comm_.sum(sums);
    const double mass = sums[0], all_solids = sums[2];
    state.mass = mass;
    state.kinetic_energy = sums[1];
    if (mass > 0) state.mean_velocity = vector_at(sums, 4) / mass;
    if (all_solids > 0) {
        constexpr double thin = 0.1;  // see StepState::weight_gradient
        state.mean_pressure_gradient = vector_at(sums, 7) / all_solids;
        state.weight_gradient = mass / all_solids * std::max(thin, sums[3] / all_solids) * solids_.gravity().norm();
    }
    const Largest of_cells = of_all(comm_, steepest), of_particles = of_all(comm_, fastest);
    state.highest_pressure_gradient = std::sqrt(of_cells.value);
    state.where = of_cells.where;
    state.fastest = std::sqrt(of_particles.value);
    state.fastest_at = of_particles.where;
    state.fastest_id = static_cast<int>(of_particles.id);
    Scalars most{gas_speed2, crossing_, wave_crossing_, fastest_relaxation_};
    comm_.max(most);
    state.gas_speed = std::sqrt(most[0]);
    state.largest_crossing = most[1];
    state.largest_wave_crossing = most[2];
    fastest_relaxation_ = most[3];
    return state;
}

void CouplingStep::watch(double dt)
{
    const Finding finding = watch_.observe(state_of_step(dt));
    if (finding.stability == Stability::hopeless) throw UserError(*finding.problem);
    news_ = finding.message();
}

void CouplingStep::refuse_impossible_flight() const
{
    const ParticleView particles = solids_.particles();
    std::optional<Problem> problem = gas_.trouble();
    for (std::size_t i = 0; i < particles.size() && !problem; ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const Vector v = Vector(particles.velocity.col(column)) + to_vector(particles.coupling[i].free_change);
        if (v.norm() * solid_step_ < widest_) continue;
        problem = Problem{
            "the gas would make particle " + std::to_string(particles.id[i]) + " (rank " +
                std::to_string(comm_.rank()) + ") as fast as " + text(v.norm()) +
                " m/s, so that it crosses the whole mesh in one solid step",
            "at " + text(Vector(particles.position.col(column))),
            "the run diverges: reduce deltaT (or maxCo) in system/controlDict; look at the last written fields"};
    }
    comm_.fail_together(problem);
}

}  // namespace interphase
