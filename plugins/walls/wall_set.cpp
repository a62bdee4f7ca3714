// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/wall_set.hpp"

#include <algorithm>

#include "modify.h"

namespace interphase::walls {

void WallSet::clear()
{
    walls_.clear();
    origins_.clear();
}

void WallSet::add(FixWall& fix)
{
    for (int n = 0; n < fix.wall_count(); ++n) {
        walls_.push_back(fix.wall(n));
        origins_.push_back({&fix, n, fix.sums_forces(n)});
    }
}

void WallSet::collect(LAMMPS_NS::Modify& modify, const std::string& style)
{
    clear();
    for (int k = 0; k < modify.nfix; ++k)
        if (auto* fix = dynamic_cast<FixWall*>(modify.fix[k]); fix && fix->is_heeded_by(style)) add(*fix);
}

bool WallSet::are_of_types(int count) const
{
    return std::all_of(walls_.begin(), walls_.end(),
                       [&](const auto& wall) { return wall->type() >= 0 && wall->type() < count; });
}

double WallSet::follow()
{
    double off = 0;
    for (std::size_t k = 0; k < walls_.size(); ++k) {
        const Origin& origin = origins_[k];
        if (!origin.fix->travels(origin.number)) continue;
        std::unique_ptr<Wall> now = origin.fix->wall(origin.number);
        off = std::max(off, now->away_from(*walls_[k]));
        walls_[k] = std::move(now);
    }
    return off;
}

void WallSet::travel(double time)
{
    for (const auto& wall : walls_)
        wall->travel(time);
}

bool WallSet::any_travels() const
{
    return std::any_of(origins_.begin(), origins_.end(),
                       [](const Origin& origin) { return origin.fix->travels(origin.number); });
}

bool WallSet::any_sums_forces() const
{
    return std::any_of(origins_.begin(), origins_.end(), [](const Origin& origin) { return origin.sums_forces; });
}

double WallSet::fastest() const
{
    double fastest = 0;
    for (const auto& wall : walls_)
        fastest = std::max(fastest, wall->fastest());
    return fastest;
}

}  // namespace interphase::walls
