// SPDX-License-Identifier: GPL-3.0-or-later
// What the particles ask of the gas: their drag, how they will answer it, and how they will move.
#include <algorithm>
#include <cmath>

#include "momentum/drag_response.hpp"
#include "momentum/kinematic_wave.hpp"
#include "momentum/rate_over_step.hpp"
#include "step/coupling_records.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

void CouplingStep::judge_contacts()
{
    if (!long_step_) {
        std::fill(hold_.begin(), hold_.end(), Hold{});
        return;
    }
    const std::size_t width = visitor_width();
    Scalars changes(held_record * visits_.visitors());
    for (std::size_t i = 0; i < visits_.visitors(); ++i)
        std::copy_n(&visitors_[i * width + by_contacts], held_record, &changes[i * held_record]);
    const Scalars sums = mapping_.to_cells(changes, held_record);
    for (std::size_t c = 0; c < hold_.size(); ++c) {
        const double* of_cell = &sums[c * held_record];
        hold_[c].judge(to_vector(of_cell), to_vector(of_cell + 3), of_cell[6]);
    }
}

void CouplingStep::map_drag(double dt)
{
    const std::size_t width = visitor_width(), seen_width = long_step_ ? seen_in_long_steps : seen_record;
    const Scalars gas_velocity = gas_.velocity();
    const bool first_step = pressure_gradient_.empty();
    if (first_step) pressure_gradient_ = gas_.pressure_gradient();
    Scalars seen_by_cells(seen_width * voidage_.size());
    for (std::size_t c = 0; c < voidage_.size(); ++c) {
        double* seen = &seen_by_cells[seen_width * c];
        seen[0] = voidage_[c];
        std::copy_n(&gas_velocity[3 * c], 3, seen + 1);
        if (!long_step_) continue;
        seen[4] = hold_[c].held;
        seen[5] = hold_[c].doubt;
        put(seen + 6, vector_at(pressure_gradient_, 3 * c));
    }
    mapping_.to_particles(seen_by_cells, seen_width, seen_);

    const Vector gravity = solids_.gravity();
    const double density = gas_.density(), viscosity = gas_.viscosity();
    drag_rates_.resize(visits_.visitors());
    wave_crossing_ = 0;
    fastest_relaxation_ = settings_.two_way ? 0.0 : DBL_MAX;  // one-way, ranks do not tell each other
    demands_.resize(settings_.two_way ? demand_record * visits_.visitors() : 0);
    for (std::size_t i = 0; i < visits_.visitors(); ++i) {
        const double* record = &visitors_[i * width];
        const GasSeen seen(&seen_[seen_width * i], long_step_);
        const double eps = seen.voidage, d = record[diameter], held = first_step ? 0.0 : seen.held;
        const Vector slip = seen.velocity - to_vector(record + velocity);
        const double reynolds = eps * density * slip.norm() * d / viscosity;
        beyond_range_ += eps < law_.voidage_min || eps > law_.voidage_max || reynolds > law_.reynolds_max;
        const auto rate_at = [&](double voidage, double slip_speed) {
            return record[volume] * drag_rate_per_volume(law_, voidage, slip_speed, d, density, viscosity);
        };
        const auto rate_of = [&](double slip_speed) { return rate_at(eps, slip_speed); };
        Vector acceleration = gravity;
        if (long_step_) acceleration -= record[volume] / record[mass] * seen.pressure_gradient;
        drag_rates_[i] = rate_over_step(rate_of, slip, record[mass], (1 - held) * acceleration, dt);
        if (!settings_.two_way) continue;
        fastest_relaxation_ = std::max(fastest_relaxation_, drag_rates_[i] / record[mass]);
        // Waves are kinematic in steps beyond one relaxation time, and there are none in a bed at rest.
        constexpr double at_rest = 0.5;
        if (drag_rates_[i] * dt > record[mass] && held < at_rest && slip.norm() > 0) {
            const Vector wave = kinematic_wave_speed(rate_at, eps, slip.norm()) * slip.normalized();
            const Vector& extent = gas_.mesh().extent[static_cast<std::size_t>(visits_.cells()[i])];
            wave_crossing_ = std::max(wave_crossing_, dt * wave.cwiseQuotient(extent).cwiseAbs().maxCoeff());
        }
        write_demand(record, drag_rates_[i], seen, dt, &demands_[demand_record * i]);
    }
    if (settings_.two_way) map_demands(dt);
}

void CouplingStep::write_demand(const double* record, double drag_rate, const GasSeen& seen, double dt,
                                double* demand) const
{
    const Vector v = to_vector(record + velocity), g = solids_.gravity();
    const AssumedDrag drag = assume_drag(record[mass], drag_rate, seen.held, g, dt);
    const double stiff = stiffening(drag_rate, record[mass], seen.doubt, dt);
    const double following = drag.following * record[volume];
    const double per_rate = drag_rate > 0 ? 1.0 / drag_rate : 0.0;
    demand[0] = drag.kappa + stiff;
    // the part of the force that does not wait for the gas solve
    put(demand + 1, drag.kappa * v + stiff * seen.velocity + (drag.carried - to_vector(record + pending)) / dt);
    demand[4] = following;
    // solids that begin with the new forces move through the whole step at the velocity of its end
    const double moving =
        kicks_again_ ? -(1 - seen.held) * std::expm1(-drag_rate * dt / record[mass]) * record[volume] : following;
    demand[5] = moving;
    demand[6] = moving * record[volume] * per_rate;
    put(demand + 7, (record[volume] - moving) * v + moving * record[mass] * per_rate * g);
}

Vector CouplingStep::assumed_impulse(std::size_t visitor, const Vector& gas_velocity, const Vector& pressure_gradient,
                                     double dt) const
{
    const double *record = &visitors_[visitor_width() * visitor], *demand = &demands_[demand_record * visitor];
    const Vector drag = dt * (demand[0] * gas_velocity - to_vector(demand + 1)) - to_vector(record + pending);
    return drag - dt * (record[volume] - demand[4]) * pressure_gradient;
}

void CouplingStep::map_demands(double dt)
{
    const Scalars contents = mapping_.to_cells(demands_, demand_record);
    if (gas_volume_.empty())
        for (std::size_t c = 0; c < voidage_.size(); ++c)
            gas_volume_.push_back(voidage_[c] * gas_.mesh().volume[c]);
    for (std::size_t c = 0; c < voidage_.size(); ++c) {
        const double* content = &contents[demand_record * c];
        const double volume = gas_.mesh().volume[c], per_volume = 1.0 / volume;
        demand_.rate[c] = content[0] * per_volume;
        put(&demand_.source[3 * c], per_volume * to_vector(content + 1));
        demand_.following[c] = content[4] * per_volume;
        demand_.moving[c] = content[5] * per_volume;
        demand_.mobility[c] = content[6] * per_volume;
        put(&demand_.flux[3 * c], per_volume * to_vector(content + 7));
        demand_.gas_share[c] = gas_volume_[c] * per_volume;
        demand_.surplus[c] = (demand_.gas_share[c] - voidage_[c]) / dt;
    }
}

}  // namespace interphase
