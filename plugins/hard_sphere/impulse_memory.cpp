// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/impulse_memory.hpp"

#include <algorithm>

namespace interphase::hard_sphere {

namespace {

// LIGGGHTS's buffer has room for 1000 numbers more than it asks for. What is left out starts from nothing.
constexpr int most_packed = 200;

}  // namespace

void ImpulseMemory::forget()
{
    std::fill(first_.begin(), first_.end(), 0);
    entries_.resize(1);
}

int ImpulseMemory::pack(int particle, double* buffer) const
{
    double* next = buffer + 1;
    int count = 0;
    for (int k = first(particle); k != 0 && count < most_packed; ++count) {
        const Remembered& entry = entries_[static_cast<std::size_t>(k)];
        *next++ = entry.partner;
        next = std::copy_n(entry.impulse, 3, next);
        k = entry.next;
    }
    *buffer = count;
    return static_cast<int>(next - buffer);
}

int ImpulseMemory::unpack(int particle, const double* buffer)
{
    const double* next = buffer;
    const int count = static_cast<int>(*next++);
    forget(particle);
    for (int k = 0; k < count; ++k) {
        Remembered entry{static_cast<int>(*next++), {}};
        for (float& component : entry.impulse)
            component = static_cast<float>(*next++);
        add(particle, entry);
    }
    return static_cast<int>(next - buffer);
}

}  // namespace interphase::hard_sphere
