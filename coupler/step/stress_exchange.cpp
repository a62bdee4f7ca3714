// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stress_exchange.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "base/text.hpp"
#include "momentum/drag_response.hpp"
#include "momentum/particle_coupling.hpp"
#include "step/step_counts.hpp"

namespace interphase {

void StressExchange::compute(const Scalars& solid_volume, const std::vector<Momentum>& momenta)
{
    look_for_overpacked_cells(solid_volume);
    const MeshView& mesh = gas_.mesh();
    Scalars stress(mesh.size());
    for (std::size_t c = 0; c < mesh.size(); ++c)
        stress[c] = model_.stress(solid_volume[c] / mesh.volume[c]);
    const Scalars stress_gradient = gas_.gradient(stress);
    const std::vector<Momentum> of_solids = mapping_.deposit(momenta);

    std::vector<StressHere> cells(mesh.size(), StressHere{});
    Scalars fractions(mesh.size()), flow(3 * mesh.size());
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        StressHere& cell = cells[c];
        set(cell.gradient, vector_at(stress_gradient, c));
        cell.solid_fraction = fractions[c] = solid_volume[c] / mesh.volume[c];
        for (std::size_t axis = 0; axis < 3; ++axis) {  // no particle sees a cell without mass
            if (of_solids[c].mass > 0) cell.mean_velocity[axis] = of_solids[c].momentum[axis] / of_solids[c].mass;
            flow[3 * c + axis] = fractions[c] * cell.mean_velocity[axis];
        }
    }
    add_closing_speeds(fractions, flow, cells);
    mapping_.interpolate(std::move(cells), at_visitors_);
}

void StressExchange::add_closing_speeds(const Scalars& fractions, const Scalars& flow,
                                        std::vector<StressHere>& cells) const
{
    // phi du/dx = d(phi u)/dx - u dphi/dx: so a cell without solids, whose velocity says nothing, takes no part, and a
    // wall does, where the flow stops.
    const MeshView& mesh = gas_.mesh();
    const Scalars of_flow = gas_.stretching(flow), of_fraction = gas_.gradient(fractions);
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        if (fractions[c] <= 0) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double extent = mesh.extent[c][static_cast<Eigen::Index>(axis)];
            const double of_flow_here = of_flow[3 * c + axis], of_fraction_here = of_fraction[3 * c + axis];
            // a few particles beside a pack are not thrown by it: the pack's share counts for no more than itself
            const double share = fractions[c] + extent * std::abs(of_fraction_here);
            const double stretching = (of_flow_here - cells[c].mean_velocity[axis] * of_fraction_here) / share;
            cells[c].closing_speed[axis] = std::max(0.0, -stretching * extent);
        }
    }
}

void StressExchange::look_for_overpacked_cells(const Scalars& solid_volume)
{
    constexpr double slack = 1 + 1e-9;
    const MeshView& mesh = gas_.mesh();
    std::size_t fullest = 0;
    double highest = 0;
    long beyond = 0;
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        const double phi = solid_volume[c] / mesh.volume[c];
        beyond += phi > model_.close_packing() * slack;
        if (phi > highest) {
            highest = phi;
            fullest = c;
        }
    }
    cells_overpacked_ += beyond;
    if (started_) return;
    started_ = true;
    std::optional<Problem> problem;
    if (beyond > 0 && model_.refuses_overfilled_start())
        problem =
            Problem{"the particles fill " + std::to_string(beyond) + " gas cells (rank " +
                        std::to_string(comm_.rank()) + ") beyond close packing at the start: a solid fraction of " +
                        text(highest) + ", where " + text(model_.close_packing()) + " is the limit",
                    "in the cell at " + text(mesh.centre[fullest]),
                    "start from a looser packing, make the parcels lighter (weight) or the cells larger, or "
                    "give the fix `overfilled count` to let the stress spread them"};
    comm_.fail_together(problem);
}

void StressExchange::answer(const std::vector<int>& cells, std::vector<StressAnswer>& answers) const
{
    answers.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        answers[i].here = at_visitors_[i];
        set(answers[i].cell_size, gas_.mesh().extent[static_cast<std::size_t>(cells[i])]);
    }
}

void StressExchange::begin(const std::vector<Answer>& answers, const std::vector<StressAnswer>& of_stress,
                           const std::vector<std::size_t>& order, const ScalarsView& mass, double gas_step)
{
    StressState* states = model_.states();
    std::fill_n(states, mass.size(), StressState{});  // what is in no gas cell feels no stress
    for (std::size_t n = 0; n < order.size(); ++n) {
        const std::size_t i = order[n];
        const double m = mass[static_cast<Eigen::Index>(i)], drag_rate = answers[n].drag_rate;
        const StressHere& here = of_stress[n].here;
        StressState& state = states[i];
        std::copy_n(here.gradient, 3, state.gradient);
        state.solid_fraction = here.solid_fraction;
        std::copy_n(here.mean_velocity, 3, state.mean_velocity);
        std::copy_n(here.closing_speed, 3, state.closing_speed);
        std::copy_n(of_stress[n].cell_size, 3, state.cell_size);
        state.relaxation_time = drag_rate > 0 ? m / drag_rate : DBL_MAX;
    }
    const StepTooLong found = model_.begin(gas_step);
    const char* complaint = model_.complaint();
    comm_.fail_together(complaint ? std::optional(Problem{complaint, "", ""}) : std::nullopt);
    step_too_long_.crossing_cells += found.crossing_cells;
    step_too_long_.beyond_relaxation += found.beyond_relaxation;
    step_too_long_.longest = comm_.min(found.longest);
}

std::vector<Count> StressExchange::counts() const
{
    return {{cells_beyond_close_packing, cells_overpacked_},
            {step_crosses_cells, step_too_long_.crossing_cells},
            {step_beyond_relaxation, step_too_long_.beyond_relaxation}};
}

Vector StressExchange::returned_by_drag(std::size_t i, double mass, double solid_step) const
{
    const StressState& state = model_.states()[i];
    if (!(state.relaxation_time > 0 && state.relaxation_time < DBL_MAX)) return Vector::Zero();
    // a constant force changes the velocity by its relaxed share: that is what the model gave, and this the rest of it
    const auto [relaxed, withheld] = shares(solid_step / state.relaxation_time);
    return -withheld / relaxed * mass * to_vector(state.change);
}

}  // namespace interphase
