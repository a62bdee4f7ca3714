// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/particle_trouble.hpp"

#include <cmath>

#include "base/text.hpp"

namespace interphase {

namespace {

std::string named(const ParticleView& particles, std::size_t i, int rank)
{
    return "particle " + std::to_string(particles.id[i]) + " (rank " + std::to_string(rank) + ")";
}

std::string place(const ParticleView& particles, std::size_t i)
{
    return "at " + text(Vector(particles.position.col(static_cast<Eigen::Index>(i))));
}

std::optional<Problem> motion_trouble(const ParticleView& particles, int rank)
{
    if (std::isfinite(particles.position.sum() + particles.velocity.sum())) return std::nullopt;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        if (particles.position.col(column).allFinite() && particles.velocity.col(column).allFinite()) continue;
        return Problem{"the velocity or position of " + named(particles, i, rank) +
                           " is not finite: v = " + text(Vector(particles.velocity.col(column))),
                       place(particles, i),
                       "reduce the solid step (particles/stepsPerCollision), check overlaps at the start"};
    }
    return std::nullopt;
}

std::optional<Problem> weight_trouble(const ParticleView& particles, int rank)
{
    if (!particles.weight.differ()) return std::nullopt;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double weight = particles.weight[i];
        if (weight >= 1 && std::isfinite(weight)) continue;
        return Problem{"the weight of " + named(particles, i, rank) + " is " + text(weight) +
                           ", which is no number of real particles: at least 1 is in a tracked one",
                       place(particles, i),
                       "in the script correct `set ... property/atom weight W`, the default of fix "
                       "property/atom weight, or `set_property weight W` of what inserts it"};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Problem> particle_trouble(const ParticleView& particles, int rank)
{
    if (auto problem = motion_trouble(particles, rank)) return problem;
    return weight_trouble(particles, rank);
}

}  // namespace interphase
