// SPDX-License-Identifier: GPL-3.0-or-later
// The search finds the pairs that all pairs, asked one by one, give: spheres of one size and of many, at rest and fast,
// dense and dilute, and those with walls. Other sides of periodic boxes come to it as spheres like any.
#include "hard_sphere/pair_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "hard_sphere/wall_contacts.hpp"
#include "walls/triangle_wall.hpp"

using namespace interphase;
using namespace interphase::hard_sphere;

namespace {

struct Scene {
    std::vector<double> centres, radii, velocities;
    double step = 1e-3, margin = 1e-4, touching = 1e-5, fastest = 0;

    std::size_t size() const { return radii.size(); }
};

/// `count` spheres of radius r_min to r_max in a box of `width` [m]; `speed`: up to, by axis [m/s].
Scene random_scene(int count, double r_min, double r_max, double width, double speed)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0, 1);
    Scene scene;
    for (int k = 0; k < count; ++k) {
        scene.radii.push_back(r_min * std::pow(r_max / r_min, any(random)));
        for (int axis = 0; axis < 3; ++axis) {
            scene.centres.push_back(10 + width * any(random));  // far from 0: single precision has to cope
            scene.velocities.push_back(speed * (2 * any(random) - 1));
        }
    }
    scene.fastest = std::sqrt(3.0) * speed;
    return scene;
}

/// As fix tdhs gathers them.
Bodies gathered(const Scene& scene, CellGrid& grid, int up)
{
    const double reach = scene.margin + 2 * scene.fastest * scene.step;
    grid.sort(scene.centres.data(), scene.radii.data(), scene.size(), reach, up);
    Bodies bodies;
    bodies.resize(scene.size());
    bodies.coarse.start(grid.low(), grid.high());
    for (std::size_t b = 0; b < scene.size(); ++b) {
        const auto i = static_cast<std::size_t>(grid.order()[b]);
        set(bodies.path[b].place.centre, to_vector(&scene.centres[3 * i]));
        bodies.path[b].place.radius = scene.radii[i];
        set(bodies.path[b].velocity, to_vector(&scene.velocities[3 * i]));
        bodies.label[b].id = static_cast<int>(i);
    }
    bodies.write_coarse(0, scene.size());
    return bodies;
}

/// The least gap of two spheres on their straight paths within the step [m].
double least_gap(const Scene& scene, std::size_t i, std::size_t j)
{
    const Vector apart = to_vector(&scene.centres[3 * j]) - to_vector(&scene.centres[3 * i]);
    const Vector meeting = to_vector(&scene.velocities[3 * j]) - to_vector(&scene.velocities[3 * i]);
    const double speed2 = meeting.squaredNorm();
    const double time = speed2 > 0 ? std::clamp(-apart.dot(meeting) / speed2, 0.0, scene.step) : 0.0;
    return (apart + time * meeting).norm() - scene.radii[i] - scene.radii[j];
}

/// `slack`: gaps that single precision cannot tell from the margin [m].
void expect_all_pairs(const Scene& scene, int up, double slack)
{
    CellGrid grid;
    const Bodies bodies = gathered(scene, grid, up);
    PairSearch search;
    search.find(bodies, grid, scene.step, scene.margin, scene.touching);
    std::map<std::pair<std::size_t, std::size_t>, bool> found;
    std::vector<int> touches(scene.size() + 1, 0);
    for (const Pair& pair : search) {
        const auto i = static_cast<std::size_t>(bodies.label[static_cast<std::size_t>(pair.i)].id);
        const auto j = static_cast<std::size_t>(bodies.label[static_cast<std::size_t>(pair.j)].id);
        EXPECT_TRUE(found.emplace(std::minmax(i, j), pair.touch == 1).second) << "a pair comes twice";
        for (const int b : std::initializer_list<int>{pair.i, pair.j})
            touches[static_cast<std::size_t>(b)] =
                std::min(2, touches[static_cast<std::size_t>(b)] + static_cast<int>(pair.touch));
    }
    long near = 0;
    for (std::size_t i = 0; i < scene.size(); ++i)
        for (std::size_t j = i + 1; j < scene.size(); ++j) {
            const double gap = least_gap(scene, i, j);
            near += gap < scene.margin;
            const auto pair = found.find({i, j});
            if (gap < scene.margin - slack) {
                EXPECT_TRUE(pair != found.end()) << "gap " << gap;
            }
            if (pair == found.end()) continue;
            EXPECT_LT(gap, scene.margin + slack);
            if (std::abs(gap - scene.touching) > slack) {
                EXPECT_EQ(pair->second, gap < scene.touching) << "gap " << gap;
            }
        }
    EXPECT_GT(near, 100) << "a scene with pairs";
    for (std::size_t b = 0; b < scene.size(); ++b)
        EXPECT_EQ(search.touches()[b], touches[b]);
}

}  // namespace

