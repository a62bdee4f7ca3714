// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/vector.hpp"

namespace interphase {

/// `bins` + 1 ascending edges, evenly spaced [bins + 1].
inline Scalars even_edges(double lowest, double highest, std::size_t bins)
{
    Scalars edges;
    for (std::size_t n = 0; n < bins; ++n)
        edges.push_back(lowest + static_cast<double>(n) * ((highest - lowest) / static_cast<double>(bins)));
    edges.push_back(highest);
    return edges;
}

/// The bin of a value: 0 below the first of ascending `edges`, edges.size() above the last. A value on an edge belongs
/// to the bin above, on the last of several to the bin below it.
inline std::size_t bin_of(double value, const Scalars& edges)
{
    const auto bin = static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), value) - edges.begin());
    return edges.size() > 1 && value == edges.back() ? bin - 1 : bin;
}

}  // namespace interphase
