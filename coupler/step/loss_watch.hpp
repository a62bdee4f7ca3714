// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "step/solids.hpp"

namespace interphase {

/// Sees particles that get lost in a gas step, and knows which: engines drop them without a word.
class LossWatch {
public:
    explicit LossWatch(const Communicator& comm) : comm_(comm) {}

    /// Before a step. Collective the first time.
    void remember(const ParticleView& particles);

    /// After it: whether there are fewer. Throws a UserError if so, unless the scene removes some on purpose.
    /// Collective.
    bool particles_left(const ParticleView& particles, bool may_be_removed);

    void keep(Archive& archive) { archive.keep("count", count_); }

private:
    void refuse(const ParticleView& particles, long lost) const;

    Communicator comm_;
    long count_ = -1;       ///< of all ranks; below 0: not known
    std::vector<int> ids_;  ///< at the start of the step
    Vectors positions_;     ///< likewise
};

}  // namespace interphase
