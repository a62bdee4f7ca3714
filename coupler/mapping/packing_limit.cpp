// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/packing_limit.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

namespace interphase {

namespace {

constexpr int most_passes = 200;

/// Share of a cell's volume by which it may stand above the limit after so many passes: round-off at first, and up to a
/// thousandth where the excess takes long to seep through a crowd of cells that are full themselves.
double slack_after(int passes)
{
    constexpr double rounding = 1e-9, patient_passes = 50, passes_per_decade = 25;
    return rounding * std::pow(10.0, std::max(0.0, passes - patient_passes) / passes_per_decade);
}

}  // namespace

PackingLimit::Pass PackingLimit::transfers_for(const Scalars& solid_volume, double slack) const
{
    Pass pass;
    for (std::size_t c = 0; c < cells_.own_count(); ++c) {
        const double excess = solid_volume[c] - limit_ * cells_.volume(c);
        if (excess <= slack * cells_.volume(c)) continue;

        const auto room = [&](std::size_t n) { return std::max(0.0, limit_ * cells_.volume(n) - solid_volume[n]); };
        double rooms = 0, volumes = 0;
        const auto begin = cells_.links_begin(c), end = cells_.links_end(c);
        for (auto link = begin; link != end; ++link) {
            rooms += room(index(link->to));
            volumes += cells_.volume(index(link->to));
        }
        for (auto link = begin; link != end; ++link) {
            const double share = rooms > 0 ? room(index(link->to)) / rooms : cells_.volume(index(link->to)) / volumes;
            if (share > 0) pass.push_back({static_cast<int>(c), link->to, share * excess / solid_volume[c]});
        }
    }
    return pass;
}

void PackingLimit::relieve(Scalars& solid_volume)
{
    passes_.clear();
    cells_relieved_ = 0;
    for (int n = 0; n < most_passes; ++n) {
        const double slack = slack_after(n);
        bool above = false;
        for (std::size_t c = 0; c < cells_.own_count() && !above; ++c)
            above = solid_volume[c] > (limit_ + slack) * cells_.volume(c);
        if (!comm_.any(above)) return;

        solid_volume.resize(cells_.local_count());
        cells_.fill_halo(solid_volume);
        passes_.push_back(transfers_for(solid_volume, slack));
        const Pass& pass = passes_.back();
        for (std::size_t i = 0; i < pass.size(); ++i)
            if (n == 0 && (i == 0 || pass[i].from != pass[i - 1].from)) ++cells_relieved_;
        apply(pass, solid_volume);
        solid_volume.resize(cells_.own_count());
    }

    std::optional<Problem> problem;
    for (std::size_t c = 0; c < cells_.own_count() && !problem; ++c) {
        const double packing = solid_volume[c] / cells_.volume(c);
        if (packing > limit_ + slack_after(most_passes))
            problem = Problem{"the solid fraction (voidage field) is " + text(packing) + " in cell " +
                                  std::to_string(c) + " of rank " + std::to_string(comm_.rank()) +
                                  ", above the limit of " + text(limit_) + ", and no neighbour has room",
                              "at " + text(cells_.centre(c)),
                              "check for overlapping particles there (a solid step too large, a stiffness too low), or "
                              "raise mapping/maximumPacking in system/couplingDict"};
    }
    comm_.fail_together(problem);
}

}  // namespace interphase
