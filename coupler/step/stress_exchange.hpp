// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"
#include "mapping/mapping.hpp"
#include "plugin/solid_stress.hpp"
#include "step/gas.hpp"
#include "step/messages.hpp"

namespace interphase {

/// What the solids' stress adds to a coupling step: particles -> mean velocity per cell, solid fraction -> stress and
/// its gradient (mesh), all of it -> particles, with the weights of everything else.
class StressExchange {
public:
    StressExchange(const Communicator& comm, Gas& gas, const Mapping& mapping, SolidStress& model)
        : comm_(comm), gas_(gas), mapping_(mapping), model_(model)
    {}

    /// `solid_volume` [own cells, m3], within the mapping's packing limit; `momenta` of the visitors [n]. After
    /// mapping.solid_volume(). Throws a UserError in the first call if a cell is beyond close packing and the model
    /// refuses that. Collective.
    void compute(const Scalars& solid_volume, const std::vector<Momentum>& momenta);

    /// What visitors whose owner cells are `cells` [n] take home [n].
    void answer(const std::vector<int>& cells, std::vector<StressAnswer>& answers) const;

    /// Hands the answers, arrived in the order `order` of the rank's particles, to the model. Throws a UserError if it
    /// complains of the gas step. Collective.
    void begin(const std::vector<Answer>& answers, const std::vector<StressAnswer>& of_stress,
               const std::vector<std::size_t>& order, const ScalarsView& mass, double gas_step);

    /// What drag gave back of the stress's impulse on particle i of the rank in the last gas step, of solid steps of
    /// `solid_step` [s]: an impulse of the fluid [kg m/s].
    Vector returned_by_drag(std::size_t i, double mass, double solid_step) const;

    /// Of this rank: cells beyond close packing, cell by cell, particles for which the gas step was too long, particle
    /// by particle, step by step.
    std::vector<Count> counts() const;
    /// The gas step that no particle of any rank would have found too long in the last one [s].
    double longest_step() const { return step_too_long_.longest; }

    void keep(Archive& archive)
    {
        archive.keep("started", started_);
        archive.keep_share("cells_overpacked", cells_overpacked_);
        archive.keep_share("crossing_cells", step_too_long_.crossing_cells);
        archive.keep_share("beyond_relaxation", step_too_long_.beyond_relaxation);
        archive.keep("longest_step", step_too_long_.longest);
    }

private:
    void look_for_overpacked_cells(const Scalars& solid_volume);
    void add_closing_speeds(const Scalars& fractions, const Scalars& flow, std::vector<StressHere>& cells) const;

    Communicator comm_;
    Gas& gas_;
    const Mapping& mapping_;
    SolidStress& model_;
    std::vector<StressHere> at_visitors_;
    bool started_ = false;
    long cells_overpacked_ = 0;
    StepTooLong step_too_long_;
};

}  // namespace interphase
