// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts taken one by one, four or eight at a time get the same impulses, and these are those of a collision
// (collision.hpp): momentum stays, energy comes and goes by the restitution.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "hard_sphere/collision.hpp"
#include "hard_sphere/contact.hpp"
#include "hard_sphere/contact_geometry.hpp"
#include "hard_sphere/law_of.hpp"
#include "hard_sphere/processor.hpp"
#include "hard_sphere/sweep.hpp"

using namespace interphase;
using namespace interphase::hard_sphere;

namespace {

constexpr double step = 1e-3, speed = 1;  // [s], [m/s]
// Batches are in single precision (6e-8); a dozen operations go into each number.
constexpr double single = 2e-6;

std::vector<int> widths()
{
    if (has_widest()) return {1, 4, 8};
    return {1, 4};
}

/// With all that a law may answer between two bodies.
struct Rolling : ConstantRestitution {
    template <class D>
    struct Materials : ConstantRestitution::Materials<D> {
        D rolling_friction;
    };
    static constexpr MaterialProperty properties[] = {{}, {}, {}, {}};

    template <class D>
    static D rolling_friction(const Materials<D>& materials, const Meeting<D>& meeting)
    {
        return materials.rolling_friction * (1 + 0.1 * meeting.speed);
    }
};

struct Draw {
    std::mt19937 generator{11};
    double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator); }
    Vector vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

/// Pairs of spheres near each other, no sphere in two of them; `gap` [diameters] between `low` and `high`.
struct Scene {
    Bodies bodies;
    Cluster cluster;
    std::vector<Overlap> overlaps;
    StepLimits limits{step, 1e-4, 1e-5, 3e-6, 0.1, 1e-3, 2 * speed* step};
    std::shared_ptr<AnyLaw> law;

    int pairs() const { return static_cast<int>(bodies.size() / 2); }

    Scene(Draw& draw, std::size_t batch_count, double low, double high, const Response* response, double pushed = 0)
        : Scene(draw, batch_count, low, high, response, pushed, std::make_shared<LawOf<ConstantRestitution>>())
    {}

    Scene(Draw& draw, std::size_t batch_count, double low, double high, const Response* response, double pushed,
          std::shared_ptr<AnyLaw> law_)
        : law(std::move(law_))
    {
        bodies.resize(2 * lanes * batch_count);
        constexpr int types = 8;
        Materials& materials = law->start(types);
        cluster.rolls = law->rolls();
        cluster.places.start(bodies.body.size());
        for (int pair = 0; pair < types * types; ++pair) {
            materials.number(pair, 0) = response ? response->restitution : draw(0, 1);
            materials.number(pair, 1) = response ? response->tangential_restitution : draw(0, 1);
            materials.number(pair, 2) = response ? response->friction : draw(0, 1);
            if (law->rolls()) materials.number(pair, 3) = draw(0, 1);
        }
        for (int pair = 0; pair < pairs(); ++pair) {
            const int i = 2 * pair, j = i + 1;
            const Vector normal = draw.vector(1).normalized(), middle = draw.vector(0.1);
            const double r_i = draw(1e-3, 3e-3), r_j = draw(1e-3, 3e-3);
            const double distance = (r_i + r_j) * (1 + draw(low, high));
            put(i, middle, r_i, draw.vector(speed), draw.vector(100), draw, pushed);
            put(j, middle + distance * normal, r_j, draw.vector(speed), draw.vector(100), draw, pushed);
            const auto [k, lane] = cluster.places.place(i, j, false, false);
            cluster.reach(k);
            ContactBatch& batch = cluster.batches[k];
            batch.i[lane] = i;
            batch.j[lane] = j;
            for (auto& component : batch.tangential)
                component[lane] = 0;
            BatchNotes& note = cluster.notes[k];
            note.materials[lane] = pair % (types * types);
            note.speed[lane] = 1;
        }
    }

    void put(int k, const Vector& centre, double radius, const Vector& velocity, const Vector& spin, Draw& draw,
             double pushed)
    {
        const auto b = static_cast<std::size_t>(k);
        set(bodies.path[b].place.centre, centre);
        bodies.path[b].place.radius = radius;
        set(bodies.path[b].velocity, velocity);
        set(bodies.push[b].change, draw.vector(pushed));
        set(bodies.body[b].velocity, velocity);
        set(bodies.body[b].spin, spin);
        bodies.body[b].inverse_mass = 1 / (draw(500, 3000) * 4 / 3 * M_PI * radius * radius * radius);
        bodies.body[b].inverse_inertia = 2.5 * bodies.body[b].inverse_mass / (radius * radius);
    }

    void make(int width) { make_ready(bodies, cluster, *law, limits, overlaps, width); }

