// SPDX-License-Identifier: GPL-3.0-or-later
//
// What travels between particles and cells in a coupling step. To the gas cells: a Visitor, and with it an Owed (the
// particles act on the gas), a Restraint (the step is so long that contacts change what is asked), a Momentum (there is
// a solid stress). Back home: an Answer, and with it an AddedMass (a term has one), a StressAnswer.
#pragma once

namespace interphase {

/// A particle at its gas cell.
struct Visitor {
    double position[3];
    double velocity[3];  ///< with which it begins the step
    double diameter;     ///< of the real particle
    double volume;       ///< of solids in the tracked one
    double mass;         ///< of the tracked one
};

/// What it took in the last gas step beyond what the gas gave [kg m/s].
struct Owed {
    double impulse[3];
};

/// What shows how contacts hold it: what they changed in its momentum in the last gas step, what would have changed
/// without them, and by gravity alone [kg m/s].
struct Restraint {
    double by_contacts[3];
    double without_contacts[3];
    double weight;
};

struct Momentum {
    double momentum[3];
    double mass;
};

/// What the gas does to it in this step.
struct Answer {
    double drag_rate;           ///< [kg/s]
    double gas_velocity[3];     ///< [m/s]
    double force[3];            ///< by all terms but drag and added mass [N]
    double assumed_impulse[3];  ///< what the gas solve took from the gas for it [kg m/s]
};

struct AddedMass {
    double mass;
};

/// What the mesh knows of the solids' stress where it is (StressState).
struct StressHere {
    double gradient[3];
    double solid_fraction;
    double mean_velocity[3];
    double closing_speed[3];
};

struct StressAnswer {
    StressHere here;
    double cell_size[3];
};

}  // namespace interphase
