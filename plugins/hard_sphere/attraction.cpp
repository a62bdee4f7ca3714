// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/attraction.hpp"

#include "hard_sphere/impact.hpp"

namespace interphase::hard_sphere {

void find_attractions(const Bodies& bodies, const PairSearch& pairs, const Materials& materials, double range,
                      std::vector<Attraction>& found)
{
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    for (const Pair& pair : pairs) {
        const Label &a = bodies.label[at(pair.i)], &b = bodies.label[at(pair.j)];
        if ((a.fixed && b.fixed) || !resolves(a.id, a.ghost, b.id, b.ghost)) continue;
        const Place &from = bodies.path[at(pair.i)].place, &to = bodies.path[at(pair.j)].place;
        const Vector apart = to_vector(to.centre) - to_vector(from.centre);
        const double distance = apart.norm(), gap = distance - from.radius - to.radius;
        if (gap >= range || distance == 0) continue;
        found.push_back({pair.i, pair.j, materials.between(a.type, b.type), gap,
                         effective_radius(from.radius, to.radius), apart / distance, 0});
    }
}

}  // namespace interphase::hard_sphere
