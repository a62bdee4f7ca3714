// SPDX-License-Identifier: GPL-3.0-or-later
// What a run settles before it starts: the solid step, and scenes that it refuses.
#include <algorithm>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "run/coupled_run.hpp"
#include "step/particle_trouble.hpp"

namespace interphase {

LockstepClock CoupledRun::choose_clock() const
{
    if (settings_.solid_step > 0) {
        check_given_step();
        return LockstepClock(settings_.solid_step);
    }
    const double longest = std::min(longest_solid_step(), solids_->step_limit().value_or(1e300));
    const double gas_step = case_.gas_step();
    return LockstepClock(case_.adjusts_gas_step() ? std::min(longest, gas_step) : dividing_step(gas_step, longest));
}

void CoupledRun::check_given_step() const
{
    const std::optional<double> contact = solids_->contact_duration(), limit = solids_->step_limit();
    const double step = settings_.solid_step;
    constexpr double slack = 1 + 1e-9;
    constexpr double least_steps = 10;  // per collision; 10 to 60 are usual (paper, section 4.6)
    if (settings_.method.resolves_contacts && contact && step > *contact / least_steps * slack)
        throw UserError("the solid step of " + text(step) +
                            " s is too long for the contact model: its shortest "
                            "collision lasts t_c = " +
                            text(*contact) + " s",
                        "system/couplingDict.particles, solidStep",
                        "give at most t_c/" + text(least_steps) + " = " + text(*contact / least_steps) +
                            " s (t_c/20 is a good start), or make the contacts softer");
    constexpr double largest_share = 0.4;  // 0.2 in dense, 0.4 in loose packings are usual
    const std::optional<double> rayleigh = solids_->rayleigh_time();
    if (settings_.method.resolves_contacts && rayleigh && step > largest_share * *rayleigh * slack)
        throw UserError(
            "the solid step of " + text(step) + " s is " + text(100 * step / *rayleigh) + " % of Rayleigh's time of " +
                text(*rayleigh) + " s, of the sphere that an elastic wave crosses first",
            "system/couplingDict.particles, solidStep",
            "give at most 40 % of it, " + text(largest_share * *rayleigh) +
                " s (20 % is a good start: " + text(0.2 * *rayleigh) + " s), or a lower youngsModulus in the script");
    if (limit && step > *limit * slack)
        throw UserError("the solid step of " + text(step) + " s is longer than the " + text(*limit) +
                            " s that a fix of the plug-ins bears",
                        "system/couplingDict.particles, solidStep", "give at most that, or leave solidStep away");
    if (step > case_.gas_step() * slack)
        throw UserError(
            "the solid step of " + text(step) + " s is longer than the gas step of " + text(case_.gas_step()) + " s",
            "solidStep in system/couplingDict, deltaT in system/controlDict", "make deltaT a multiple of it");
}

double CoupledRun::longest_solid_step() const
{
    // eq. 28 of the paper: no longer than a gas step; what else it asks for is counted in every step
    if (!settings_.method.single_collisions) return case_.gas_step();
    if (settings_.largest_overlap > 0)
        return settings_.largest_overlap * solids_->smallest_diameter() / settings_.impact_speed;
    if (const std::optional<double> contact = solids_->contact_duration())
        return *contact / settings_.steps_per_collision;
    if (const std::optional<double> limit = solids_->step_limit()) return *limit;
    const std::optional<double> rayleigh = solids_->rayleigh_time();
    const std::string hint = rayleigh ? ", say " + text(0.2 * *rayleigh) + ", 20 % of Rayleigh's time"
                                      : std::string(" (known: pair gran model hooke/stiffness)");
    if (settings_.method.resolves_contacts)
        throw UserError("the contact model gives no collision time to derive the solid step from",
                        "system/couplingDict.particles", "give `solidStep` in seconds" + hint);
    throw UserError(
        "the script gives no stiffness and restitution to derive the solid step from", "system/couplingDict.particles",
        "give `largestOverlap 0.01; impactSpeed 0.3;` with numbers of your scene, or `solidStep` in seconds, or "
        "in the script fixes property/global kn and coefficientRestitution of a DEM with such overlaps");
}

void CoupledRun::refuse_empty_scene() const
{
    if (at_start_.tracked == 0 && solids_->radii_to_come().empty())
        throw UserError("there are no particles, and none are to be inserted", settings_.script,
                        "create or read some in the script, or insert them during the run (fix insert/*)");
}

void CoupledRun::check_weights() const
{
    const ParticleView particles = solids_->particles();
    comm_.fail_together(particle_trouble(particles, comm_.rank()));
    for (const double weight : solids_->weights_to_come())
        if (!(weight >= 1) || (weight > 1 && !settings_.method.tracks_parcels))
            throw UserError("the script inserts particles with a weight of " + text(weight) +
                                (weight > 1 ? ", and method " + settings_.method.name + " tracks real particles"
                                            : ": at least 1 real particle is in a tracked one"),
                            settings_.script + ", `set_property weight` of a fix insert/*",
                            weight > 1 ? or_with_parcels("give it the weight 1", settings_.method)
                                       : "give it a weight of 1 or more");
    if (!particles.weight.differ()) return;
    const std::string where = settings_.script + ", fix property/atom weight", method = settings_.method.name;
    if (!settings_.method.tracks_parcels && at_start_.highest_weight > 1)
        throw UserError("the script gives particles weights up to " + text(at_start_.highest_weight) + ", and method " +
                            method + " tracks real particles",
                        where, or_with_parcels("leave the property away", settings_.method));
    bool used = settings_.weight == 1 || at_start_.tracked == 0;
    for (std::size_t i = 0; i < particles.size() && !used; ++i)
        used = particles.weight[i] == settings_.weight;
    if (!comm_.any(used))
        throw UserError("the case says `weight " + text(settings_.weight) + ";`, and the script gives its particles " +
                            weights_of(at_start_),
                        "system/couplingDict, and " + where,
                        "set `weight 1;` where the script decides, or take ${weight} in it");
}

void CoupledRun::check_scene() const
{
    if (!gas_ || settings_.mapping.type == MappingType::kernel) return;
    if (settings_.two_way && solids_->solid_stress())
        throw UserError(
            "a stress of the solids and `type cellCentre;` do not go together: single cells fill and empty as "
            "parcels hop across their faces, and the gas of a nearly full cell answers with jets (parcels of "
            "18 m/s after 0.15 s in cases/goldschmidt)",
            "system/couplingDict.mapping", "set `type kernel;`");
    const double diameter = solids_->largest_diameter();
    double smallest = 1e300;
    for (const Vector& extent : gas_->mesh().extent)
        smallest = std::min(smallest, extent.minCoeff());
    smallest = comm_.min(smallest);
    if (smallest < diameter)
        throw UserError("the smallest gas cell measures " + text(smallest) + " m, less than a tracked sphere of " +
                            text(diameter) + " m, which `type cellCentre;` puts into one cell",
                        "system/couplingDict.mapping", "set `type kernel;`, or use a coarser mesh");
}

}  // namespace interphase
