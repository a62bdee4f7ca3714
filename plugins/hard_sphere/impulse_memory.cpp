// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/impulse_memory.hpp"

#include <algorithm>

namespace interphase::hard_sphere {

namespace {

// LIGGGHTS's buffer has room for 1000 numbers more than it asks for. What is left out starts from nothing.
constexpr int most_packed = 200;

}  // namespace

const Remembered* ImpulseMemory::find(int particle, int partner) const
{
    const Span span = spans_[static_cast<std::size_t>(particle)];
    const Remembered* first = entries_.data() + span.first;
    for (const Remembered* entry = first; entry != first + span.count; ++entry)
        if (entry->partner == partner) return entry;
    return nullptr;
}

void ImpulseMemory::reset(const std::vector<int>& particles, const std::vector<int>& counts)
{
    std::fill(spans_.begin(), spans_.end(), Span{});
    int first = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
        if (counts[k] > 0) spans_[static_cast<std::size_t>(particles[k])] = {first, 0};
        first += counts[k];
    }
    entries_.resize(static_cast<std::size_t>(first));
}

void ImpulseMemory::add(int particle, const Remembered& entry)
{
    Span& span = spans_[static_cast<std::size_t>(particle)];
    entries_[static_cast<std::size_t>(span.first + span.count++)] = entry;
}

int ImpulseMemory::pack(int particle, double* buffer) const
{
    const Span span = spans_[static_cast<std::size_t>(particle)];
    const int count = std::min(span.count, most_packed);
    double* next = buffer;
    *next++ = count;
    for (int k = span.first; k < span.first + count; ++k) {
        const Remembered& entry = entries_[static_cast<std::size_t>(k)];
        *next++ = entry.partner;
        next = std::copy_n(entry.impulse, 3, next);
    }
    return static_cast<int>(next - buffer);
}

int ImpulseMemory::unpack(int particle, const double* buffer)
{
    const double* next = buffer;
    const int count = static_cast<int>(*next++);
    spans_[static_cast<std::size_t>(particle)] = {static_cast<int>(entries_.size()), count};
    for (int k = 0; k < count; ++k) {
        Remembered entry{static_cast<int>(*next++), {}};
        for (float& component : entry.impulse)
            component = static_cast<float>(*next++);
        entries_.push_back(entry);
    }
    return static_cast<int>(next - buffer);
}

}  // namespace interphase::hard_sphere
