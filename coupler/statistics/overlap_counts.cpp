// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/overlap_counts.hpp"

#include <algorithm>
#include <cmath>

#include "base/close_spheres.hpp"
#include "statistics/sphere_images.hpp"

namespace interphase {

const Scalars& overlap_edges()
{
    static const Scalars edges = [] {
        constexpr int bins = 750;
        Scalars all;
        for (int n = 0; n <= bins; ++n)
            all.push_back(std::pow(10.0, -7 + n * (7.5 / bins)));
        return all;
    }();
    return edges;
}

OverlapCounts overlap_counts(const Communicator& comm, const ParticleView& particles, const PeriodicBox& periods,
                             const Scalars& shares)
{
    const std::vector<NumberedSphere> around = spheres_around(comm, particles, periods);
    const std::size_t own = particles.size();
    Scalars centre(particles.position.data(), particles.position.data() + 3 * own);
    Scalars radius(particles.radius.data(), particles.radius.data() + own);
    for (const NumberedSphere& sphere : around) {
        centre.insert(centre.end(), sphere.at, sphere.at + 3);
        radius.push_back(sphere.radius);
    }
    const auto id_of = [&](std::size_t i) { return i < own ? particles.id[i] : around[i - own].id; };

    const Scalars& edges = overlap_edges();
    OverlapCounts found;
    found.counts.assign(edges.size() - 1, 0.0);
    found.below.assign(shares.size(), 0.0);
    const CloseSpheres spheres(centre.data(), radius.data(), radius.size());
    spheres.for_each_overlap([&](std::size_t i, std::size_t j, double depth) {
        if (i >= own || j >= own) {
            // A pair of two ranks, or across a side, is seen from both: it counts where the lower number is at home.
            if (i >= own && j >= own) return;
            if (id_of(std::min(i, j)) >= id_of(std::max(i, j))) return;
        }
        const double share = depth / (2 * std::min(radius[i], radius[j]));
        const auto bin = std::upper_bound(edges.begin(), edges.end(), share) - edges.begin();
        ++found.counts[static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(bin, 1, static_cast<std::ptrdiff_t>(edges.size()) - 1) - 1)];
        found.largest = std::max(found.largest, share);
        for (std::size_t n = 0; n < shares.size(); ++n)
            found.below[n] += share < shares[n];
    });
    Scalars all = found.counts;
    all.insert(all.end(), found.below.begin(), found.below.end());
    comm.sum(all);
    const auto first_below = all.begin() + static_cast<std::ptrdiff_t>(found.counts.size());
    found.counts.assign(all.begin(), first_below);
    found.below.assign(first_below, all.end());
    found.largest = comm.max(found.largest);
    for (const double count : found.counts)
        found.pairs += count;
    return found;
}

}  // namespace interphase
