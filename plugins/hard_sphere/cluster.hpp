// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hard_sphere/batch_builder.hpp"
#include "hard_sphere/contact_batch.hpp"

namespace interphase::hard_sphere {

/// Contacts that are solved for together, in batches. The vectors only grow; the builder knows what is in use.
struct Cluster {
    BatchBuilder places;
    std::vector<ContactBatch> batches;
    std::vector<BatchNotes> notes;
    std::vector<RollingBatch> rolling;  ///< none where the law does not resist rolling
    bool rolls = false;                 ///< it does
    std::vector<float> states;          ///< of the contacts [batches x state_count x lanes]
    int state_count = 0;                ///< numbers of each

    /// Makes room for batch `k`.
    void reach(std::size_t k)
    {
        if (k < batches.size()) return;
        batches.resize(2 * k + 64);
        notes.resize(batches.size());
        if (rolls) rolling.resize(batches.size());
        if (state_count > 0) states.resize(batches.size() * static_cast<std::size_t>(state_count * lanes));
    }

    /// Number `s` of the states of batch `k`. [lanes]
    float* state(std::size_t k, int s)
    {
        return &states[(k * static_cast<std::size_t>(state_count) + static_cast<std::size_t>(s)) * lanes];
    }
    const float* state(std::size_t k, int s) const
    {
        return &states[(k * static_cast<std::size_t>(state_count) + static_cast<std::size_t>(s)) * lanes];
    }

    RollingBatch* rolling_of(std::size_t k) { return rolls ? &rolling[k] : nullptr; }
    const RollingBatch* rolling_of(std::size_t k) const { return rolls ? &rolling[k] : nullptr; }
};

}  // namespace interphase::hard_sphere
