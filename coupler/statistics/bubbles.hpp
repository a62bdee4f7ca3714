// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/communicator.hpp"
#include "exchange/exchange_plan.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// Of all connected regions together, and of the largest.
struct BubbleSizes {
    double number = 0;
    double volume = 0;   ///< of all [m3]
    double largest = 0;  ///< volume [m3]
    double height = 0;   ///< z of the largest one's centroid [m]; NaN where there is none
};

/// Connected regions of gas cells, over all ranks and cyclic sides: two cells belong together that share a face.
/// Labels spread on each rank first, then from rank to rank over the faces that have their other half there; no rank
/// has more than its own cells.
class Bubbles {
public:
    /// Collective; the mesh must stay as it is.
    Bubbles(const Communicator& comm, const MeshView& mesh);

    /// Of the regions of cells [n] for which `inside` holds. Collective.
    BubbleSizes sizes(const std::function<bool(std::size_t)>& inside) const;

private:
    std::vector<std::int64_t> labels(const std::vector<char>& inside) const;

    Communicator comm_;
    const MeshView& mesh_;
    std::vector<std::size_t> halves_;  ///< faces whose other half is elsewhere, in the order of its rank
    ExchangePlan to_other_halves_;
    std::vector<std::int64_t> first_of_rank_;  ///< label of each rank, and one past the last
};

}  // namespace interphase
