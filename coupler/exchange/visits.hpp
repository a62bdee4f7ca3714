// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "exchange/cell_locator.hpp"
#include "exchange/sparse_exchange.hpp"

namespace interphase {

/// Takes particle data to the ranks that own the particles' gas cells, and answers back. Particles whose cell is on
/// their own rank send nothing.
class Visits {
public:
    explicit Visits(const Communicator& comm) : comm_(comm), exchange_(comm) {}

    /// Plans the visits of this rank's particles to `homes` [n]; particles without a home stay away. Collective.
    void plan(const std::vector<CellAddress>& homes);

    /// The cell of each visitor on this rank [visitors()].
    const std::vector<int>& cells() const { return cells_; }
    std::size_t visitors() const { return cells_.size(); }

    /// Records of `width` doubles per particle, in this rank's order of particles, to the hosts' `of_visitors`.
    void bring(const Scalars& of_particles, int width, Scalars& of_visitors);

    /// Records of `width` doubles per visitor back to `of_particles`; zero for those that stayed away.
    void take_back(const Scalars& of_visitors, int width, Scalars& of_particles);

    std::size_t doubles_sent() const { return exchange_.doubles_sent(); }

private:
    Communicator comm_;
    SparseExchange exchange_;
    std::vector<std::size_t> order_;  ///< the particle of each record sent
    std::vector<int> cells_;
    std::size_t particles_ = 0;
    Scalars buffer_;
};

}  // namespace interphase
