// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mapping/cell_graph.hpp"

namespace interphase {

/// Hands the solids of cells above a packing limit to their neighbours.
///
/// The hand-over is a linear operator on cell contents, with columns that sum to one: what it does to the solid volume
/// it does to every other quantity that particles give to the cells, and its transpose to what they get back. So volume
/// and momentum stay conserved while a cell is relieved.
class PackingLimit {
public:
    PackingLimit(const CellGraph& cells, const Communicator& comm, double limit)
        : cells_(cells), comm_(comm), limit_(limit)
    {}

    /// Relieves `solid_volume` [own cells, m3] until no own cell is above the limit, to a thousandth where that takes
    /// more than fifty passes, and remembers how. Throws a UserError where there is no room left for the excess.
    /// Collective.
    void relieve(Scalars& solid_volume);

    /// Does to another content [own cells] what relieve() did to the solid volume. Collective.
    template <class Record>
    void hand_over(std::vector<Record>& content) const
    {
        for (const Pass& pass : passes_)
            apply(pass, content);
    }

    /// The transpose, for cell values on their way to the particles [own cells]. Collective.
    template <class Record>
    void take_from_receivers(std::vector<Record>& values) const
    {
        for (auto pass = passes_.rbegin(); pass != passes_.rend(); ++pass) {
            values.resize(cells_.local_count());
            cells_.fill_halo(values);
            std::vector<Record> change(cells_.own_count(), Record{});
            for (const Transfer& t : *pass)
                numbers(change[index(t.from)]) +=
                    t.fraction * (numbers(values[index(t.to)]) - numbers(values[index(t.from)]));
            for (std::size_t c = 0; c < change.size(); ++c)
                numbers(values[c]) += numbers(change[c]);
        }
        values.resize(cells_.own_count());
    }

    /// Cells of this rank that were above the limit in the last relieve().
    long cells_relieved() const { return cells_relieved_; }

private:
    struct Transfer {
        int from;  ///< own cell
        int to;    ///< local cell
        double fraction;
    };
    using Pass = std::vector<Transfer>;

    static std::size_t index(int cell) { return static_cast<std::size_t>(cell); }
    Pass transfers_for(const Scalars& solid_volume, double slack) const;

    template <class Record>
    void apply(const Pass& pass, std::vector<Record>& content) const
    {
        std::vector<Record> given(cells_.local_count(), Record{});
        for (const Transfer& t : pass) {
            const Numbers<Record> amount = t.fraction * numbers(content[index(t.from)]);
            numbers(given[index(t.to)]) += amount;
            numbers(given[index(t.from)]) -= amount;
        }
        cells_.add_halo_to_owners(given);
        for (std::size_t c = 0; c < cells_.own_count(); ++c)
            numbers(content[c]) += numbers(given[c]);
    }

    const CellGraph& cells_;
    Communicator comm_;
    double limit_;
    std::vector<Pass> passes_;
    long cells_relieved_ = 0;
};

}  // namespace interphase
