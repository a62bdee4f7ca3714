// SPDX-License-Identifier: GPL-3.0-or-later
// Into how many parts fix tdhs takes a step, by spheres and walls as they are.
#include <algorithm>
#include <cmath>
#include <string>

#include "atom.h"
#include "hard_sphere/fix_tdhs.hpp"
#include "modify.h"
#include "update.h"

namespace interphase::hard_sphere {

namespace {

constexpr int most_parts = 100;
constexpr double touching_share = 0.1;  // of the margin
constexpr double usual_reach = 0.3;     // of a diameter: hardly any pair closes a wider gap in a step

}  // namespace

/// The smallest sphere that there is or that a fix will insert.
void FixTdhs::measure_spheres()
{
    double smallest = 1e300;
    for (int i = 0; i < atom->nlocal; ++i)
        smallest = std::min(smallest, atom->radius[i]);
    for (int k = 0; k < modify->nfix; ++k)
        for (int type = 1; type <= atom->ntypes; ++type) {
            const double least = modify->fix[k]->min_rad(type);
            if (least > 0) smallest = std::min(smallest, least);
        }
    smallest_radius_ = -shared_max(-smallest);
}

void FixTdhs::choose_parts()
{
    if (sizes_change_) measure_spheres();
    double fastest2 = 0;
    const double* v = atom->nlocal > 0 ? atom->v[0] : nullptr;
    for (int i = 0; i < 3 * atom->nlocal; i += 3)
        fastest2 = std::max(fastest2, v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2]);
    const double fastest = std::sqrt(shared_max(fastest2)) + pulled_, of_walls = walls_.fastest();
    const double diameter = 2 * smallest_radius_, widest = 2 * ghosts_.largest_radius();
    const double closing = 2 * fastest * update->dt;  // no two spheres close a wider gap in a step

    // Pairs with gaps up to `reach` are looked at; one farther apart has to close that and a diameter to pass unseen.
    const double bound = diameter + widest;
    const double way_of_walls = of_walls * update->dt, most_of_walls = walls::most_way_of_walls * smallest_radius_;
    const double needed = std::max(closing / bound, way_of_walls / most_of_walls);
    parts_ = std::max(1, static_cast<int>(std::ceil(needed)));
    if (parts_ > 1 && (!shortens_ || parts_ > most_parts)) {
        const bool wall = way_of_walls / most_of_walls > closing / bound;
        const double speed = wall ? of_walls : fastest, most = wall ? most_of_walls : 0.5 * bound;
        complain(std::string("a ") + (wall ? "wall" : "sphere") + " moves at " + std::to_string(speed) +
                 " m/s, which is " + std::to_string(speed * update->dt) + " m in a step; from " + std::to_string(most) +
                 " m on, " + (wall ? "it may pass through a sphere" : "spheres may pass through each other") +
                 ". Give a step below " + std::to_string(most / speed) + " s" +
                 (shortens_ ? ", or find out why it is so fast" : ", or `too_fast shorten`"));
    }
    if (parts_ > 1) ++counted_[steps_in_parts];
    limits_.step = update->dt / parts_;
    limits_.farthest = fastest * limits_.step;
    limits_.margin = effort_.margin * diameter;
    limits_.tolerated = tolerated_ * diameter;
    limits_.relief = relief_;
    limits_.touching = touching_share * limits_.margin;
    limits_.resting_speed = resting_speed_ >= 0 ? resting_speed_ : 2 * gravity_ * update->dt;
    reach_ =
        std::max({limits_.margin, std::min(closing / parts_, usual_reach * diameter), closing / parts_ - diameter});
}

}  // namespace interphase::hard_sphere
