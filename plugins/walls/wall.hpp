// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "walls/place.hpp"

namespace interphase::walls {

/// Where a sphere may touch a wall.
struct WallPoint {
    Vector normal;    ///< from the sphere to the wall
    double gap;       ///< [m], below 0: overlap
    Vector velocity;  ///< of the wall there [m/s]
    int element;      ///< of the wall, e.g. the triangle; 0 for a smooth wall
};

class Wall {
public:
    explicit Wall(int type) : type_(type) {}
    virtual ~Wall() = default;

    /// Of material, from 0.
    int type() const { return type_; }

    /// Adds the points within `reach` of the sphere's surface.
    virtual void near(const Place& sphere, double reach, std::vector<WallPoint>& points) const = 0;

    /// Cheap: false if no point is within `reach`.
    virtual bool may_touch(const Place& sphere, double reach) const = 0;

    /// The largest speed with which a point of it travels [m/s].
    virtual double fastest() const { return 0; }
    /// Where it will be `time` [s] later, as it travels now.
    virtual void travel(double /*time*/) {}
    /// The largest distance of a point of it from where `before`, the same wall, has it [m].
    virtual double away_from(const Wall& /*before*/) const { return 0; }

private:
    int type_;
};

/// Both sides of an infinite plane across an axis (0 to 2) at `position` [m].
class PlaneWall final : public Wall {
public:
    PlaneWall(int type, int axis, double position) : Wall(type), axis_(static_cast<std::size_t>(axis)), at_(position) {}
    void near(const Place& sphere, double reach, std::vector<WallPoint>& points) const override;
    bool may_touch(const Place& sphere, double reach) const override
    {
        const double distance = sphere.centre[axis_] - at_;
        return (distance < 0 ? -distance : distance) < sphere.radius + reach;
    }
    int axis() const { return static_cast<int>(axis_); }
    double position() const { return at_; }  ///< [m]

private:
    std::size_t axis_;
    double at_;
};

/// Both sides of an infinite cylinder along an axis; `centre`: its two other coordinates, in the order of LIGGGHTS
/// (y z, z x, x y) [m].
class CylinderWall : public Wall {
public:
    CylinderWall(int type, int axis, double radius, double centre_1, double centre_2)
        : Wall(type),
          first_(static_cast<std::size_t>((axis + 1) % 3)),
          second_(static_cast<std::size_t>((axis + 2) % 3)),
          radius_(radius),
          centre_{centre_1, centre_2}
    {}
    void near(const Place& sphere, double reach, std::vector<WallPoint>& points) const override;
    bool may_touch(const Place& sphere, double reach) const override;

private:
    double distance(const Place& sphere) const;  ///< of the centre from the axis

    std::size_t first_, second_;
    double radius_;
    double centre_[2];
};

}  // namespace interphase::walls
