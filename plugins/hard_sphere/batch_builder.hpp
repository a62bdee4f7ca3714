// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hard_sphere/contact_batch.hpp"

namespace interphase::hard_sphere {

/// Where a contact went.
struct BatchPlace {
    std::size_t batch;
    int lane;
};

/// Gathers contacts in batches whose members share no body, roughly in the order in which they come: each goes to one
/// of a few open batches that has neither of its bodies, and a full batch is closed. The order matters: sweeping
/// through a bed from below to above carries a load through all of it in one pass.
class BatchBuilder {
public:
    void start(std::size_t bodies)
    {
        used_.assign(bodies, 0);
        open_.fill({});
        count_ = 0;
    }

    /// `fixed_i`, `fixed_j`: bodies that nothing moves may come in a batch more than once.
    BatchPlace place(int i, int j, bool fixed_i, bool fixed_j);

    /// Number of batches so far; in the last ones some lanes may be empty.
    std::size_t count() const { return count_; }

private:
    static constexpr int open_batches = 8;  ///< with more, contacts come too far out of order for beds to rest soon
    static constexpr std::uint32_t all = (std::uint64_t{1} << open_batches) - 1;
    struct Open {
        std::size_t batch = 0;
        int filled = 0;
        std::array<int, 2 * lanes> bodies{};  ///< of its members
    };
    void close(int slot);

    std::vector<std::uint32_t> used_;  ///< a bit for each open batch that has the body
    std::array<Open, open_batches> open_;
    std::size_t count_ = 0;
};

}  // namespace interphase::hard_sphere
