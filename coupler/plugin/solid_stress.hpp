// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Plug-ins outside this tree see this file, too, through plugin.hpp: it stands alone.
#include <cfloat>

namespace interphase {

/// What the gas mesh knows where a particle is, at the start of a gas step, and what the model made of it.
struct StressState {
    double gradient[3] = {0, 0, 0};       ///< of the solid stress [Pa/m]
    double solid_fraction = 0;            ///< above 0 wherever there is a particle, its own volume included
    double mean_velocity[3] = {0, 0, 0};  ///< of the solids, weighted by mass [m/s]
    double closing_speed[3] = {0, 0,
                               0};    ///< at which the mean motion compresses the cell, by axis; 0: it does not [m/s]
    double cell_size[3] = {0, 0, 0};  ///< of the gas cell that holds the centre [m]; 0: in no cell
    double relaxation_time = 0;       ///< mass over drag rate, of the drag law at the actual slip [s]

    /// Written by the model: by how much the stress changed the velocity in this gas step [m/s]. It is taken as a force
    /// that acted all through each solid step, so that drag gave back its share: a bed that its stress holds at rest
    /// has the drag of one at rest, however long the step.
    double change[3] = {0, 0, 0};
};

/// Particles of a rank for which a gas step was too long (a warning each, not an error).
struct StepTooLong {
    long crossing_cells = 0;     ///< they may cross more than the allowed part of a cell
    long beyond_relaxation = 0;  ///< it is longer than the allowed part of their relaxation time
    double longest = DBL_MAX;    ///< the step that no particle would find too long [s]
};

/// A collision model that needs a stress of the solids on the gas mesh, instead of contacts (MP-PIC). Where there is
/// one, the coupler computes the stress of each gas cell once a gas step, from the solid fraction at its start, and
/// lets each particle know its gradient.
class SolidStress {
public:
    virtual ~SolidStress() = default;

    /// tau [Pa] of a solid fraction from 0 to 1, finite and not below 0.
    virtual double stress(double solid_fraction) const = 0;

    /// Solid fraction above which no bed can be packed. Cells beyond it are counted.
    virtual double close_packing() const = 0;

    /// Whether a cell beyond close packing at the very start ends the run.
    virtual bool refuses_overfilled_start() const = 0;

    /// One for each particle that the rank owns, in the particle engine's order; the coupler writes them.
    virtual StressState* states() = 0;

    /// The states are written and hold for the coming gas step of `gas_step` seconds. Collective.
    virtual StepTooLong begin(double gas_step) = 0;

    /// Why the run cannot take this gas step ("what\n  where:  ...\n  remedy: ..."), of this rank, or null. After
    /// begin().
    virtual const char* complaint() const = 0;
};

}  // namespace interphase