    /// As the solver does it: half of the passes compress, then restitution acts. Two bodies alone need one of each.
    void resolve(int width)
    {
        for (const Phase phase : {Phase::compression, Phase::compression, Phase::release, Phase::after_release})
            sweep(bodies.body, cluster, Direction::forward, phase, width);
    }

    const Body& body(int k) const { return bodies.body[static_cast<std::size_t>(k)]; }
    Vector momentum(int pair) const
    {
        const Body &a = body(2 * pair), &b = body(2 * pair + 1);
        return to_vector(a.velocity) / a.inverse_mass + to_vector(b.velocity) / b.inverse_mass;
    }
    double energy(int pair) const
    {
        double sum = 0;
        for (const Body* b : {&body(2 * pair), &body(2 * pair + 1)})
            sum += 0.5 * to_vector(b->velocity).squaredNorm() / b->inverse_mass +
                   0.5 * to_vector(b->spin).squaredNorm() / b->inverse_inertia;
        return sum;
    }
    Sphere sphere(int k) const
    {
        const Body& b = body(k);
        return {to_vector(b.velocity), to_vector(b.spin), bodies.path[static_cast<std::size_t>(k)].place.radius,
                b.inverse_mass, b.inverse_inertia};
    }
    const ContactBatch& batch_of(int pair) const { return cluster.batches[static_cast<std::size_t>(pair / lanes)]; }
    Vector normal(int pair) const
    {
        const ContactBatch& batch = batch_of(pair);
        const int lane = pair % lanes;
        return {batch.normal[0][lane], batch.normal[1][lane], batch.normal[2][lane]};
    }
};

void expect_alike(const Scene& one, const Scene& other, int width)
{
    const auto near = [&](float a, float b, double size, const char* what) {
        EXPECT_NEAR(a, b, single * size) << what << ", width " << width;
    };
    for (std::size_t k = 0; k < one.cluster.places.count(); ++k)
        for (int lane = 0; lane < lanes; ++lane) {
            const ContactBatch &a = one.cluster.batches[k], &b = other.cluster.batches[k];
            for (int axis = 0; axis < 3; ++axis) {
                near(a.normal[axis][lane], b.normal[axis][lane], 1, "normal");
                near(a.tangential[axis][lane], b.tangential[axis][lane], a.mass[lane] * speed, "tangential impulse");
            }
            near(a.mass[lane], b.mass[lane], a.mass[lane], "mass");
            near(a.closing[lane], b.closing[lane], speed, "closing speed");
            near(a.impulse[lane], b.impulse[lane], a.mass[lane] * speed, "impulse");
            near(a.bounce[lane], b.bounce[lane], 1, "restitution");
            near(a.tangential_bounce[lane], b.tangential_bounce[lane], 1, "tangential restitution");
            near(a.friction[lane], b.friction[lane], 1, "friction");
            near(a.arm_i[lane], b.arm_i[lane], a.arm_i[lane], "arm");
            near(one.cluster.notes[k].touch_time[lane], other.cluster.notes[k].touch_time[lane], step, "time");
            if (!one.cluster.rolls) continue;
            const RollingBatch &c = one.cluster.rolling[k], &d = other.cluster.rolling[k];
            near(c.arm[lane], d.arm[lane], a.arm_i[lane], "rolling arm");
            for (int axis = 0; axis < 3; ++axis)
                near(c.couple[axis][lane], d.couple[axis][lane], a.mass[lane] * speed * a.arm_i[lane], "couple");
        }
    for (std::size_t k = 0; k < one.bodies.size(); ++k) {
        const Body &a = one.bodies.body[k], &b = other.bodies.body[k];
        // the lighter of the two takes up to all of twice the relative velocity, by masses 1:160
        EXPECT_LT((to_vector(a.velocity) - to_vector(b.velocity)).norm(), 10 * single * speed) << "width " << width;
        EXPECT_LT((to_vector(a.spin) - to_vector(b.spin)).norm(), 10 * single * speed / 1e-3) << "width " << width;
    }
}

}  // namespace

TEST(Widths, AgreeOnRandomPairs)
{
    // gaps that close within the step or not, and overlaps; forces that decide whether an impact is one
    Draw draw;
    for (int k = 0; k < 6; ++k) {
        const double gap = std::array{-0.01, 0.0, 0.3}[static_cast<std::size_t>(k / 2)];
        const std::shared_ptr<AnyLaw> law = k % 2 ? std::shared_ptr<AnyLaw>(new LawOf<Rolling>)
                                                  : std::shared_ptr<AnyLaw>(new LawOf<ConstantRestitution>);
        const Scene start(draw, 50, gap - 0.01, gap + 0.1, nullptr, 0.02, law);
        Scene one = start;
        one.make(1);
        Scene ready = one;
        one.resolve(1);
        for (const int width : widths()) {
            Scene other = start;
            other.make(width);
            EXPECT_EQ(other.overlaps.size(), one.overlaps.size());
            expect_alike(ready, other, width);
            other.resolve(width);
            expect_alike(one, other, width);
        }
    }
}