// A box of 0.1 m has single-precision places to 6e-9 m; what the search squares and subtracts makes of that 1e-6 of a
// length of some millimetres, over a gap's own derivative.
constexpr double slack = 2e-6;

TEST(PairSearch, FindsAllPairsOfOneSize)
{
    for (int up = 0; up < 3; ++up)
        for (const double speed : {0.0, 0.3, 3.0})
            expect_all_pairs(random_scene(1500, 2e-3, 2e-3, 0.1, speed), up, slack);
}

TEST(PairSearch, FindsAllPairsOfManySizes)
{
    for (const double speed : {0.0, 1.0})
        expect_all_pairs(random_scene(1500, 5e-4, 1e-2, 0.1, speed), 2, slack);
}

TEST(PairSearch, FindsAllPairsOfDenseAndDiluteAtOnce)
{
    // half of them in a corner of a box that is 20 times as wide
    Scene scene = random_scene(600, 1e-3, 2e-3, 0.03, 0.5);
    const Scene wide = random_scene(600, 1e-3, 2e-3, 0.6, 0.5);
    for (auto [to, from] :
         {std::pair{&scene.centres, &wide.centres}, {&scene.radii, &wide.radii}, {&scene.velocities, &wide.velocities}})
        to->insert(to->end(), from->begin(), from->end());
    expect_all_pairs(scene, 2, 6 * slack);  // as the box is six times that of the others
}

TEST(PairSearch, BearsNoneAndOne)
{
    for (const int count : {0, 1}) {
        const Scene scene = random_scene(count, 1e-3, 1e-3, 0.1, 1);
        CellGrid grid;
        const Bodies bodies = gathered(scene, grid, 2);
        PairSearch search;
        search.find(bodies, grid, scene.step, scene.margin, scene.touching);
        EXPECT_EQ(search.begin(), search.end());
    }
}

TEST(WallContacts, AreThoseOfEverySphereWithEveryWall)
{
    Scene scene = random_scene(2000, 5e-4, 3e-3, 0.1, 1.0);
    CellGrid grid;
    Bodies bodies = gathered(scene, grid, 2);
    std::vector<std::unique_ptr<walls::Wall>> walls;
    walls.push_back(std::make_unique<walls::PlaneWall>(0, 0, 10.0));
    walls.push_back(std::make_unique<walls::PlaneWall>(0, 2, 10.05));
    walls.push_back(std::make_unique<walls::CylinderWall>(0, 2, 0.04, 10.05, 10.05));
    const Materials materials(1, 0);
    const StepLimits limits{scene.step, scene.margin, scene.touching, 0, 0, 0, scene.fastest * scene.step};
    std::vector<Contact> found;
    find_wall_contacts(bodies, walls, materials, limits, found);

    std::size_t expected = 0;
    for (std::size_t w = 0; w < walls.size(); ++w)
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            std::vector<walls::WallPoint> points;
            walls[w]->near(bodies.path[b].place, 1.0, points);
            ASSERT_EQ(points.size(), 1u);
            const double end = points[0].gap - scene.step * to_vector(bodies.path[b].velocity).dot(points[0].normal);
            if (std::min(points[0].gap, end) > scene.margin) continue;
            ++expected;
            const int key = -1 - static_cast<int>(w);
            const auto contact = std::find_if(found.begin(), found.end(), [&](const Contact& c) {
                return c.i == static_cast<int>(b) && c.key == key;
            });
            ASSERT_NE(contact, found.end());
            EXPECT_EQ(contact->gap, points[0].gap);
            EXPECT_EQ(contact->touch, std::min(points[0].gap, end) < scene.touching);
        }
    EXPECT_EQ(found.size(), expected);
    EXPECT_GT(expected, 100u);
}

