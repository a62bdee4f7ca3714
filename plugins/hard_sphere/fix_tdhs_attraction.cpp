// SPDX-License-Identifier: GPL-3.0-or-later
// The attraction of fix tdhs's law: a force over a range, whose impulse of a step is added with that of the other
// forces, before contacts are resolved. These keep apart what touches.
#include <algorithm>
#include <cmath>

#include "comm.h"
#include "hard_sphere/fix_tdhs.hpp"
#include "hard_sphere/wall_contacts.hpp"
#include "update.h"

namespace interphase::hard_sphere {

/// Finds the pairs of the step, too: one search is for both. They meet as they move with the attraction's impulse in
/// their velocities, which the search does not know yet: it looks as much farther as the last step's impulses brought
/// two spheres nearer.
void FixTdhs::attract()
{
    const double margin = std::max(limits_.margin, range_) + 2 * pulled_ * limits_.step;
    gather(std::max(reach_, margin));
    pairs_.find(bodies_, grid_, limits_.step, margin, limits_.touching);
    attractions_.clear();
    find_attractions(bodies_, pairs_, law_->materials, range_, attractions_);
    cost_.switch_to(Part::walls);
    find_wall_attractions(bodies_, walls_.all(), law_->materials, range_, attractions_);

    cost_.switch_to(Part::contacts);
    law_->attract(attractions_);
    add_up_pulls();
    if (has_ghosts()) {
        cost_.switch_to(Part::communication);
        message_ = Message::pulls;
        comm->reverse_comm_fix(this);
        comm->forward_comm_fix(this);
    }
    pulled_ = shared_max(pull());
    cost_.switch_to(Part::search);
    pairs_.look_again(bodies_, limits_.step, limits_.margin, limits_.touching);
}

void FixTdhs::add_up_pulls()
{
    pulls_.assign(bodies_.size(), Vector::Zero());
    for (const Attraction& pair : attractions_) {
        const Vector impulse = update->dt * pair.force * pair.normal;
        const auto i = static_cast<std::size_t>(pair.i);
        pulls_[i] += impulse;
        if (pair.j >= 0) {
            pulls_[static_cast<std::size_t>(pair.j)] -= impulse;
        } else {
            const auto [wall, element] = element_of(pair.j, walls_.all().size());
            const Place& place = bodies_.path[i].place;
            walls_.push(wall, element, to_vector(place.centre) + place.radius * pair.normal, -impulse);
        }
    }
}

/// Returns the largest change of a velocity [m/s].
double FixTdhs::pull()
{
    double largest2 = 0;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Vector gained = bodies_.body[b].inverse_mass * pulls_[b];
        largest2 = std::max(largest2, gained.squaredNorm());
        for (auto* velocity : {bodies_.path[b].velocity, bodies_.body[b].velocity})
            set(velocity, to_vector(velocity) + gained);
        set(bodies_.push[b].change, to_vector(bodies_.push[b].change) + gained);
    }
    return std::sqrt(largest2);
}

}  // namespace interphase::hard_sphere
