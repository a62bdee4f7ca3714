// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/contact.hpp"
#include "hard_sphere/contact_batch.hpp"
#include "hard_sphere/law.hpp"
#include "hard_sphere/material.hpp"

namespace interphase::hard_sphere {

/// A law as the solver sees it: asked for many contacts at a time. law_of.hpp makes one of a class as in law.hpp.
class AnyLaw {
public:
    virtual ~AnyLaw() = default;

    virtual const std::vector<Property>& properties() const = 0;

    /// Of a number of types; what they are is to be filled in.
    Materials& start(int types) { return materials = Materials(types, properties().size()); }

    /// Fills in what each contact's response is.
    virtual void respond(const Bodies& bodies, Contact* first, const Contact* last) const = 0;

    /// The same for contacts of clusters, which are ready but for it. `width`: how many at once.
    virtual void respond(ContactBatch* batches, const BatchNotes* notes, std::size_t count, int width) const = 0;

    Materials materials;
};

}  // namespace interphase::hard_sphere
