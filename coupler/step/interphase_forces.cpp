// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/interphase_forces.hpp"

#include <algorithm>
#include <cmath>

#include "forces/drag/kinematic_wave.hpp"
#include "forces/pressure_gradient/pressure_gradient.hpp"
#include "forces/self_disturbance/self_disturbance.hpp"

namespace interphase {

InterphaseForces::InterphaseForces(const Settings& settings, Gas& gas, const Mapping& mapping, const Vector& gravity)
    : settings_(settings),
      gas_(gas),
      mapping_(mapping),
      gravity_(gravity),
      terms_(make_terms(settings.forces)),
      drag_(*find_drag_law(settings.drag_law)),
      hold_(gas.mesh().size())
{
    for (const double volume : gas.mesh().volume)
        cell_size_.push_back(std::cbrt(volume));
    terms_.insert(terms_.begin(), std::make_unique<PressureGradient>());
    needs_ = drag_.needs();
    for (const auto& term : terms_)
        needs_ |= term->needs();
}

bool InterphaseForces::is_long(double duration) const
{
    // The share of other forces that drag gives back is half of this ratio, or nothing where contacts hold.
    constexpr double long_ratio = 0.02;
    return fastest_relaxation_ * duration > long_ratio;
}

void InterphaseForces::judge_contacts(const Visitors& visitors)
{
    if (!step_.is_long) {
        std::fill(hold_.begin(), hold_.end(), Hold{});
        return;
    }
    const std::vector<Restraint> of_cells = mapping_.deposit(visitors.restraint);
    for (std::size_t c = 0; c < hold_.size(); ++c)
        hold_[c].judge(to_vector(of_cells[c].by_contacts), to_vector(of_cells[c].without_contacts), of_cells[c].weight);
}

void InterphaseForces::look_at_gas(const Visitors& visitors, const Scalars& voidage)
{
    const std::size_t cells = voidage.size();
    const Scalars gas_velocity = gas_.velocity();
    std::vector<GasHere> here(cells);
    for (std::size_t c = 0; c < cells; ++c) {
        here[c].voidage = voidage[c];
        set(here[c].velocity, vector_at(gas_velocity, c));
    }
    mapping_.interpolate(std::move(here), here_);

    first_step_ = pressure_gradient_.empty();
    if (first_step_) pressure_gradient_ = gas_.pressure_gradient();
    if (step_.is_long) {
        std::vector<LastStepHere> last_step(cells);
        for (std::size_t c = 0; c < cells; ++c) {
            last_step[c].held = hold_[c].held;
            last_step[c].doubt = hold_[c].doubt;
            set(last_step[c].pressure_gradient, vector_at(pressure_gradient_, c));
        }
        mapping_.interpolate(std::move(last_step), last_step_);
    }

    const GasProperty density = gas_.density(), viscosity = gas_.viscosity();
    if (density.varies() || viscosity.varies()) {
        std::vector<PropertiesHere> properties(cells);
        for (std::size_t c = 0; c < cells; ++c)
            properties[c] = {density.in(c), viscosity.in(c)};
        mapping_.interpolate(std::move(properties), properties_);
    } else
        properties_.assign(1, {density.uniform, viscosity.uniform});

    if (needs_.velocity_gradient) {
        const Scalars flat = gas_.velocity_gradient();
        std::vector<GradientHere> gradients(cells);
        for (std::size_t c = 0; c < cells; ++c)
            std::copy_n(&flat[9 * c], 9, gradients[c].of_velocity);
        mapping_.interpolate(std::move(gradients), gradients_);
    }
    if (needs_.viscous_force) {
        const Scalars flat = gas_.viscous_force();
        std::vector<ViscousForceHere> forces(cells);
        for (std::size_t c = 0; c < cells; ++c)
            set(forces[c].force, vector_at(flat, c));
        mapping_.interpolate(std::move(forces), viscous_forces_);
    }
    if (needs_.mean_diameter) look_at_sizes(visitors);
}

void InterphaseForces::look_at_sizes(const Visitors& visitors)
{
    struct Sizes {
        double volume, surface;  ///< of the real particles; the latter over 6
    };
    std::vector<Sizes> sizes(visitors.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const Visitor& visitor = visitors.visitor[i];
        sizes[i] = {visitor.volume, visitor.volume / visitor.diameter};
    }
    const std::vector<Sizes> of_cells = mapping_.deposit(sizes);
    Scalars diameters(of_cells.size(), 0.0);  // no particle sees a cell without any
    for (std::size_t c = 0; c < of_cells.size(); ++c)
        if (of_cells[c].surface > 0) diameters[c] = of_cells[c].volume / of_cells[c].surface;
    mapping_.interpolate(std::move(diameters), mean_diameters_);
}

void InterphaseForces::look_at(const Visitors& visitors, std::size_t i, ParticleInGas& at) const
{
    const Visitor& visitor = visitors.visitor[i];
    at.velocity = to_vector(visitor.velocity);
    at.diameter = visitor.diameter;
    at.volume = visitor.volume;
    at.mass = visitor.mass;
    const auto cell = static_cast<std::size_t>(visitors.cell[i]);
    at.cell_extent = gas_.mesh().extent[cell];
    at.cell_volume = gas_.mesh().volume[cell];
    at.cell_size = cell_size_[cell];
    if (needs_.mean_diameter) at.mean_diameter = mean_diameters_[i];

    at.voidage = here_[i].voidage;
    at.gas_velocity = to_vector(here_[i].velocity);
    const PropertiesHere& gas = properties_[properties_.size() > 1 ? i : 0];
    at.density = gas.density;
    at.viscosity = gas.viscosity;
    if (step_.is_long) {
        at.held = first_step_ ? 0.0 : last_step_[i].held;
        at.pressure_gradient = to_vector(last_step_[i].pressure_gradient);
    }
    if (needs_.velocity_gradient)
        at.velocity_gradient =
            Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(gradients_[i].of_velocity);
    if (needs_.viscous_force) at.viscous_force = to_vector(viscous_forces_[i].force);

    at.kernel_volume = {};
    if (settings_.two_way && settings_.self_disturbance && SelfDisturbance::may_matter(at))
        at.kernel_volume =
            mapping_.kernel_volume(to_vector(visitor.position), visitors.cell[i], visitor.volume, at.velocity);
}

void InterphaseForces::ask(const Visitors& visitors, const Scalars& voidage, const Step& step, Demand& demand)
{
    step_ = step;
    if (settings_.two_way) judge_contacts(visitors);
    look_at_gas(visitors, voidage);

    wave_crossing_ = 0;
    fastest_relaxation_ = settings_.two_way ? 0.0 : DBL_MAX;  // one-way, ranks do not tell each other
    responses_.assign(visitors.size(), Response{});
    reactions_.resize(settings_.two_way ? visitors.size() : 0);
    ParticleInGas particle;
    particle.gravity = gravity_;
    particle.duration = step_.duration;
    for (std::size_t i = 0; i < visitors.size(); ++i) {
        look_at(visitors, i, particle);
        Response& response = responses_[i];
        for (const auto& term : terms_)
            term->act(particle, response);
        drag_.act(particle, response);
        if (!settings_.two_way) continue;
        fastest_relaxation_ = std::max(fastest_relaxation_, response.rate / particle.mass);
        note_wave(particle, response);
        if (step_.is_long) particle.held = last_step_[i].held;
        reactions_[i] = reaction_of(particle, response, step_.is_long ? last_step_[i].doubt : 0.0,
                                    to_vector(visitors.owed[i].impulse), step_.motion);
    }
    if (settings_.two_way) sum_over_cells(demand);
}

void InterphaseForces::note_wave(const ParticleInGas& at, const Response& response)
{
    // Waves are kinematic in steps beyond one relaxation time, and there are none in a bed at rest.
    constexpr double at_rest = 0.5;
    if (!(response.rate * at.duration > at.mass && at.held < at_rest)) return;
    const Vector slip = at.slip();
    if (!(slip.norm() > 0)) return;
    const auto rate_at = [&](double voidage, double speed) { return drag_.rate_at(at, voidage, speed); };
    const Vector wave = kinematic_wave_speed(rate_at, at.voidage, slip.norm()) * slip.normalized();
    const Vector crossed = at.duration * wave.cwiseQuotient(at.cell_extent);
    wave_crossing_ = std::max(wave_crossing_, crossed.cwiseAbs().maxCoeff());
}

void InterphaseForces::sum_over_cells(Demand& demand) const
{
    const std::vector<Reaction> of_cells = mapping_.deposit(reactions_);
    for (std::size_t c = 0; c < of_cells.size(); ++c) {
        const Reaction& sum = of_cells[c];
        const double per_volume = 1.0 / gas_.mesh().volume[c];
        demand.rate[c] = sum.rate * per_volume;
        set_vector_at(demand.source, c, per_volume * to_vector(sum.source));
        demand.following[c] = sum.following * per_volume;
        demand.moving[c] = sum.moving * per_volume;
        demand.mobility[c] = sum.mobility * per_volume;
        set_vector_at(demand.flux, c, per_volume * to_vector(sum.flux));
    }
}

void InterphaseForces::answer(const Visitors& visitors, std::vector<Answer>& answers,
                              std::vector<AddedMass>& added_masses)
{
    gas_velocity_ = gas_.velocity();
    pressure_gradient_ = gas_.pressure_gradient();
    std::vector<SolvedHere> solved(hold_.size());
    for (std::size_t c = 0; c < solved.size(); ++c) {
        set(solved[c].velocity, vector_at(gas_velocity_, c));
        set(solved[c].pressure_gradient, vector_at(pressure_gradient_, c));
    }
    mapping_.interpolate(std::move(solved), solved_);

    answers.resize(visitors.size());
    added_masses.resize(needs_.added_mass ? visitors.size() : 0);
    for (std::size_t i = 0; i < visitors.size(); ++i) {
        const Response& response = responses_[i];
        const Vector u = to_vector(solved_[i].velocity), gradient = to_vector(solved_[i].pressure_gradient);
        Vector force = -response.pressed_volume * gradient + response.force;
        if (response.gas_mass > 0) force += response.gas_mass / step_.duration * (u - to_vector(here_[i].velocity));
        Vector assumed = Vector::Zero();
        if (settings_.two_way)
            assumed = assumed_impulse(reactions_[i], visitors.visitor[i].volume, to_vector(visitors.owed[i].impulse), u,
                                      gradient, step_.duration);
        Answer& answer = answers[i];
        answer.drag_rate = response.rate;
        set(answer.gas_velocity, u);
        set(answer.force, force);
        set(answer.assumed_impulse, assumed);
        if (needs_.added_mass) added_masses[i].mass = response.added_mass;
    }
}

Vector InterphaseForces::given_by_gas(const Scalars& solid_volume, const Demand& demand) const
{
    Vector given = Vector::Zero();
    for (std::size_t c = 0; c < solid_volume.size(); ++c) {
        const double volume = gas_.mesh().volume[c];
        const Vector drag = demand.rate[c] * vector_at(gas_velocity_, c) - vector_at(demand.source, c);
        const double pressed = solid_volume[c] - volume * demand.following[c];
        given += step_.duration * (volume * drag - pressed * vector_at(pressure_gradient_, c));
    }
    return given;
}

std::vector<Count> InterphaseForces::counts() const
{
    std::vector<Count> all = drag_.counts();
    for (const auto& term : terms_)
        for (const Count& count : term->counts())
            all.push_back(count);
    return all;
}

void InterphaseForces::keep(Archive& archive)
{
    archive.keep_cells("hold", hold_);
    archive.keep_cells("pressure_gradient", pressure_gradient_);
    archive.keep("fastest_relaxation", fastest_relaxation_);
    archive.keep("drag", drag_);
    for (std::size_t i = 0; i < terms_.size(); ++i)
        archive.keep("term" + std::to_string(i), *terms_[i]);
}

}  // namespace interphase
