// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact_solver.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hard_sphere/collision.hpp"
#include "hard_sphere/sweep.hpp"

namespace interphase::hard_sphere {

namespace {

bool fixed(const Bodies& bodies, int body) { return bodies.body[static_cast<std::size_t>(body)].inverse_mass == 0; }

/// Distances from the two centres to the point of contact, a wall's being 0. Together they are the distance of the
/// centres then, which keeps angular momentum.
std::array<double, 2> arms(const Bodies& bodies, const Contact& contact)
{
    const double r_i = bodies.place[static_cast<std::size_t>(contact.i)].radius;
    if (contact.key < 0) return {r_i, 0};
    const double r_j = bodies.place[static_cast<std::size_t>(contact.j)].radius;
    const double stretch = contact.gap > 0 ? 1 : 1 + contact.gap / (r_i + r_j);
    return {stretch * r_i, stretch * r_j};
}

Sphere sphere(const Body& body, double arm)
{
    return {vector(body.velocity), vector(body.spin), arm, body.inverse_mass, body.inverse_inertia};
}

void put(const Sphere& sphere, Body& body)
{
    copy_three(sphere.velocity.data(), body.velocity);
    copy_three(sphere.spin.data(), body.spin);
}

/// Lanes without a contact name the body of resting walls, which no impulse changes: a pass writes all lanes back.
void leave_empty(ContactBatch& batch, const Bodies& bodies)
{
    const int resting_walls = static_cast<int>(bodies.size());
    std::fill_n(batch.i, lanes, resting_walls);
    std::fill_n(batch.j, lanes, resting_walls);
}

}  // namespace

void ContactSolver::start(Bodies& bodies, const PairSearch& pairs, const std::vector<Contact>& walls,
                          const Materials& materials, const StepLimits& limits, const ImpulseMemory& memory, int passes)
{
    step_ = limits.step;
    passes_ = 0;
    all_passes_ = passes;
    binary_ = 0;
    cluster_contacts_ = 0;
    const std::size_t n = bodies.body.size();
    impact_places_.start(n);
    resting_places_.start(n);
    overlaps_.clear();
    shift_.assign(n, Vector::Zero());

    for (const Contact& contact : walls)
        resolve(bodies, contact, memory);
    for (const Pair& pair : pairs)
        if (takes_part(bodies, pair)) resolve(bodies, contact_of_spheres(bodies, pair, materials, limits), memory);
}

std::vector<int>& ContactSolver::count_touches(const Bodies& bodies, const PairSearch& pairs,
                                               const std::vector<Contact>& walls)
{
    touches_.assign(bodies.body.size(), 0);
    for (const Pair& pair : pairs)
        if (pair.touch) {
            ++touches_[static_cast<std::size_t>(pair.i)];
            ++touches_[static_cast<std::size_t>(pair.j)];
        }
    for (const Contact& contact : walls)
        touches_[static_cast<std::size_t>(contact.i)] += contact.touch;
    return touches_;
}

bool ContactSolver::takes_part(const Bodies& bodies, const Pair& pair) const
{
    const Label &a = bodies.label[static_cast<std::size_t>(pair.i)],
                &b = bodies.label[static_cast<std::size_t>(pair.j)];
    if (a.ghost + b.ghost == 2 || (a.ghost != b.ghost && (a.ghost == 1) == (a.id < b.id))) return false;
    if (fixed(bodies, pair.i) && fixed(bodies, pair.j)) return false;
    return pair.touch || (in_cluster(bodies, pair.i) && in_cluster(bodies, pair.j));
}

std::vector<int>& ContactSolver::count_users(const Bodies& bodies, const PairSearch& pairs,
                                             const std::vector<Contact>& walls)
{
    users_.assign(bodies.body.size(), 0);
    const auto use = [&](int body) {
        if (in_cluster(bodies, body)) users_[static_cast<std::size_t>(body)] = 1;
    };
    for (const Pair& pair : pairs)
        if (takes_part(bodies, pair)) {
            use(pair.i);
            use(pair.j);
        }
    for (const Contact& contact : walls)
        use(contact.i);
    return users_;
}

bool ContactSolver::has_one_touch(const Bodies& bodies, int body) const
{
    return fixed(bodies, body) || touches_[static_cast<std::size_t>(body)] == 1;
}

bool ContactSolver::in_cluster(const Bodies& bodies, int body) const
{
    return fixed(bodies, body) || touches_[static_cast<std::size_t>(body)] > 1;
}

void ContactSolver::resolve(Bodies& bodies, const Contact& contact, const ImpulseMemory& memory)
{
    if (contact.gap < 0) overlaps_.push_back({contact.i, contact.j, contact.normal, contact.gap});
    if (contact.touch && has_one_touch(bodies, contact.i) && has_one_touch(bodies, contact.j))
        resolve_binary(bodies, contact);
    else if (contact.touch || in_cluster(bodies, contact.i))
        add_to_cluster(bodies, contact, memory);
}

void ContactSolver::resolve_binary(Bodies& bodies, const Contact& contact)
{
    const auto i = static_cast<std::size_t>(contact.i), j = static_cast<std::size_t>(contact.j);
    const auto [arm_i, arm_j] = arms(bodies, contact);
    Sphere a = sphere(bodies.body[i], arm_i), b = sphere(bodies.body[j], arm_j);
    const double parting = contact.impact ? contact.parting : -contact.closing;
    const Vector impulse =
        contact_impulse(a, b, contact.normal, parting, contact.impact ? contact.law->tangential_restitution : 0.0,
                        contact.law->friction);
    if (impulse.isZero(0)) return;
    ++binary_;
    apply_impulse(a, b, contact.normal, impulse);
    if (contact.impact && contact.touch_time > 0) {
        // up to the collision the bodies move as they came
        shift_[i] += contact.touch_time * (vector(bodies.body[i].velocity) - a.velocity);
        shift_[j] += contact.touch_time * (vector(bodies.body[j].velocity) - b.velocity);
    }
    put(a, bodies.body[i]);
    put(b, bodies.body[j]);
}

template <class Batch>
void ContactSolver::fill(Batch& batch, int lane, const Bodies& bodies, const Contact& contact)
{
    ++cluster_contacts_;
    const auto [arm_i, arm_j] = arms(bodies, contact);
    batch.i[lane] = contact.i;
    batch.j[lane] = contact.j;
    for (int axis = 0; axis < 3; ++axis)
        batch.normal[axis][lane] = static_cast<float>(contact.normal[axis]);
    batch.arm_i[lane] = static_cast<float>(arm_i);
    batch.arm_j[lane] = static_cast<float>(arm_j);
    batch.mass[lane] = static_cast<float>(1 / (bodies.body[static_cast<std::size_t>(contact.i)].inverse_mass +
                                               bodies.body[static_cast<std::size_t>(contact.j)].inverse_mass));
    batch.closing[lane] = static_cast<float>(contact.closing);
    batch.friction[lane] = static_cast<float>(contact.law->friction);
}

void ContactSolver::add_impact(const Bodies& bodies, const Contact& contact, const Owner& owner)
{
    const auto [k, lane] =
        impact_places_.place(contact.i, contact.j, fixed(bodies, contact.i), fixed(bodies, contact.j));
    if (k >= impacts_.size()) {
        impacts_.resize(2 * k + 64);
        impact_owners_.resize(impacts_.size());
        touch_times_.resize(impacts_.size());
    }
    ImpactBatch& batch = impacts_[k];
    if (lane == 0) {
        batch = {};
        leave_empty(batch, bodies);
        impact_owners_[k].fill({});
    }
    impact_owners_[k][static_cast<std::size_t>(lane)] = owner;
    touch_times_[k][static_cast<std::size_t>(lane)] = static_cast<float>(contact.touch_time);
    fill(batch, lane, bodies, contact);
    batch.restitution[lane] = static_cast<float>(contact.law->restitution);
    batch.tangential_restitution[lane] = static_cast<float>(contact.law->tangential_restitution);
}

void ContactSolver::add_to_cluster(Bodies& bodies, const Contact& contact, const ImpulseMemory& memory)
{
    const auto i = static_cast<std::size_t>(contact.i), j = static_cast<std::size_t>(contact.j);
    Owner owner;
    if (contact.key < 0)
        owner = {contact.i, contact.key, 1};
    else if (bodies.label[i].id < bodies.label[j].id)
        owner = {contact.i, bodies.label[j].id, 1};
    else
        owner = {contact.j, bodies.label[i].id, -1};
    const Remembered* last = memory.find(bodies.label[static_cast<std::size_t>(owner.body)].atom, owner.partner);
    // restitution is for bodies that meet, not for those that press on each other already
    if (contact.impact && !last)
        add_impact(bodies, contact, owner);
    else
        add_resting(bodies, contact, owner, last);
}

void ContactSolver::add_resting(Bodies& bodies, const Contact& contact, const Owner& owner, const Remembered* last)
{
    const auto [k, lane] =
        resting_places_.place(contact.i, contact.j, fixed(bodies, contact.i), fixed(bodies, contact.j));
    if (k >= resting_.size()) {
        resting_.resize(2 * k + 64);
        owners_.resize(resting_.size());
    }
    ContactBatch& batch = resting_[k];
    if (lane == 0) {
        batch = {};
        leave_empty(batch, bodies);
        owners_[k].fill({});
    }
    fill(batch, lane, bodies, contact);
    owners_[k][static_cast<std::size_t>(lane)] = owner;
    if (!last) return;

    const Vector before = owner.sign * vector(last->impulse);
    const double normal = before.dot(contact.normal);
    if (normal <= 0) return;
    const Vector tangential = before - normal * contact.normal;
    batch.impulse[lane] = static_cast<float>(normal);
    for (int axis = 0; axis < 3; ++axis)
        batch.tangential[axis][lane] = static_cast<float>(tangential[axis]);

    // with the numbers as they are kept: what a pass takes back is what was given here
    Vector impulse;
    for (int axis = 0; axis < 3; ++axis)
        impulse[axis] = double{batch.impulse[lane]} * batch.normal[axis][lane] + double{batch.tangential[axis][lane]};
    const auto i = static_cast<std::size_t>(contact.i), j = static_cast<std::size_t>(contact.j);
    Sphere a = sphere(bodies.body[i], batch.arm_i[lane]), b = sphere(bodies.body[j], batch.arm_j[lane]);
    apply_impulse(a, b, Vector(batch.normal[0][lane], batch.normal[1][lane], batch.normal[2][lane]), impulse);
    put(a, bodies.body[i]);
    put(b, bodies.body[j]);
}

void ContactSolver::pass(std::vector<Body>& bodies, bool ends_forward)
{
    const int k = passes_++, release = all_passes_ / 2;
    const bool as_the_last = (all_passes_ - k) % 2 == 1;
    const Direction direction = as_the_last == ends_forward ? Direction::forward : Direction::backward;
    const Phase phase = k < release ? Phase::compression : k == release ? Phase::release : Phase::after_release;
    sweep(bodies, impacts_, impact_places_.count(), direction, phase);
    sweep(bodies, resting_, resting_places_.count(), direction);
}

void ContactSolver::separate(const Bodies& bodies, double share, double tolerated)
{
    for (const Overlap& overlap : overlaps_) {
        const auto i = static_cast<std::size_t>(overlap.i), j = static_cast<std::size_t>(overlap.j);
        const Body &a = bodies.body[i], &b = bodies.body[j];
        const Vector moves = step_ * (vector(b.velocity) - vector(a.velocity)) + shift_[j] - shift_[i];
        const double left = -tolerated - (overlap.gap + moves.dot(overlap.normal));
        if (left <= 0) continue;
        const double push = share * left / (a.inverse_mass + b.inverse_mass);
        shift_[i] -= push * a.inverse_mass * overlap.normal;
        shift_[j] += push * b.inverse_mass * overlap.normal;
    }
}

void ContactSolver::delay_impacts(const Bodies& bodies)
{
    pushes_.assign(bodies.body.size(), 0);
    const auto count = [&](const ContactBatch& batch) {
        for (int lane = 0; lane < lanes; ++lane)
            if (batch.impulse[lane] > 0) {
                ++pushes_[static_cast<std::size_t>(batch.i[lane])];
                ++pushes_[static_cast<std::size_t>(batch.j[lane])];
            }
    };
    for (std::size_t k = 0; k < resting_places_.count(); ++k)
        count(resting_[k]);
    for (std::size_t k = 0; k < impact_places_.count(); ++k)
        count(impacts_[k]);
    for (std::size_t k = 0; k < impact_places_.count(); ++k)
        for (int lane = 0; lane < lanes; ++lane) {
            const ImpactBatch& batch = impacts_[k];
            if (batch.impulse[lane] == 0) continue;
            Vector impulse;  // on j
            for (int axis = 0; axis < 3; ++axis)
                impulse[axis] = batch.impulse[lane] * batch.normal[axis][lane] + batch.tangential[axis][lane];
            const auto i = static_cast<std::size_t>(batch.i[lane]), j = static_cast<std::size_t>(batch.j[lane]);
            const double time = touch_times_[k][static_cast<std::size_t>(lane)];
            if (pushes_[i] == 1) shift_[i] += time * bodies.body[i].inverse_mass * impulse;
            if (pushes_[j] == 1) shift_[j] -= time * bodies.body[j].inverse_mass * impulse;
        }
}

void ContactSolver::remember(const Bodies& bodies, ImpulseMemory& memory)
{
    counts_.assign(bodies.size(), 0);
    const auto each = [&](const auto& visit) {
        for (std::size_t k = 0; k < resting_places_.count(); ++k)
            for (int lane = 0; lane < lanes; ++lane)
                if (owners_[k][static_cast<std::size_t>(lane)].body >= 0 && resting_[k].impulse[lane] > 0)
                    visit(resting_[k], owners_[k][static_cast<std::size_t>(lane)], lane, 1.0f);
        for (std::size_t k = 0; k < impact_places_.count(); ++k)
            for (int lane = 0; lane < lanes; ++lane)
                if (impact_owners_[k][static_cast<std::size_t>(lane)].body >= 0 && impacts_[k].impulse[lane] > 0)
                    visit(impacts_[k], impact_owners_[k][static_cast<std::size_t>(lane)], lane, 0.0f);
    };
    each([&](const ContactBatch&, const Owner& owner, int, float) { ++counts_[static_cast<std::size_t>(owner.body)]; });
    particles_.resize(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b)
        particles_[b] = bodies.label[b].atom;
    memory.reset(particles_, counts_);
    each([&](const ContactBatch& batch, const Owner& owner, int lane, float share) {
        Remembered entry{owner.partner, {}};
        for (int axis = 0; axis < 3; ++axis)
            entry.impulse[axis] =
                share * owner.sign * (batch.impulse[lane] * batch.normal[axis][lane] + batch.tangential[axis][lane]);
        memory.add(bodies.label[static_cast<std::size_t>(owner.body)].atom, entry);
    });
}

}  // namespace interphase::hard_sphere
