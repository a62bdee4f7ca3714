// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/loss_watch.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "base/user_error.hpp"

namespace interphase {

void LossWatch::remember(const ParticleView& particles)
{
    if (count_ < 0) count_ = comm_.sum(static_cast<long>(particles.size()));
    ids_.assign(particles.id, particles.id + particles.size());
    positions_.resize(particles.size());
    for (std::size_t i = 0; i < positions_.size(); ++i)
        positions_[i] = particles.position.col(static_cast<Eigen::Index>(i));
}

bool LossWatch::particles_left(const ParticleView& particles, bool may_be_removed)
{
    const long count = comm_.sum(static_cast<long>(particles.size()));
    const bool fewer = count < count_;
    if (fewer && !may_be_removed) refuse(particles, count_ - count);
    count_ = count;
    return fewer;
}

void LossWatch::refuse(const ParticleView& particles, long lost) const
{
    const std::string how_many =
        std::to_string(lost) + " of " + std::to_string(count_) +
        " particles were lost in this gas step: they were outside the particles' domain and were dropped";
    const std::string remedy =
        "check walls and boundaries in the script, and the solid step; a scene that removes particles "
        "on purpose says so with a fix massflow/mesh ... delete_atoms";

    // Which one: over all ranks, an array as long as the highest id. The run ends here, so that size does not matter.
    const auto highest = std::max_element(ids_.begin(), ids_.end());
    const double last_id = comm_.max(highest == ids_.end() ? 0.0 : *highest);
    Scalars there(static_cast<std::size_t>(last_id) + 1, 0.0);
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (particles.id[i] <= last_id) there[static_cast<std::size_t>(particles.id[i])] = 1;
    comm_.sum(there);
    std::optional<Problem> problem;
    for (std::size_t i = 0; i < ids_.size() && !problem; ++i)
        if (there[static_cast<std::size_t>(ids_[i])] == 0)
            problem = Problem{how_many,
                              "particle " + std::to_string(ids_[i]) + " (rank " + std::to_string(comm_.rank()) +
                                  ") is one of them; it started the step at " + text(positions_[i]),
                              remedy};
    comm_.fail_together(problem);
    throw UserError(how_many, "among particles that the script had just inserted", remedy);
}

}  // namespace interphase
