// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/voidage_counts.hpp"

#include <cmath>

#include "statistics/bins.hpp"
#include "statistics/statistics_scene.hpp"

namespace interphase {

Scalars voidage_counts(const Communicator& comm, const Scalars& voidage, const Scalars& edges)
{
    Scalars counts(edges.size() + 1, 0.0);
    for (const double value : voidage)
        ++counts[bin_of(value, edges)];
    comm.sum(counts);
    return counts;
}

Layers::Layers(const Communicator& comm, const MeshView& mesh, const Box& vessel)
{
    constexpr double most = 100;
    const double low = vessel(2, 0), height = vessel(2, 1) - low;
    const double count = std::clamp(std::round(height / mean_extent(comm, mesh, 2)), 1.0, most);
    edges_ = even_edges(low, vessel(2, 1), static_cast<std::size_t>(count));
    volume_.assign(this->count(), 0.0);
    const double thickness = height / count;
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        const double bottom = mesh.centre[c].z() - mesh.extent[c].z() / 2 - low, top = bottom + mesh.extent[c].z();
        // faces of a cell lie on those of a layer but for rounding
        constexpr double slack = 1e-6;
        const double first = std::clamp(std::floor(bottom / thickness + slack), 0.0, count - 1);
        const double last = std::clamp(std::ceil(top / thickness - slack) - 1, first, count - 1);
        for (double k = first; k <= last; ++k) {
            const double inside = std::min(top, (k + 1) * thickness) - std::max(bottom, k * thickness);
            const double share = first == last ? 1 : std::max(0.0, inside) / (top - bottom);
            shares_.push_back({c, static_cast<std::size_t>(k), share * mesh.volume[c]});
            volume_[static_cast<std::size_t>(k)] += share * mesh.volume[c];
        }
    }
    comm.sum(volume_);
}

Scalars Layers::means(const Communicator& comm, const Scalars& voidage) const
{
    Scalars means(count(), 0.0);
    for (const Share& share : shares_)
        means[share.layer] += share.volume * voidage[share.cell];
    comm.sum(means);
    for (std::size_t k = 0; k < means.size(); ++k)
        means[k] /= volume_[k];
    return means;
}

}  // namespace interphase
