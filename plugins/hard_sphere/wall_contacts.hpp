// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "hard_sphere/contact.hpp"
#include "walls/wall.hpp"

namespace interphase::hard_sphere {

/// Finds the contacts of spheres with walls. The body after the last sphere stands for all resting walls; a body for
/// each point of a moving wall is appended.
void find_wall_contacts(Bodies& bodies, const std::vector<std::unique_ptr<walls::Wall>>& walls,
                        const Materials& materials, const StepLimits& limits, std::vector<Contact>& found);

}  // namespace interphase::hard_sphere