TEST(WallContacts, OfAMovingWallHaveABodyWithItsVelocityThatNothingMoves)
{
    const Scene scene = random_scene(6000, 5e-4, 3e-3, 0.1, 1.0);
    const Vector velocity(0, 0, 0.5);
    std::vector<walls::Triangle> triangles{{Vector(9, 9, 10.05), Vector(12, 9, 10.05), Vector(9, 12, 10.05)}};
    std::vector<std::unique_ptr<walls::Wall>> walls;
    walls.push_back(std::make_unique<walls::PlaneWall>(0, 0, 10.0));
    walls.push_back(
        std::make_unique<walls::TriangleWall>(0, walls::Surface{triangles, {{velocity, velocity, velocity}}, true}));
    CellGrid grid;
    Bodies bodies = gathered(scene, grid, 2);
    const StepLimits limits{scene.step, scene.margin, scene.touching, 0, 0, 0, scene.fastest * scene.step};
    std::vector<Contact> found;
    find_wall_contacts(bodies, walls, Materials(1, 0), limits, found);

    ASSERT_EQ(bodies.label.size(), bodies.body.size());
    std::size_t moving = 0;
    for (const Contact& contact : found) {
        const auto j = static_cast<std::size_t>(contact.j);
        ASSERT_LT(j, bodies.label.size());
        EXPECT_TRUE(bodies.label[j].fixed);
        EXPECT_EQ(bodies.body[j].inverse_mass, 0);
        const bool moves = contact.key != wall_key(0, 0, walls.size());
        const Vector expected = moves ? velocity : Vector(Vector::Zero());
        // the weights of a triangle's corners add up to 1 within round-off
        EXPECT_LT((to_vector(bodies.body[j].velocity) - expected).norm(), 1e-15);
        moving += moves;
    }
    EXPECT_GT(moving, 100u);
    EXPECT_EQ(bodies.body.size(), bodies.size() + 1 + moving);  // one for all that rests
}

TEST(WallContacts, WithTrianglesTouchWhereAPlaneDoes)
{
    const double low = 9.5, high = 10.5, level = 10.05;
    std::vector<walls::Triangle> triangles{
        {Vector(low, low, level), Vector(high, low, level), Vector(low, high, level)},
        {Vector(high, high, level), Vector(low, high, level), Vector(high, low, level)}};
    Scene scene = random_scene(2000, 5e-4, 3e-3, 0.1, 1.0);
    CellGrid grid;
    Bodies bodies = gathered(scene, grid, 2);
    const Materials materials(1, 0);
    const StepLimits limits{scene.step, scene.margin, scene.touching, 0, 0, 0, scene.fastest * scene.step};
    std::vector<std::unique_ptr<walls::Wall>> plane, mesh;
    plane.push_back(std::make_unique<walls::PlaneWall>(0, 2, level));
    mesh.push_back(std::make_unique<walls::TriangleWall>(0, walls::Surface{triangles, {}, false}));
    std::vector<Contact> by_plane, by_mesh;
    find_wall_contacts(bodies, plane, materials, limits, by_plane);
    find_wall_contacts(bodies, mesh, materials, limits, by_mesh);
    ASSERT_EQ(by_mesh.size(), by_plane.size());
    for (std::size_t k = 0; k < by_mesh.size(); ++k) {
        EXPECT_EQ(by_mesh[k].i, by_plane[k].i);
        EXPECT_NEAR(by_mesh[k].gap, by_plane[k].gap, 1e-14);  // round-off of coordinates of 10 m
        EXPECT_NEAR(by_mesh[k].touch_time, by_plane[k].touch_time, 1e-9 * scene.step);
    }
}
