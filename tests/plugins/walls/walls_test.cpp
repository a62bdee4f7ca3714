// SPDX-License-Identifier: GPL-3.0-or-later
// Where spheres touch planes, cylinders and triangles: nearest points and gaps against closed forms and against points
// sampled on the surface; edges and corners; both sides.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "walls/triangle_wall.hpp"

using namespace interphase;
using namespace interphase::walls;

namespace {

constexpr double round_off = 1e-15;  // of coordinates of up to some metres

Place sphere(const Vector& centre, double radius)
{
    Place place;
    set(place.centre, centre);
    place.radius = radius;
    return place;
}

std::vector<WallPoint> near(const Wall& wall, const Place& place, double reach)
{
    std::vector<WallPoint> points;
    wall.near(place, reach, points);
    return points;
}

Vector touched(const WallPoint& point, const Place& place)
{
    return to_vector(place.centre) + (place.radius + point.gap) * point.normal;
}

/// The triangles of an open box's floor and one wall, along x = 0 and z = 0, both of width 2 about y = 0.
std::vector<Triangle> floor_and_wall()
{
    const auto square = [](const Vector& corner, const Vector& along, const Vector& across) {
        return std::vector<Triangle>{{corner, corner + along, corner + across},
                                     {corner + along + across, corner + across, corner + along}};
    };
    auto triangles = square({0, -1, 0}, {1, 0, 0}, {0, 2, 0});
    for (const Triangle& t : square({0, -1, 0}, {0, 0, 1}, {0, 2, 0}))
        triangles.push_back(t);
    return triangles;
}

struct Draw {
    std::mt19937 generator{13};
    double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator); }
    Vector vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

}  // namespace

TEST(PlaneWall, HasTheDistanceOfEitherSide)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const PlaneWall wall(0, axis, 0.3);
            Vector centre(0.1, -0.2, 0.4), normal = Vector::Zero();
            centre[axis] = 0.3 + side * 0.05;
            normal[axis] = -side;
            const auto points = near(wall, sphere(centre, 0.04), 0.02);
            ASSERT_EQ(points.size(), 1u);
            EXPECT_EQ(points[0].normal, normal);
            EXPECT_NEAR(points[0].gap, 0.01, round_off);
            EXPECT_TRUE(points[0].velocity.isZero());
        }
}

TEST(PlaneWall, IsFeltWithinReachOnly)
{
    const PlaneWall wall(0, 2, 0);
    EXPECT_TRUE(near(wall, sphere({0, 0, 0.05}, 0.04), 0.009).empty());
    EXPECT_FALSE(wall.may_touch(sphere({0, 0, 0.05}, 0.04), 0.009));
    EXPECT_EQ(near(wall, sphere({0, 0, 0.03}, 0.04), 0).size(), 1u);
    EXPECT_NEAR(near(wall, sphere({0, 0, 0.03}, 0.04), 0)[0].gap, -0.01, round_off);
}

TEST(CylinderWall, HasTheDistanceOfInsideAndOutside)
{
    // axes in the order of LIGGGHTS: the two coordinates after the axis, round and round
    Draw draw;
    for (int axis = 0; axis < 3; ++axis) {
        const int first = (axis + 1) % 3, second = (axis + 2) % 3;
        const CylinderWall wall(0, axis, 0.5, 0.2, -0.1);
        for (int k = 0; k < 200; ++k) {
            const Place place = sphere(draw.vector(1), 0.05);
            const double across = place.centre[first] - 0.2, up = place.centre[second] + 0.1;
            const double from_axis = std::sqrt(across * across + up * up);
            const auto points = near(wall, place, 2.0);
            ASSERT_EQ(points.size(), 1u);
            EXPECT_NEAR(points[0].gap, std::abs(0.5 - from_axis) - 0.05, 4 * round_off);
            EXPECT_NEAR(points[0].normal.norm(), 1, 4 * round_off);
            EXPECT_EQ(points[0].normal[axis], 0);
            // the point touched is on the cylinder, from either side
            const Vector point = touched(points[0], place);
            EXPECT_NEAR(std::hypot(point[first] - 0.2, point[second] + 0.1), 0.5, 4 * round_off);
            EXPECT_EQ(near(wall, place, 0.0).empty(), std::abs(0.5 - from_axis) >= 0.05);
            EXPECT_EQ(wall.may_touch(place, 0.0), std::abs(0.5 - from_axis) < 0.05);
        }
    }
}

