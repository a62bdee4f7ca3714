// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/step_watch.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "step/step_counts.hpp"

namespace interphase {

namespace {

/// As ranks tell each other of it.
struct Sighting {
    double value;
    double where[3];
    double id;
};

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
    Largest largest;
    for (const Sighting& of_rank :
         comm.all_gather(Sighting{mine.value, mine.where[0], mine.where[1], mine.where[2], mine.id}))
        largest.see(of_rank.value, to_vector(of_rank.where), of_rank.id);
    return largest;
}

/// Sums over all ranks, and largest values.
struct Totals {
    double mass, energy;
    double solids, crowded;  ///< solid volume of the cells; weighted with the solid fraction
    double momentum[3], gradient[3];
};
struct Extremes {
    double gas_speed2, crossing, wave_crossing, relaxation;
};

}  // namespace

StepWatch::StepWatch(const Communicator& comm, const Gas& gas, Solids& solids)
    : comm_(comm),
      gas_(gas),
      solids_(solids),
      watch_(solids.gravity().norm()),
      widest_(
          (comm.max(Vector(gas.locator().bounds().col(1))) - comm.min(Vector(gas.locator().bounds().col(0)))).norm())
{}

void StepWatch::note_crossing(const Visitors& visitors, double dt)
{
    crossing_ = 0;
    for (std::size_t i = 0; i < visitors.size(); ++i) {
        const double(&v)[3] = visitors.visitor[i].velocity;
        const Vector& extent = gas_.mesh().extent[static_cast<std::size_t>(visitors.cell[i])];
        for (int axis = 0; axis < 3; ++axis)
            if (dt * std::abs(v[axis]) > crossing_ * extent[axis]) crossing_ = dt * std::abs(v[axis]) / extent[axis];
    }
}

StepState StepWatch::state_of_step(InterphaseForces& forces, const Scalars& voidage, const Scalars& solid_volume,
                                   double dt)
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
    const Scalars& pressure_gradient = forces.pressure_gradient();
    double gas_speed2 = 0, solids = 0, crowded = 0;
    Vector gradient = Vector::Zero();
    for (std::size_t c = 0; c < voidage.size(); ++c) {
        const Vector here = vector_at(pressure_gradient, c);
        gas_speed2 = std::max(gas_speed2, vector_at(gas_velocity, c).squaredNorm());
        if (solid_volume[c] <= 0) continue;
        solids += solid_volume[c];
        crowded += solid_volume[c] * (1 - voidage[c]);
        gradient += solid_volume[c] * here;
        steepest.see(here.squaredNorm(), gas_.mesh().centre[c]);
    }

    Totals all{particles.mass.sum(), energy, solids, crowded, {}, {}};
    set(all.momentum, momentum);
    set(all.gradient, gradient);
    comm_.sum(all);
    const double mass = all.mass, all_solids = all.solids;
    state.mass = mass;
    state.kinetic_energy = all.energy;
    if (mass > 0) state.mean_velocity = to_vector(all.momentum) / mass;
    if (all_solids > 0) {
        constexpr double thin = 0.1;  // see StepState::weight_gradient
        state.mean_pressure_gradient = to_vector(all.gradient) / all_solids;
        state.weight_gradient = mass / all_solids * std::max(thin, all.crowded / all_solids) * solids_.gravity().norm();
    }
    const Largest of_cells = of_all(comm_, steepest), of_particles = of_all(comm_, fastest);
    state.highest_pressure_gradient = std::sqrt(of_cells.value);
    state.where = of_cells.where;
    state.fastest = std::sqrt(of_particles.value);
    state.fastest_at = of_particles.where;
    state.fastest_id = static_cast<int>(of_particles.id);
    Extremes most{gas_speed2, crossing_, forces.wave_crossing(), forces.fastest_relaxation()};
    comm_.max(most);
    state.gas_speed = std::sqrt(most.gas_speed2);
    state.largest_crossing = most.crossing;
    state.largest_wave_crossing = most.wave_crossing;
    forces.set_fastest_relaxation(most.relaxation);
    return state;
}

void StepWatch::observe(InterphaseForces& forces, const Scalars& voidage, const Scalars& solid_volume, double dt)
{
    const Finding finding = watch_.observe(state_of_step(forces, voidage, solid_volume, dt));
    if (finding.stability == Stability::hopeless) throw UserError(*finding.problem);
    news_ = finding.message();
}

std::vector<Count> StepWatch::counts() const
{
    const StabilityCounts steps = comm_.is_master() ? watch_.counts() : StabilityCounts{};
    return {{steps_alternating, steps.alternating},
            {steps_accelerating, steps.accelerating},
            {steps_across_cells, steps.crossing},
            {steps_outrun_by_waves, steps.outrun}};
}

void StepWatch::refuse_impossible_flight(double solid_step) const
{
    const ParticleView particles = solids_.particles();
    std::optional<Problem> problem = gas_.trouble();
    for (std::size_t i = 0; i < particles.size() && !problem; ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const Vector v = Vector(particles.velocity.col(column)) + to_vector(particles.coupling[i].free_change);
        if (v.norm() * solid_step < widest_) continue;
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
