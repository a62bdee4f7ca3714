// SPDX-License-Identifier: GPL-3.0-or-later
// What a coupling step counts, and what the counts are parts of.
#include <cmath>

#include "step/coupling_step.hpp"
#include "step/step_counts.hpp"

namespace interphase {

std::vector<Count> CouplingStep::counts() const
{
    std::vector<Count> all{{cells_relieved, relieved_},
                           {particles_outside_mesh, outside_},
                           {centres_beyond_edge, beyond_edge_},
                           {cells_pushed, pushed_},
                           outlets_.count()};
    const auto add = [&all](const std::vector<Count>& more) { all.insert(all.end(), more.begin(), more.end()); };
    add(forces_.counts());
    if (settings_.two_way) add(watch_.counts());
    if (stress_) add(stress_->counts());

    Scalars numbers;
    for (const Count& count : all)
        numbers.insert(numbers.end(), {static_cast<double>(count.number), count.off});
    comm_.sum(numbers);
    for (std::size_t n = 0; n < all.size(); ++n) {
        all[n].number = std::lround(numbers[2 * n]);
        all[n].off = numbers[2 * n + 1];
    }
    return all;
}

Wholes CouplingStep::wholes() const
{
    Wholes all = population_.wholes();
    all.cell_steps = cells_ * all.gas_steps;
    return all;
}

}  // namespace interphase
