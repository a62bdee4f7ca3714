// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "hard_sphere/attraction.hpp"
#include "hard_sphere/contact.hpp"
#include "walls/wall.hpp"

namespace interphase::hard_sphere {

/// What a contact with a wall is remembered under: always below 0, as no sphere's id is.
inline int wall_key(std::size_t wall, int element, std::size_t walls)
{
    return -1 - static_cast<int>(wall) - static_cast<int>(walls) * element;
}

struct WallElement {
    std::size_t wall;
    int element;  ///< WallPoint::element
};
inline WallElement element_of(int wall_key, std::size_t walls)
{
    const int number = -1 - wall_key, count = static_cast<int>(walls);
    return {static_cast<std::size_t>(number % count), number / count};
}

/// Finds the contacts of spheres with walls. The body after the last sphere stands for all resting walls; a body for
/// each point of a moving wall is appended.
void find_wall_contacts(Bodies& bodies, const std::vector<std::unique_ptr<walls::Wall>>& walls,
                        const Materials& materials, const StepLimits& limits, std::vector<Contact>& found);

/// Adds the spheres of this rank whose gap to a wall is below `range` [m] where they are now.
void find_wall_attractions(const Bodies& bodies, const std::vector<std::unique_ptr<walls::Wall>>& walls,
                           const Materials& materials, double range, std::vector<Attraction>& found);

}  // namespace interphase::hard_sphere
