// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "walls/fix_wall.hpp"
#include "walls/wall.hpp"

namespace LAMMPS_NS {
class Modify;
}

namespace interphase::walls {

/// Of a radius, in what a sphere takes as one step: a wall that moves farther, or stands so far from where its last
/// velocity would have brought it, may have its centre on the other side.
constexpr double most_way_of_walls = 0.5;

/// The walls that fixes describe, of which some may travel.
class WallSet {
public:
    /// Forgets all.
    void clear();
    /// Adds the fix's walls as they stand now; it has to live on. Collective.
    void add(FixWall& fix);
    /// Those of all fixes that a fix of this style heeds, in place of what there was. Collective.
    void collect(LAMMPS_NS::Modify& modify, const std::string& style);
    /// Whether all are of one of so many types.
    bool are_of_types(int count) const;

    /// Those that travel, as they stand and move now. Nothing is sent where none does. Returns how far a point of them
    /// is from where travel() had it [m]. Collective.
    double follow();
    /// To where those that travel will be `time` [s] later, as they move now.
    void travel(double time);

    bool any_travels() const;
    double fastest() const;  ///< the largest speed of a point of them [m/s]

    const std::vector<std::unique_ptr<Wall>>& all() const { return walls_; }

    /// Whether one of them wants to know what particles do to it.
    bool any_sums_forces() const;
    /// Tells it, if it does; FixWall::push().
    void push(std::size_t wall, int element, const Vector& point, const Vector& impulse) const
    {
        if (origins_[wall].sums_forces) origins_[wall].fix->push(origins_[wall].number, element, point, impulse);
    }

private:
    struct Origin {
        FixWall* fix;
        int number;
        bool sums_forces;
    };
    std::vector<std::unique_ptr<Wall>> walls_;
    std::vector<Origin> origins_;  ///< of each
};

}  // namespace interphase::walls
