// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace interphase {

/// A number that changes with the place or the type of any of these members of a class, data or virtual functions
/// (whose place is that in the table of virtual functions). Same compiler and C++ ABI taken for granted: it mixes the
/// bytes of the pointers to members and the names that the compiler has for their types (FNV-1a, 64 bits).
template <class... Members>
std::int64_t fingerprint_of(Members... members)
{
    std::uint64_t mixed = 14695981039346656037u;
    const auto mix = [&](const void* bytes, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k)
            mixed = (mixed ^ static_cast<const unsigned char*>(bytes)[k]) * 1099511628211u;
    };
    (mix(&members, sizeof members), ...);
    mix(__PRETTY_FUNCTION__, sizeof __PRETTY_FUNCTION__);
    return static_cast<std::int64_t>(mixed);
}

}  // namespace interphase
