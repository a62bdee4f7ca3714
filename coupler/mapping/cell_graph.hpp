// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "base/communicator.hpp"
#include "base/numbers.hpp"
#include "exchange/exchange_plan.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// This rank's gas cells and the cells that their faces lead to, on this rank or another (the halo): what a linear
/// operator along the mesh needs. A wall, a baffle or the edge of the mesh leads nowhere; faces of processor and cyclic
/// patches lead on.
///
/// Cells are numbered locally: own ones first, as in the MeshView, then the halo, one entry for each face that leads to
/// another rank.
class CellGraph {
public:
    /// Collective; the mesh must not change afterwards.
    CellGraph(const Communicator& comm, const MeshView& mesh);

    std::size_t own_count() const { return own_count_; }
    std::size_t local_count() const { return volume_.size(); }

    const Vector& centre(std::size_t own) const { return centre_[own]; }
    double volume(std::size_t local) const { return volume_[local]; }  ///< [m3]

    /// A face as a link from one cell to the next. Both of its cells have one, with the same numbers.
    struct Link {
        int to;           ///< local cell
        double distance;  ///< between the two centres [m]
        double openness;  ///< area of the face across that distance, over the distance [m]
    };
    const Link* links_begin(std::size_t own) const { return links_.data() + first_[own]; }
    const Link* links_end(std::size_t own) const { return links_.data() + first_[own + 1]; }
    std::size_t link_number(const Link* link) const { return static_cast<std::size_t>(link - links_.data()); }
    std::size_t links() const { return links_.size(); }

    /// Sets the halo's part of `values` [local_count()] to what the owners have. Collective.
    template <class Record>
    void fill_halo(std::vector<Record>& values) const
    {
        if (comm_.size() == 1) return;
        std::vector<Record> out(served_.size());
        for (std::size_t i = 0; i < served_.size(); ++i)
            out[i] = values[served_[i]];
        const std::vector<Record> in = exchange_.backward(std::move(out));
        std::copy(in.begin(), in.end(), values.begin() + static_cast<std::ptrdiff_t>(own_count_));
    }

    /// Adds the halo's part of `values` to the owners' and clears it. Collective.
    template <class Record>
    void add_halo_to_owners(std::vector<Record>& values) const
    {
        if (comm_.size() == 1) return;
        const auto halo = values.begin() + static_cast<std::ptrdiff_t>(own_count_);
        const std::vector<Record> in = exchange_.forward(std::vector<Record>(halo, values.end()));
        for (std::size_t i = 0; i < served_.size(); ++i)
            numbers(values[served_[i]]) += numbers(in[i]);
        std::fill(halo, values.end(), Record{});
    }

    std::size_t bytes_sent() const { return exchange_.bytes_sent(); }

private:
    Communicator comm_;
    std::size_t own_count_;
    Vectors centre_;
    Scalars volume_;
    std::vector<std::size_t> first_;
    std::vector<Link> links_;
    ExchangePlan exchange_;            ///< from those that hold halo copies to the owners
    std::vector<std::size_t> served_;  ///< own cells that others hold, ordered by rank
};

}  // namespace interphase
