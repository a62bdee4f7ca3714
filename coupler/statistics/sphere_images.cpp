// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/sphere_images.hpp"

#include "exchange/exchange_plan.hpp"

namespace interphase {

namespace {

Box box_around(const Vector& centre, double radius)
{
    Box box;
    box.col(0) = centre.array() - radius;
    box.col(1) = centre.array() + radius;
    return box;
}

std::vector<Vector> shifts_of(const PeriodicBox& periods)
{
    std::vector<Vector> shifts{Vector::Zero()};
    for (int axis = 0; axis < 3; ++axis) {
        if (!periods.periodic[static_cast<std::size_t>(axis)]) continue;
        const std::size_t before = shifts.size();
        for (std::size_t n = 0; n < before; ++n)
            for (const int way : {-1, 1})
                shifts.emplace_back(shifts[n] + way * periods.length(axis) * Vector::Unit(axis));
    }
    return shifts;
}

}  // namespace

std::vector<NumberedSphere> spheres_around(const Communicator& comm, const ParticleView& particles,
                                           const PeriodicBox& periods)
{
    const std::vector<Vector> shifts = shifts_of(periods);
    if (comm.size() == 1 && shifts.size() == 1) return {};
    Box own = empty_box();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const Box box = box_around(particles.position.col(at), particles.radius[at]);
        extend(own, box.col(0));
        extend(own, box.col(1));
    }
    const std::vector<Box> ranks = comm.gather_boxes(own);

    std::vector<NumberedSphere> out;
    std::vector<int> counts(ranks.size(), 0);
    for (std::size_t r = 0; r < ranks.size(); ++r) {
        const Box& there = ranks[r];
        for (const Vector& shift : shifts) {
            const bool stays = static_cast<int>(r) == comm.rank() && shift.isZero();
            Box here = own;
            here.colwise() += shift;
            if (stays || !overlap(here, there)) continue;
            for (std::size_t i = 0; i < particles.size(); ++i) {
                const auto at = static_cast<Eigen::Index>(i);
                const Vector centre = particles.position.col(at) + shift;
                if (!overlap(box_around(centre, particles.radius[at]), there)) continue;
                out.push_back(
                    {{centre[0], centre[1], centre[2]}, particles.radius[at], static_cast<double>(particles.id[i])});
                ++counts[r];
            }
        }
    }
    ExchangePlan plan(comm);
    plan.plan(counts);
    return plan.forward(std::move(out));
}

}  // namespace interphase
