// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact_solver.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hard_sphere/collision.hpp"
#include "hard_sphere/contact_geometry.hpp"
#include "hard_sphere/impact.hpp"

namespace interphase::hard_sphere {

namespace {

constexpr int ahead = 12;  // pairs

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Distances from the two centres to the point of contact, a wall's being 0. Together they are the distance of the
/// centres then, which keeps angular momentum.
std::array<double, 2> arms(const Bodies& bodies, const Contact& contact)
{
    const double r_i = bodies.path[at(contact.i)].place.radius;
    if (contact.key < 0) return {r_i, 0};
    const double r_j = bodies.path[at(contact.j)].place.radius;
    const double shorter = 0.5 * std::min(contact.gap, 0.0);
    return {r_i + shorter, r_j + shorter};
}

Sphere sphere(const Body& body, double arm)
{
    return {to_vector(body.velocity), to_vector(body.spin), arm, body.inverse_mass, body.inverse_inertia};
}

void write(const Sphere& sphere, Body& body)
{
    set(body.velocity, sphere.velocity);
    set(body.spin, sphere.spin);
}

/// What the making of contacts will not set in lanes without one. They name the body that nothing moves.
void leave_empty(ContactBatch& batch, BatchNotes& notes, int resting_walls)
{
    for (int lane = 0; lane < lanes; ++lane) {
        batch.i[lane] = batch.j[lane] = resting_walls;
        notes.owner[lane] = 0;
        notes.materials[lane] = 0;
        notes.speed[lane] = 0;
        for (int axis = 0; axis < 3; ++axis)
            batch.tangential[axis][lane] = 0;
        batch.friction[lane] = batch.bounce[lane] = batch.tangential_bounce[lane] = 0;
    }
}

Overlap overlap_of(const Contact& contact)
{
    Overlap overlap{contact.i, contact.j, {}, static_cast<float>(contact.gap)};
    set(overlap.normal, contact.normal);
    return overlap;
}

}  // namespace

void ContactSolver::start(Bodies& bodies, const PairSearch& pairs, std::vector<Contact>& walls, const AnyLaw& law,
                          const StepLimits& limits, const ImpulseMemory& memory, int passes)
{
    step_ = limits.step;
    passes_ = 0;
    all_passes_ = passes;
    binary_ = 0;
    cluster_contacts_ = 0;
    const std::size_t n = bodies.body.size();
    for (Cluster* cluster : {&walls_, &spheres_}) {
        cluster->places.start(n);
        cluster->rolls = law.rolls();
        cluster->state_count = law.state_count();
    }
    overlaps_.clear();
    shift_.assign(n, Vector::Zero());

    binary_states_.clear();
    binary_pushes_.clear();
    recall(bodies, walls, law, memory);
    law.respond(bodies, walls.data(), walls.data() + walls.size(), step_);
    for (const Contact& contact : walls) {
        if (contact.gap < 0) overlaps_.push_back(overlap_of(contact));
        if (contact.touch && has(touches_one, contact.i))
            resolve_binary(bodies, contact);
        else if (has(in_cluster, contact.i))
            add_wall(bodies, contact, memory);
    }
    start_from_memory(bodies.body, walls_);

    add_pairs(bodies, pairs, law, limits, memory);
    make_ready(bodies, spheres_, law, limits, overlaps_);
}

void ContactSolver::add_pairs(Bodies& bodies, const PairSearch& pairs, const AnyLaw& law, const StepLimits& limits,
                              const ImpulseMemory& memory)
{
    const auto most = static_cast<std::size_t>(pairs.end() - pairs.begin());
    if (cluster_pairs_.size() < most) cluster_pairs_.resize(most);
    if (binary_pairs_.size() < most) binary_pairs_.resize(most);
    Pair *clustered = cluster_pairs_.data(), *binary = binary_pairs_.data();
    for (const Pair& pair : pairs) {
        const bool part = takes_part(bodies, pair), alone = (pair.touch != 0) & both_have(touches_one, pair);
        *clustered = *binary = pair;
        clustered += part & !alone;
        binary += part & alone;
    }

    resolve_binary(bodies, binary_pairs_.data(), binary, law, limits, memory);

    const std::size_t count = static_cast<std::size_t>(clustered - cluster_pairs_.data());
    const auto label_of_j = [&](std::size_t k) -> const Label& {
        return bodies.label[at(cluster_pairs_[std::min(k, count - 1)].j)];
    };
    for (std::size_t k = 0; k < count; ++k) {
        const auto [i, j, touch] = cluster_pairs_[k];
        __builtin_prefetch(&label_of_j(k + 2 * ahead));
        memory.fetch(label_of_j(k + ahead).remembered);
        const int materials = law.materials.between(bodies.label[at(i)].type, bodies.label[at(j)].type);
        add(spheres_, bodies, i, j, 0, materials, memory);
    }
}

std::vector<std::uint8_t>& ContactSolver::count_touches(const PairSearch& pairs, const std::vector<Contact>& walls)
{
    touches_ = pairs.touches();
    for (const Contact& contact : walls)
        count_touch(touches_[at(contact.i)], contact.touch);
    return touches_;
}

void ContactSolver::classify(const Bodies& bodies)
{
    roles_.resize(touches_.size());
    for (std::size_t b = 0; b < roles_.size(); ++b) {
        const bool ghost = bodies.label[b].ghost, fixed = bodies.label[b].fixed;
        roles_[b] = static_cast<std::uint8_t>((ghost | fixed ? ghost_or_fixed : 0) |
                                              (fixed | (touches_[b] == 1) ? touches_one : 0) |
                                              (fixed | (touches_[b] > 1) ? in_cluster : 0));
    }
}

bool ContactSolver::takes_part(const Bodies& bodies, const Pair& pair) const
{
    if (has(ghost_or_fixed, pair.i) || has(ghost_or_fixed, pair.j)) {
        const Label &a = bodies.label[at(pair.i)], &b = bodies.label[at(pair.j)];
        if (!resolves(a.id, a.ghost, b.id, b.ghost)) return false;
        if (a.fixed && b.fixed) return false;
    }
    return (pair.touch != 0) | both_have(in_cluster, pair);
}

std::vector<std::uint8_t>& ContactSolver::count_users(const Bodies& bodies, const PairSearch& pairs,
                                                      const std::vector<Contact>& walls)
{
    users_.assign(bodies.body.size(), 0);
    const auto use = [&](int body) {
        if (has(in_cluster, body)) users_[at(body)] = 1;
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

void ContactSolver::recall(const Bodies& bodies, std::vector<Contact>& contacts, const AnyLaw& law,
                           const ImpulseMemory& memory) const
{
    const int count = law.state_count();
    if (count == 0) return;
    for (Contact& contact : contacts) {
        const auto [owner, partner] = keeper(bodies, contact.i, contact.j, contact.key);
        const float* more = memory.more(memory.find(bodies.label[at(owner)].remembered, partner));
        std::copy_n(more + (law.rolls() ? 3 : 0), count, contact.state.data());
    }
}

ContactSolver::Keeper ContactSolver::keeper(const Bodies& bodies, int i, int j, int key)
{
    if (key < 0) return {i, key};
    const Label &a = bodies.label[at(i)], &b = bodies.label[at(j)];
    return a.id < b.id ? Keeper{i, b.id} : Keeper{j, a.id};
}

void ContactSolver::resolve_binary(Bodies& bodies, const Pair* first, const Pair* last, const AnyLaw& law,
                                   const StepLimits& limits, const ImpulseMemory& memory)
{
    constexpr std::ptrdiff_t at_a_time = 64;  // the law and the collision find them still near the processor
    binary_contacts_.reserve(at_a_time);
    for (; first != last; first += std::min(at_a_time, last - first)) {
        binary_contacts_.clear();
        for (const Pair* pair = first; pair != first + std::min(at_a_time, last - first); ++pair)
            binary_contacts_.push_back(contact_of_spheres(bodies, *pair, law.materials, limits));
        recall(bodies, binary_contacts_, law, memory);
        law.respond(bodies, binary_contacts_.data(), binary_contacts_.data() + binary_contacts_.size(), limits.step);
        for (const Contact& contact : binary_contacts_) {
            if (contact.gap < 0) overlaps_.push_back(overlap_of(contact));
            resolve_binary(bodies, contact);
        }
    }
}

void ContactSolver::resolve_binary(Bodies& bodies, const Contact& contact)
{
    const Response& response = contact.response;
    const auto i = at(contact.i), j = at(contact.j);
    const auto [arm_i, arm_j] = arms(bodies, contact);
    Sphere a = sphere(bodies.body[i], arm_i), b = sphere(bodies.body[j], arm_j);
    const double parting =
        contact.impact ? std::max(0.0, response.restitution * contact.speed - contact.later) : -contact.closing;
    const Vector impulse = contact_impulse(a, b, contact.normal, parting,
                                           contact.impact ? response.tangential_restitution : 0.0, response.friction);
    if (impulse.isZero(0)) return;
    ++binary_;
    if (walls_.state_count > 0 && !contact.impact)
        binary_states_.push_back({keeper(bodies, contact.i, contact.j, contact.key), contact.state});
    if (contact.key < 0) binary_pushes_.push_back({contact.i, contact.key, arm_i * contact.normal, impulse});
    apply_impulse(a, b, contact.normal, impulse);
    if (response.rolling_arm > 0) resist_rolling(a, b, contact.normal, impulse, response, contact.impact);
    if (contact.impact && contact.touch_time > 0) {
        // up to the collision the bodies move as they came
        shift_[i] += contact.touch_time * (to_vector(bodies.body[i].velocity) - a.velocity);
        shift_[j] += contact.touch_time * (to_vector(bodies.body[j].velocity) - b.velocity);
    }
    write(a, bodies.body[i]);
    write(b, bodies.body[j]);
}

BatchPlace ContactSolver::add(Cluster& cluster, const Bodies& bodies, int i, int j, int key, int materials,
                              const ImpulseMemory& memory)
{
    const Label &a = bodies.label[at(i)], &b = bodies.label[at(j)];
    const auto [owner, partner] = keeper(bodies, i, j, key);
    const bool a_owns = owner == i;
    const int remembered = memory.find(a_owns ? a.remembered : b.remembered, partner);
    const Remembered& last = memory.entry(remembered);

    const auto [k, lane] = cluster.places.place(i, j, a.fixed, b.fixed);
    cluster.reach(k);
    ContactBatch& batch = cluster.batches[k];
    BatchNotes& notes = cluster.notes[k];
    RollingBatch* rolling = cluster.rolling_of(k);
    if (lane == 0) {
        leave_empty(batch, notes, static_cast<int>(bodies.size()));
        if (rolling) *rolling = {};
        for (int s = 0; s < cluster.state_count; ++s)
            std::fill_n(cluster.state(k, s), lanes, 0.0f);
    }
    ++cluster_contacts_;
    batch.i[lane] = i;
    batch.j[lane] = j;
    notes.owner[lane] = owner;
    notes.partner[lane] = partner;
    const float sign = a_owns ? 1.0f : -1.0f;
    for (int axis = 0; axis < 3; ++axis)
        batch.tangential[axis][lane] = sign * last.impulse[axis];
    if (rolling)
        for (int axis = 0; axis < 3; ++axis)
            rolling->couple[axis][lane] = sign * memory.more(remembered)[axis];
    for (int s = 0; s < cluster.state_count; ++s)
        cluster.state(k, s)[lane] = memory.more(remembered)[(rolling ? 3 : 0) + s];
    // restitution is for bodies that meet, not for those that press on each other already
    notes.speed[lane] = static_cast<float>(remembered == 0);
    notes.materials[lane] = materials;
    return {k, lane};
}

void ContactSolver::add_wall(const Bodies& bodies, const Contact& contact, const ImpulseMemory& memory)
{
    const auto [k, lane] = add(walls_, bodies, contact.i, contact.j, contact.key, contact.materials, memory);
    ContactBatch& batch = walls_.batches[k];
    BatchNotes& notes = walls_.notes[k];
    const Response& response = contact.response;
    const auto [arm_i, arm_j] = arms(bodies, contact);
    for (int axis = 0; axis < 3; ++axis)
        batch.normal[axis][lane] = static_cast<float>(contact.normal[axis]);
    batch.arm_i[lane] = static_cast<float>(arm_i);
    batch.arm_j[lane] = static_cast<float>(arm_j);
    batch.mass[lane] =
        static_cast<float>(1 / (bodies.body[at(contact.i)].inverse_mass + bodies.body[at(contact.j)].inverse_mass));
    batch.closing[lane] = static_cast<float>(contact.closing);
    const bool bounces = contact.impact && notes.speed[lane] > 0;
    batch.bounce[lane] = bounces ? static_cast<float>(1 + response.restitution) : 0.0f;
    batch.tangential_bounce[lane] = static_cast<float>(1 + response.tangential_restitution);
    batch.friction[lane] = static_cast<float>(response.friction);
    if (walls_.rolls) walls_.rolling[k].arm[lane] = static_cast<float>(response.rolling_arm);
    for (int s = 0; s < walls_.state_count; ++s)
        walls_.state(k, s)[lane] = static_cast<float>(contact.state[static_cast<std::size_t>(s)]);
    notes.touch_time[lane] = static_cast<float>(contact.touch_time);
}

void ContactSolver::pass(std::vector<Body>& bodies, bool ends_forward)
{
    const int k = passes_++, release = all_passes_ / 2;
    const bool as_the_last = (all_passes_ - k) % 2 == 1;
    const bool forward = as_the_last == ends_forward;
    const Phase phase = k < release ? Phase::compression : k == release ? Phase::release : Phase::after_release;
    for (Cluster* cluster : {forward ? &walls_ : &spheres_, forward ? &spheres_ : &walls_})
        sweep(bodies, *cluster, forward ? Direction::forward : Direction::backward, phase);
}

}  // namespace interphase::hard_sphere