TEST(CylinderWall, HasNoNearestPointToItsAxis)
{
    EXPECT_TRUE(near(CylinderWall(0, 2, 0.5, 0, 0), sphere({0, 0, 0.3}, 0.49), 0.1).empty());
}

TEST(NearestPoint, IsNoFartherThanAnyOtherOfTheTriangle)
{
    Draw draw;
    for (int k = 0; k < 500; ++k) {
        const Triangle t{draw.vector(1), draw.vector(1), draw.vector(1)};
        const Vector point = draw.vector(2), found = nearest_point(t, point);
        // it is in the triangle: its barycentric coordinates are not below 0 and add up to 1
        Eigen::Matrix3d corners;
        corners << t[0], t[1], t[2];
        const Vector shares = corners.fullPivLu().solve(found);
        EXPECT_GT(shares.minCoeff(), -1e-9);  // a corner matrix of condition 1e6 is about the worst drawn
        EXPECT_NEAR(shares.sum(), 1, 1e-9);
        const double distance = (found - point).norm();
        for (int a = 0; a <= 20; ++a)
            for (int b = 0; b <= 20 - a; ++b)
                EXPECT_LE(distance,
                          (t[0] + a / 20.0 * (t[1] - t[0]) + b / 20.0 * (t[2] - t[0]) - point).norm() + 4 * round_off);
    }
}

TEST(NearestPoint, OfCornersEdgesAndFace)
{
    const Triangle t{Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)};
    EXPECT_EQ(nearest_point(t, {-1, -2, 3}), t[0]);
    EXPECT_EQ(nearest_point(t, {2, -1, 1}), t[1]);
    EXPECT_EQ(nearest_point(t, {-0.5, 2, -1}), t[2]);
    EXPECT_EQ(nearest_point(t, {0.25, -1, 2}), Vector(0.25, 0, 0));
    EXPECT_EQ(nearest_point(t, {-1, 0.75, 2}), Vector(0, 0.75, 0));
    EXPECT_EQ(nearest_point(t, {1, 1, 0.5}), Vector(0.5, 0.5, 0));
    EXPECT_EQ(nearest_point(t, {0.25, 0.25, -7}), Vector(0.25, 0.25, 0));
}

TEST(TriangleWall, IsFlatAcrossInnerEdges)
{
    // one point, that of a plane, wherever over the floor and its inner edge
    const TriangleWall wall(
        0, {{{Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)}, {Vector(1, 1, 0), Vector(0, 1, 0), Vector(1, 0, 0)}},
            {},
            false});
    Draw draw;
    for (int k = 0; k < 300; ++k) {
        const double x = draw(0.06, 0.94), y = k % 3 ? draw(0.06, 0.94) : 1 - x, side = k % 2 ? 1 : -1;
        const auto points = near(wall, sphere({x, y, side * 0.049}, 0.05), 0.01);
        ASSERT_EQ(points.size(), 1u) << x << " " << y;
        EXPECT_LT((points[0].normal - Vector(0, 0, -side)).norm(), 1e-13);  // round-off of 1 m over the radius
        EXPECT_NEAR(points[0].gap, -0.001, 4 * round_off);
    }
}

TEST(TriangleWall, HasTwoPointsInAHollowEdgeAndOneOnItsBack)
{
    const TriangleWall wall(0, {floor_and_wall(), {}, false});
    const auto hollow = near(wall, sphere({0.05, 0, 0.05}, 0.05), 0.01);
    ASSERT_EQ(hollow.size(), 2u);
    EXPECT_NEAR(std::abs(hollow[0].normal.dot(hollow[1].normal)), 0, 1e-13);
    for (const WallPoint& point : hollow)
        EXPECT_NEAR(point.gap, 0, 4 * round_off);
    // from behind, the edge is what sticks out
    const auto back = near(wall, sphere({-0.03, 0, -0.04}, 0.05), 0.01);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_LT((back[0].normal - Vector(0.6, 0, 0.8)).norm(), 1e-13);
    EXPECT_NEAR(back[0].gap, 0, 4 * round_off);
}

