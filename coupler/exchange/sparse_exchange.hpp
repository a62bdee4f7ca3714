// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/communicator.hpp"

namespace interphase {

/// Point-to-point transfer of records of doubles between the ranks that have something for each other.
///
/// The plan takes one exchange of counts (one integer per pair of ranks); after it every message has a known size and
/// only ranks with records to share send any. Records to oneself are copied, not sent.
class SparseExchange {
public:
    explicit SparseExchange(const Communicator& comm) : comm_(comm) {}

    /// Plans for `send_counts[r]` records to rank r. Collective.
    void plan(const std::vector<int>& send_counts);

    /// Whether every planned record of this rank is for itself, and none comes from another.
    bool stays_home() const;

    std::size_t sent() const { return sent_; }
    std::size_t received() const { return received_; }

    /// Sends `out` (records of `width` doubles, ordered by receiving rank); `in` gets what arrived, ordered by sender.
    void forward(const Scalars& out, int width, Scalars& in) const
    {
        transfer(out, width, send_, receive_, received_, in);
    }

    /// The way back: one record for each that arrived, returned to where it came from, in the order of forward()'s
    /// `out`.
    void backward(const Scalars& out, int width, Scalars& in) const
    {
        transfer(out, width, receive_, send_, sent_, in);
    }

    Scalars forward(const Scalars& out, int width) const
    {
        Scalars in;
        forward(out, width, in);
        return in;
    }

    Scalars backward(const Scalars& out, int width) const
    {
        Scalars in;
        backward(out, width, in);
        return in;
    }

    /// Doubles that this rank has sent to others so far, over all exchanges of this object.
    std::size_t doubles_sent() const { return doubles_sent_; }

private:
    struct Part {
        int rank;
        std::size_t first;
        std::size_t count;
    };

    void transfer(const Scalars& out, int width, const std::vector<Part>& to, const std::vector<Part>& from,
                  std::size_t arriving, Scalars& in) const;

    Communicator comm_;
    std::vector<Part> send_;
    std::vector<Part> receive_;
    std::size_t sent_ = 0;
    std::size_t received_ = 0;
    mutable std::size_t doubles_sent_ = 0;
};

}  // namespace interphase
