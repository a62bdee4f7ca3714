// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/impulse_memory.hpp"

#include <algorithm>

#include "base/vector.hpp"
#include "hard_sphere/messages.hpp"

namespace interphase::hard_sphere {

namespace {

/// An entry on its way to another rank, with what it has beside behind it. How many come stands before them.
struct ImpulseMessage {
    double partner;
    double impulse[3];  ///< [kg m/s]
};
struct ImpulseCount {
    double count;
};

}  // namespace

void ImpulseMemory::forget()
{
    std::fill(first_.begin(), first_.end(), 0);
    entries_.resize(1);
    numbers_.resize(more_);
}

int ImpulseMemory::numbers(int particle) const
{
    int count = 0;
    for (int k = first(particle); k != 0; k = entries_[static_cast<std::size_t>(k)].next)
        ++count;
    return numbers_in<ImpulseCount> + count * (numbers_in<ImpulseMessage> + static_cast<int>(more_));
}

int ImpulseMemory::pack(int particle, double* buffer, int room, int& left_out) const
{
    int told = numbers_in<ImpulseCount>, count = 0;
    const int most = (room - told) / (numbers_in<ImpulseMessage> + static_cast<int>(more_));
    int k = first(particle);
    for (; k != 0 && count < most; ++count) {
        const Remembered& entry = entries_[static_cast<std::size_t>(k)];
        ImpulseMessage message;
        message.partner = entry.partner;
        set(message.impulse, to_vector(entry.impulse));
        told += hard_sphere::pack(message, buffer + told);
        std::copy_n(more(k), more_, buffer + told);
        told += static_cast<int>(more_);
        k = entry.next;
    }
    hard_sphere::pack(ImpulseCount{static_cast<double>(count)}, buffer);
    left_out = 0;
    for (; k != 0; k = entries_[static_cast<std::size_t>(k)].next)
        ++left_out;
    return told;
}

int ImpulseMemory::unpack(int particle, const double* buffer)
{
    ImpulseCount head;
    int read = hard_sphere::unpack(head, buffer);
    forget(particle);
    for (int k = 0; k < static_cast<int>(head.count); ++k) {
        ImpulseMessage message;
        read += hard_sphere::unpack(message, buffer + read);
        Remembered entry{static_cast<int>(message.partner)};
        set(entry.impulse, to_vector(message.impulse));
        add(particle, entry);
        if (more_ == 0) continue;
        float* beside = add_more();
        for (std::size_t m = 0; m < more_; ++m)
            beside[m] = static_cast<float>(buffer[read++]);
    }
    return read;
}

}  // namespace interphase::hard_sphere
