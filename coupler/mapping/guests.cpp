// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/guests.hpp"

#include <algorithm>

namespace interphase {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Guests::Guests(const Communicator& comm, const MeshView& mesh, const StraightPaths& paths)
    : comm_(comm), mesh_(mesh), paths_(paths), exchange_(comm)
{}

void Guests::leave(int face, const Point& point)
{
    const MeshView::Face& half = mesh_.faces[index(face)];
    OnItsWay going{half.partner_rank, half.partner, point.rank, point.particle, point.size_class, point.share, {}, {}};
    set(going.at, point.path.at);
    set(going.to, point.path.to);
    leaving_.push_back(going);
}

std::vector<Guests::Point> Guests::arrive(std::size_t particles)
{
    std::vector<Point> guests;
    while (comm_.any(!leaving_.empty())) {
        std::stable_sort(leaving_.begin(), leaving_.end(),
                         [](const OnItsWay& a, const OnItsWay& b) { return a.to_rank < b.to_rank; });
        std::vector<int> counts(index(comm_.size()), 0);
        for (const OnItsWay& point : leaving_)
            ++counts[index(point.to_rank)];
        ExchangePlan plan(comm_);
        plan.plan(counts);
        const std::vector<OnItsWay> coming = plan.forward(std::move(leaving_));
        leaving_.clear();
        for (const OnItsWay& from : coming) {
            Point point{paths_.enter(from.face, to_vector(from.at), to_vector(from.to)), from.share, from.rank,
                        from.particle, from.size_class};
            const int face = paths_.follow(point.path);
            if (face >= 0)
                leave(face, point);
            else
                guests.push_back(point);
        }
    }
    std::stable_sort(guests.begin(), guests.end(), [](const Point& a, const Point& b) { return a.rank < b.rank; });
    wanted_ = guests.size();
    std::vector<int> counts(index(comm_.size()), 0), wanted;
    for (Point& guest : guests) {
        ++counts[index(guest.rank)];
        wanted.push_back(guest.particle);
        guest.particle = static_cast<int>(particles + wanted.size()) - 1;
    }
    exchange_.plan(counts);  // those who want ask the particles' ranks: records flow backward along this plan
    served_.clear();
    for (const int particle : exchange_.forward(std::move(wanted)))
        served_.push_back(index(particle));
    return guests;
}

}  // namespace interphase