TEST(Widths, MakeOfAPairWhatTheContactOfTwoSpheresIs)
{
    Draw draw;
    const Response response{0.8, 0.6, 0.3};
    for (const double gap : {-0.01, 0.0, 0.3})
        for (const int width : widths()) {
            Scene scene(draw, 50, gap - 0.01, gap + 0.1, &response, 0.02);
            const Bodies before = scene.bodies;
            scene.make(width);
            for (int pair = 0; pair < scene.pairs(); ++pair) {
                const Contact contact =
                    contact_of_spheres(before, {2 * pair, 2 * pair + 1, 0}, scene.law->materials, scene.limits);
                const ContactBatch& batch = scene.batch_of(pair);
                const int lane = pair % lanes;
                EXPECT_LT((scene.normal(pair) - contact.normal).norm(), single);
                EXPECT_NEAR(batch.closing[lane], contact.closing, single * speed);
                EXPECT_EQ(batch.bounce[lane] > 0, contact.impact);
                EXPECT_NEAR(scene.cluster.notes[static_cast<std::size_t>(pair / lanes)].touch_time[lane],
                            contact.touch_time, single * step);
            }
        }
}

TEST(Widths, KeepMomentumAndEnergyByTheRestitution)
{
    // Every pair meets within the step, frictionless: the energy along the normal comes back by e^2, all else stays.
    Draw draw;
    for (const double e : {0.0, 0.6, 1.0})
        for (const int width : widths()) {
            const Response response{e, 0, 0};
            Scene scene(draw, 50, 0, 1e-3, &response);
            scene.make(width);
            const Scene before = scene;
            scene.resolve(width);
            int met = 0;
            for (int pair = 0; pair < scene.pairs(); ++pair) {
                const Vector n = scene.normal(pair);
                const Sphere a = before.sphere(2 * pair), b = before.sphere(2 * pair + 1);
                const double size = a.velocity.norm() / a.inverse_mass + b.velocity.norm() / b.inverse_mass;
                EXPECT_LT((scene.momentum(pair) - before.momentum(pair)).norm(), 1e-14 * size);  // in double precision
                const double approach = (a.velocity - b.velocity).dot(n), mass = 1 / (a.inverse_mass + b.inverse_mass);
                const bool impact = before.batch_of(pair).bounce[pair % lanes] > 0 && approach > 0;
                met += impact;
                const double lost = impact ? 0.5 * mass * (1 - e * e) * approach * approach : 0.0;
                EXPECT_NEAR(before.energy(pair) - scene.energy(pair), lost, 10 * single * before.energy(pair));
            }
            EXPECT_GT(met, scene.pairs() / 3);
        }
}

TEST(Widths, GiveTwoSpheresAloneTheirCollision)
{
    // Poisson's restitution is Newton's where nothing else touches, and with e_t = e that of the tangential impulse,
    // too
    Draw draw;
    for (const double e : {0.3, 0.9})
        for (const double friction : {0.05, 0.3, 10.0})
            for (const int width : widths()) {
                const Response response{e, e, friction};
                Scene scene(draw, 50, 0, 1e-3, &response);
                scene.make(width);
                const Scene before = scene;
                scene.resolve(width);
                for (int pair = 0; pair < scene.pairs(); ++pair) {
                    if (before.batch_of(pair).bounce[pair % lanes] == 0) continue;
                    Sphere a = before.sphere(2 * pair), b = before.sphere(2 * pair + 1);
                    const Vector n = scene.normal(pair), impulse = collision_impulse(a, b, n, response);
                    const double change = impulse.norm() * std::max(a.inverse_mass, b.inverse_mass);
                    apply_impulse(a, b, n, impulse);
                    EXPECT_LT((a.velocity - scene.sphere(2 * pair).velocity).norm(), 10 * single * change);
                    EXPECT_LT((b.velocity - scene.sphere(2 * pair + 1).velocity).norm(), 10 * single * change);
                }
            }
}

TEST(Widths, TakeNoEnergyFromCompression)
{
    Draw draw;
    for (const int width : widths()) {
        Scene scene(draw, 50, -0.01, 0.05, nullptr);
        scene.limits.relief = 0;
        scene.make(width);
        const Scene before = scene;
        sweep(scene.bodies.body, scene.cluster, Direction::backward, Phase::compression, width);
        for (int pair = 0; pair < scene.pairs(); ++pair)
            EXPECT_LT(scene.energy(pair), before.energy(pair) * (1 + single));
    }
}
