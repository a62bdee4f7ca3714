// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hard_sphere/attraction.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/cluster.hpp"
#include "hard_sphere/contact.hpp"
#include "hard_sphere/law.hpp"
#include "hard_sphere/material.hpp"

namespace interphase::hard_sphere {

/// A law as the solver sees it: asked for many contacts at a time. law_of.hpp makes one of a class as in law.hpp.
class AnyLaw {
public:
    virtual ~AnyLaw() = default;

    virtual const std::vector<MaterialProperty>& properties() const = 0;

    /// Of a number of types; what they are is to be filled in.
    Materials& start(int types) { return materials = Materials(types, properties().size()); }

    /// Fills in what each contact's response is, and renews its state. `step`: the step's length [s].
    virtual void respond(const Bodies& bodies, Contact* first, const Contact* last, double step) const = 0;

    /// The same for the batches [first, last) of a cluster, which are ready but for it. `width`: how many contacts are
    /// taken at once.
    virtual void respond(Cluster& cluster, std::size_t first, std::size_t last, double step, int width) const = 0;

    /// How many numbers the state of a contact has.
    virtual int state_count() const = 0;

    /// Whether it resists rolling.
    virtual bool rolls() const = 0;

    /// Up to which gap bodies draw each other; 0: they do not [m].
    virtual double longest_range() const = 0;

    /// Fills in the force of each.
    virtual void attract(std::vector<Attraction>& attractions) const = 0;

    /// What of its answers between spheres of these sizes is none; nothing where all is well.
    virtual std::string complaint(const Sizes& sizes) const = 0;

    Materials materials;
};

}  // namespace interphase::hard_sphere
