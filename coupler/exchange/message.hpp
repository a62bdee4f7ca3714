// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace interphase {

/// Records of several kinds that travel together: one of each kind for every item, all kinds in one message to a rank.
/// A kind is a trivially copyable struct and travels as its bytes; an optional one is there because somebody asked for
/// it. The vectors are named, not copied, and have to outlive the message.
class Message {
public:
    Message() = default;

    template <class Record>
    Message(std::vector<Record>& out, std::vector<Record>& in)
    {
        add(out, in);
    }

    /// Records of one kind: `out` in the order that a ExchangePlan's plan says; `in` gets those that arrive.
    template <class Record>
    Message& add(std::vector<Record>& out, std::vector<Record>& in)
    {
        static_assert(std::is_trivially_copyable_v<Record>);
        blocks_.push_back(
            {sizeof(Record),
             [&out, &in](std::size_t arriving) {
                 in.resize(arriving);
                 return Ends{reinterpret_cast<const char*>(out.data()), reinterpret_cast<char*>(in.data())};
             },
             [&out, &in] { in.swap(out); }});
        return *this;
    }

    /// What arrives is what was sent: without copying.
    void swap_ends() const
    {
        for (const Block& block : blocks_)
            block.swap_ends();
    }

    struct Ends {
        const char* out;
        char* in;
    };
    struct Block {
        std::size_t size;                             ///< of a record [bytes]
        std::function<Ends(std::size_t)> make_ready;  ///< for so many records
        std::function<void()> swap_ends;
    };
    const std::vector<Block>& blocks() const { return blocks_; }

private:
    std::vector<Block> blocks_;
};

}  // namespace interphase
