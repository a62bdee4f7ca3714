// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "walls/wall.hpp"

namespace interphase::walls {

using Triangle = std::array<Vector, 3>;

/// The point of a triangle that is nearest to `point` (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
Vector nearest_point(const Triangle& triangle, const Vector& point);

/// A surface of triangles at a moment.
struct Surface {
    std::vector<Triangle> triangles;  ///< corners [m]
    std::vector<Triangle> velocity;   ///< of each corner [m/s]; empty where nothing moves
    bool travels = false;             ///< with that velocity; or, as a conveyor belt, it stays where it is
};

/// The velocity of a triangle's point [m/s], given that of the corners.
Vector velocity_at(const Triangle& triangle, const Triangle& velocity, const Vector& point);

/// Both sides of a surface of triangles.
class TriangleWall : public Wall {
public:
    TriangleWall(int type, Surface surface);

    void near(const Place& sphere, double reach, std::vector<WallPoint>& points) const override;
    bool may_touch(const Place& sphere, double reach) const override;
    double fastest() const override;
    void travel(double time) override;
    double away_from(const Wall& before) const override;

private:
    void sort_into_cells();
    bool lay_cells();  ///< of size_

    struct Range {
        int low[3], high[3];
    };
    Range cells_around(const Vector& low, const Vector& high) const;
    Range cells_of(const Triangle& triangle) const;
    int cell(int x, int y, int z) const { return (z * cells_[1] + y) * cells_[0] + x; }
    template <class Visit>
    void each_near(const Place& sphere, double reach, const Visit& visit) const;

    Surface surface_;
    Box bounds_ = empty_box();
    double size_ = 1;
    int cells_[3] = {1, 1, 1};
    std::vector<int> start_, members_;  ///< triangles whose box meets each cell
};

}  // namespace interphase::walls
