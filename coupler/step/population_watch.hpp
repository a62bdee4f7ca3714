// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"
#include "settings/settings.hpp"
#include "step/population_totals.hpp"
#include "step/solids.hpp"

namespace interphase {

/// Counts particles that come and go, by identity and by cause, and sees those that get lost: engines drop them without
/// a word.
class PopulationWatch {
public:
    PopulationWatch(const Communicator& comm, const Settings& settings);

    /// Before a step. Collective the first time.
    void remember(const ParticleView& particles);

    /// After it. Throws a UserError where a particle is missing that did not leave by a way that the scene allows, or
    /// one of a weight came that the method does not track. Collective.
    void book(Solids& solids);

    /// Of this rank.
    PopulationTotals& totals() { return totals_; }
    /// Of all ranks, once a step has ended: summed once, however often it is asked for. Collective.
    const PopulationTotals& of_all_ranks() const;

    /// Gas steps that were booked, and the particles in each of them, on all ranks.
    const Wholes& wholes() const { return wholes_; }

    void keep(Archive& archive)
    {
        archive.keep("count", count_);
        archive.keep("gas_steps", wholes_.gas_steps);
        archive.keep("particle_steps", wholes_.particle_steps);
        archive.keep_share("totals", totals_);
        if (archive.loads()) summed_.reset();
    }

private:
    void add_departures(const std::vector<Departure>& departures);
    void add_arrivals(const ParticleView& particles, const std::vector<std::size_t>& arrivals);
    void refuse_boundary(const std::vector<Departure>& departures) const;
    void refuse_parcels(const ParticleView& particles, const std::vector<std::size_t>& arrivals) const;
    void refuse_loss(Solids& solids, long lost) const;

    Communicator comm_;
    const Settings& settings_;
    bool may_leave_through_boundary_;
    PopulationTotals totals_;
    mutable std::optional<PopulationTotals> summed_;  ///< of all ranks, since the last step began
    Wholes wholes_;
    long count_ = -1;       ///< of all ranks; below 0: not known
    std::vector<int> ids_;  ///< at the start of the step
    Vectors positions_;     ///< likewise
};

}  // namespace interphase
