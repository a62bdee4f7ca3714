// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>
#include <vector>

#include "base/archive.hpp"
#include "forces/drag/drag.hpp"
#include "forces/terms.hpp"
#include "mapping/mapping.hpp"
#include "momentum/drag_response.hpp"
#include "momentum/reaction.hpp"
#include "settings/settings.hpp"
#include "step/gas.hpp"
#include "step/visitors.hpp"

namespace interphase {

/// What gas and particles do to each other in a step: evaluates all interphase terms at the visitors of this rank's
/// cells, sums what they ask of the gas, and tells each what the gas then does to it.
class InterphaseForces {
public:
    InterphaseForces(const Settings& settings, Gas& gas, const Mapping& mapping, const Vector& gravity);

    const Needs& needs() const { return needs_; }

    /// Whether a step of `duration` [s] is so long for some particle of any rank that contacts and the pressure
    /// gradient change what the particles ask of the gas.
    bool is_long(double duration) const;

    struct Step {
        double duration;  ///< [s]
        bool is_long;
        Motion motion;
    };
    /// Before the gas is solved: how each visitor responds to the gas, and, two-way, what that makes of the Demand (all
    /// but gas_share and surplus). `voidage` [own cells]. Collective.
    void ask(const Visitors& visitors, const Scalars& voidage, const Step& step, Demand& demand);

    /// After it: what each visitor takes home. Collective.
    void answer(const Visitors& visitors, std::vector<Answer>& answers, std::vector<AddedMass>& added_masses);

    /// What the gas gave in the last step, from the cells' side [kg m/s].
    Vector given_by_gas(const Scalars& solid_volume, const Demand& demand) const;

    const Scalars& pressure_gradient() const { return pressure_gradient_; }  ///< of the last solve [n x 3, Pa/m]
    /// Most gas cells that a wave of the solid fraction on this rank crosses in the last step.
    double wave_crossing() const { return wave_crossing_; }
    /// Drag rate over mass of the fastest particle in the last step [1/s]: of this rank, until it is told of all.
    double fastest_relaxation() const { return fastest_relaxation_; }
    void set_fastest_relaxation(double of_all_ranks) { fastest_relaxation_ = of_all_ranks; }

    /// What the terms have counted, on this rank.
    std::vector<Count> counts() const;

    void keep(Archive& archive);

private:
    /// The gas where a particle is, before it is solved; and what steps that are long ask for besides.
    struct GasHere {
        double voidage;
        double velocity[3];
    };
    struct LastStepHere {
        double held, doubt;
        double pressure_gradient[3];
    };
    struct SolvedHere {
        double velocity[3];
        double pressure_gradient[3];
    };
    struct PropertiesHere {
        double density, viscosity;
    };
    struct GradientHere {
        double of_velocity[9];
    };
    struct ViscousForceHere {
        double force[3];
    };

    void judge_contacts(const Visitors& visitors);
    void look_at_gas(const Visitors& visitors, const Scalars& voidage);
    void look_at_sizes(const Visitors& visitors);
    /// All of it but gravity and duration, which hold for the step.
    void look_at(const Visitors& visitors, std::size_t i, ParticleInGas& at) const;
    void note_wave(const ParticleInGas& at, const Response& response);
    void sum_over_cells(Demand& demand) const;

    const Settings& settings_;
    Gas& gas_;
    const Mapping& mapping_;
    Vector gravity_;
    Terms terms_;  ///< all but drag
    Drag drag_;
    Needs needs_;

    Step step_{};
    bool first_step_ = true;
    Scalars cell_size_;          ///< own cells: cube roots of their volumes [m]
    std::vector<Hold> hold_;     ///< own cells: by contacts
    Scalars pressure_gradient_;  ///< own cells [n x 3, Pa/m]

    // at the visitors
    std::vector<GasHere> here_;
    std::vector<LastStepHere> last_step_;
    std::vector<PropertiesHere> properties_;
    std::vector<GradientHere> gradients_;
    std::vector<ViscousForceHere> viscous_forces_;
    std::vector<double> mean_diameters_;
    std::vector<Response> responses_;
    std::vector<Reaction> reactions_;
    std::vector<SolvedHere> solved_;

    Scalars gas_velocity_;  ///< own cells, after the solve [n x 3, m/s]
    double fastest_relaxation_ = DBL_MAX;
    double wave_crossing_ = 0;
};

}  // namespace interphase
