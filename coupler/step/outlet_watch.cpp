// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/outlet_watch.hpp"

#include <map>

#include "step/step_counts.hpp"

namespace interphase {

namespace {

constexpr double packed = 0.3;    // solid fraction: a suspension that is carried through has less than a tenth
constexpr double at_rest = 0.01;  // of the gas's velocity out of the cell; particles that go along have most of it

}  // namespace

OutletWatch::OutletWatch(const Gas& gas, const Vector& gravity) : gas_(gas), gravity_(gravity)
{
    constexpr double slanting = 0.1;  // cosine: beside walls that lean a little nothing is held up
    for (const OpenFace& face : gas.open_faces())
        if (face.outwards.dot(gravity) < -slanting * gravity.norm()) above_.push_back(face);
}

void OutletWatch::observe(const Visitors& visitors, const Scalars& voidage, const Scalars& pressure_gradient)
{
    std::map<int, Vector> outwards;  // of the few cells that may hold something
    for (const OpenFace& face : above_)
        if (1 - voidage[static_cast<std::size_t>(face.cell)] > packed) outwards.emplace(face.cell, face.outwards);
    if (outwards.empty()) return;

    const Scalars gas_velocity = gas_.velocity();
    const GasProperty density = gas_.density();
    for (std::size_t i = 0; i < visitors.size(); ++i) {
        const auto found = outwards.find(visitors.cell[i]);
        if (found == outwards.end()) continue;
        const Vector& out = found->second;
        const auto c = static_cast<std::size_t>(found->first);
        const Visitor& visitor = visitors.visitor[i];
        const Vector velocity = to_vector(visitor.velocity);
        const double leaves = vector_at(gas_velocity, c).dot(out);
        if (leaves <= 0 || velocity.norm() > at_rest * leaves) continue;
        // the full pressure bears the fluid's own weight, too
        const double mass = (1 - voidage[c]) * visitor.mass / visitor.volume + voidage[c] * density.in(c);  // [kg/m3]
        if (-vector_at(pressure_gradient, c).dot(out) > -mass * gravity_.dot(out)) ++held_;
    }
}

Count OutletWatch::count() const { return {held_at_outlet, held_}; }

}  // namespace interphase
