// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/population.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/text.hpp"

namespace interphase {

Population counted(const Communicator& comm, const ParticleView& particles)
{
    constexpr double huge = std::numeric_limits<double>::max();
    Population mine{static_cast<long>(particles.size()), 0, huge, 0, huge, 0};
    RealDiameter real_diameter;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double weight = particles.weight[i];
        const double diameter = real_diameter(particles.radius[static_cast<Eigen::Index>(i)], weight);
        mine.real += weight;
        mine.lowest_weight = std::min(mine.lowest_weight, weight);
        mine.highest_weight = std::max(mine.highest_weight, weight);
        mine.smallest_diameter = std::min(mine.smallest_diameter, diameter);
        mine.largest_diameter = std::max(mine.largest_diameter, diameter);
    }
    if (comm.sum(mine.tracked) == 0) return {};
    return {comm.sum(mine.tracked),           comm.sum(mine.real),
            comm.min(mine.lowest_weight),     comm.max(mine.highest_weight),
            comm.min(mine.smallest_diameter), comm.max(mine.largest_diameter)};
}

std::string weights_of(const Population& all)
{
    return all.lowest_weight == all.highest_weight
               ? "weight " + text(all.lowest_weight)
               : "weights " + text(all.lowest_weight) + " to " + text(all.highest_weight);
}

std::string numbers_of(const Population& all, const Scalars& radii_to_come)
{
    std::string to_come;
    if (!radii_to_come.empty()) {
        const auto [least, most] = std::minmax_element(radii_to_come.begin(), radii_to_come.end());
        const std::string from = text(2 * *least), to = text(2 * *most);
        to_come = "spheres of " + from + (from == to ? "" : " to " + to) + " m are to be inserted";
    }
    if (all.tracked == 0) return "none yet; " + to_come;
    char real[32];
    std::snprintf(real, sizeof real, "%.10g", all.real);
    const std::string smallest = text(all.smallest_diameter), largest = text(all.largest_diameter);
    return std::to_string(all.tracked) + " of " + weights_of(all) + ", for " + real + " real ones of " + smallest +
           (smallest == largest ? "" : " to " + largest) + " m" + (to_come.empty() ? "" : "; " + to_come);
}

}  // namespace interphase
