// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase {

/// What has come or gone in one way since the start.
struct Passage {
    double particles = 0;
    double volume = 0;               ///< of solids, or of gas [m3]
    double momentum[3] = {0, 0, 0};  ///< [kg m/s]

    void add(double solid_volume, const Vector& its_momentum)
    {
        particles += 1;
        volume += solid_volume;
        for (int axis = 0; axis < 3; ++axis)
            momentum[axis] += its_momentum[axis];
    }
};

/// The ways by which particles come and go, and the gas that makes room for their volume or takes it. A record of
/// doubles.
struct PopulationTotals {
    Passage inserted;
    Passage left_through_boundary;  ///< of the particles' domain
    Passage deleted_by_mesh;
    Passage deleted_by_script;
    Passage left_gas_mesh;  ///< and moved on without gas
    Passage entered_gas_mesh;
    Passage gas_displaced;  ///< by volume that came without crossing a face; its `particles` stay 0
    Passage gas_restored;   ///< where volume went likewise

    double came() const { return inserted.particles; }
    double went() const
    {
        return left_through_boundary.particles + deleted_by_mesh.particles + deleted_by_script.particles;
    }
};

/// Calls visit(key, words, passage) for each; the one place that names them.
template <class Totals, class Visit>
void visit_passages(Totals& totals, const Visit& visit)
{
    visit("inserted", "inserted", totals.inserted);
    visit("left_through_boundary", "left through the boundary of the particles' domain", totals.left_through_boundary);
    visit("deleted_by_mesh", "deleted by a mesh (massflow/mesh)", totals.deleted_by_mesh);
    visit("deleted_by_script", "deleted by other fixes", totals.deleted_by_script);
    visit("left_gas_mesh", "left the gas mesh", totals.left_gas_mesh);
    visit("entered_gas_mesh", "came into the gas mesh", totals.entered_gas_mesh);
    visit("gas_displaced", "gas displaced by what came", totals.gas_displaced);
    visit("gas_restored", "gas in the place of what went", totals.gas_restored);
}

}  // namespace interphase
