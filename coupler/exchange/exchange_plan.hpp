// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/communicator.hpp"
#include "exchange/message.hpp"

namespace interphase {

/// Point-to-point transfer of records between the ranks that have something for each other: an exchange plan.
///
/// The plan takes one exchange of counts (one integer per pair of ranks); after it every message has a known size and
/// only ranks with records to share send any. Records to oneself are copied, not sent.
class ExchangePlan {
public:
    explicit ExchangePlan(const Communicator& comm) : comm_(comm) {}

    /// Plans for `send_counts[r]` records to rank r. Collective.
    void plan(const std::vector<int>& send_counts);

    /// Whether every planned record of this rank is for itself, and none comes from another.
    bool stays_home() const;

    std::size_t sent() const { return sent_; }
    std::size_t received() const { return received_; }

    /// Sends a message's records, ordered by receiving rank; they arrive ordered by sender.
    void forward(const Message& message) const { transfer(message, send_, receive_, received_); }

    /// The way back: one record for each that arrived, returned to where it came from, in the order of forward()'s.
    void backward(const Message& message) const { transfer(message, receive_, send_, sent_); }

    template <class Record>
    std::vector<Record> forward(std::vector<Record> out) const
    {
        std::vector<Record> in;
        forward(Message(out, in));
        return in;
    }

    template <class Record>
    std::vector<Record> backward(std::vector<Record> out) const
    {
        std::vector<Record> in;
        backward(Message(out, in));
        return in;
    }

    /// Bytes that this rank has sent to others so far, over all exchanges of this object.
    std::size_t bytes_sent() const { return bytes_sent_; }

private:
    struct Part {
        int rank;
        std::size_t first;
        std::size_t count;
    };

    void transfer(const Message& message, const std::vector<Part>& to, const std::vector<Part>& from,
                  std::size_t arriving) const;

    Communicator comm_;
    std::vector<Part> send_;
    std::vector<Part> receive_;
    std::size_t sent_ = 0;
    std::size_t received_ = 0;
    mutable std::size_t bytes_sent_ = 0;
};

}  // namespace interphase