TEST(TriangleWall, EndsInAnEdgeAndACorner)
{
    const TriangleWall wall(0, {{{Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)}}, {}, false});
    const auto edge = near(wall, sphere({0.5, -0.03, 0.04}, 0.05), 0.01);
    ASSERT_EQ(edge.size(), 1u);
    EXPECT_LT((edge[0].normal - Vector(0, 0.6, -0.8)).norm(), 1e-13);
    const Vector beyond(-0.02, -0.01, 0.02);
    const auto corner = near(wall, sphere(beyond, 0.05), 0.01);
    ASSERT_EQ(corner.size(), 1u);
    EXPECT_LT((corner[0].normal + beyond.normalized()).norm(), 1e-13);
    EXPECT_NEAR(corner[0].gap, 0.03 - 0.05, 4 * round_off);
    EXPECT_TRUE(near(wall, sphere({-0.04, -0.04, 0.04}, 0.05), 0.01).empty());
}

TEST(TriangleWall, SeesOfManyTrianglesTheNearest)
{
    // a sphere's surface of triangles of all sizes: the gap is that of the nearest of all, asked one by one
    Draw draw;
    std::vector<Triangle> triangles;
    for (int k = 0; k < 400; ++k) {
        const Vector at = draw.vector(1).normalized();
        const double size = k % 20 ? 0.05 : 0.5;
        triangles.push_back({at + draw.vector(size), at + draw.vector(size), at + draw.vector(size)});
    }
    const TriangleWall wall(0, {triangles, {}, false});
    int touching = 0;
    for (int k = 0; k < 4000; ++k) {
        const Place place = sphere(draw.vector(1.2), 0.05);
        double least = 1e300;
        for (const Triangle& t : triangles)
            least = std::min(least, (nearest_point(t, to_vector(place.centre)) - to_vector(place.centre)).norm());
        const auto points = near(wall, place, 0.02);
        EXPECT_EQ(points.empty(), least >= 0.07);
        if (points.empty()) continue;
        ++touching;
        EXPECT_TRUE(wall.may_touch(place, 0.02));
        EXPECT_EQ(points[0].gap, least - 0.05);  // nearest first
    }
    EXPECT_GT(touching, 100);
}

TEST(TriangleWall, OfNoTrianglesIsNone)
{
    const TriangleWall wall(0, Surface{});
    EXPECT_TRUE(near(wall, sphere({0, 0, 0}, 1), 1).empty());
    EXPECT_FALSE(wall.may_touch(sphere({0, 0, 0}, 1), 1));
}

TEST(TriangleWall, MovesAsItsCornersDo)
{
    // a rigid motion: each point of it has velocity + rotation x place, to round-off of numbers near 10
    const Vector velocity(1, -2, 0.5), rotation(3, 1, -2);
    const auto motion = [&](const Vector& place) { return Vector(velocity + rotation.cross(place)); };
    Surface surface{floor_and_wall(), {}, true};
    double fastest = 0;
    for (const Triangle& triangle : surface.triangles) {
        surface.velocity.push_back({motion(triangle[0]), motion(triangle[1]), motion(triangle[2])});
        for (const Vector& corner : triangle)
            fastest = std::max(fastest, motion(corner).norm());
    }
    TriangleWall wall(0, surface);
    EXPECT_NEAR(wall.fastest(), fastest, 10 * round_off);
    Draw draw;
    for (int k = 0; k < 100; ++k) {
        const Place place = sphere({draw(0, 1), draw(-1, 1), draw(0, 1)}, 0.4);
        for (const WallPoint& point : near(wall, place, 1))
            EXPECT_LT((point.velocity - motion(touched(point, place))).norm(), 10 * round_off);
    }

    // 0.1 s later the floor's corner (1, -1, 0) is where it went to, as its neighbours are
    wall.travel(0.1);
    const Vector corner = Vector(1, -1, 0) + 0.1 * motion(Vector(1, -1, 0));
    const auto points = near(wall, sphere(corner + Vector(0, 0, 0.01), 0.01), 0.001);
    ASSERT_FALSE(points.empty());
    EXPECT_LT(points[0].gap, 0);

    surface.travels = false;  // a belt: it slides along itself, and stays
    TriangleWall belt(0, surface);
    belt.travel(0.1);
    EXPECT_EQ(belt.fastest(), 0);
    const Place over = sphere({0.5, 0, 0.1}, 0.1);
    ASSERT_EQ(near(belt, over, 0.01).size(), 1u);
    EXPECT_NEAR(near(belt, over, 0.01)[0].gap, 0, round_off);
    EXPECT_LT((near(belt, over, 0.01)[0].velocity - motion({0.5, 0, 0})).norm(), 10 * round_off);
}
