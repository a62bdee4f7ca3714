// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cfloat>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/count.hpp"
#include "base/stopwatch.hpp"
#include "exchange/owner_cell_search.hpp"
#include "exchange/owner_exchange.hpp"
#include "mapping/mapping.hpp"
#include "momentum/ledger.hpp"
#include "settings/settings.hpp"
#include "step/cell_solids.hpp"
#include "step/gas.hpp"
#include "step/interphase_forces.hpp"
#include "step/outlet_watch.hpp"
#include "step/population_watch.hpp"
#include "step/solids.hpp"
#include "step/step_watch.hpp"
#include "step/stress_exchange.hpp"

namespace interphase {

/// One lockstep of gas and particles.
class CouplingStep {
public:
    CouplingStep(const Communicator& comm, const Settings& settings, Gas& gas, Solids& solids, Stopwatch& stopwatch);

    /// The time that messages count from [s]; 0 at first.
    void start_at(double time) { watch_.start_at(time); }

    /// Before the first step: voidage() becomes that of the particles where they start. Throws as advance() does.
    /// Collective.
    void look_at_start();

    /// Advances gas and particles by `dt` = `substeps` solid steps. Throws a UserError on all ranks if a particle is
    /// outside the mesh, a packing cannot be relieved, a value is not finite or a weight below 1. Collective.
    void advance(double dt, int substeps);

    /// How the particles that are there, and those to come, are mapped to cells, in words. Collective.
    std::string mapping_description();

    const Ledger& ledger() const { return ledger_; }
    /// What came and went so far, on all ranks. Collective.
    const PopulationTotals& population() const { return population_.of_all_ranks(); }
    const Scalars& voidage() const { return voidage_; }
    /// The solids of the own cells as voidage() has them, at the velocities with which they began the step [n].
    /// Collective.
    std::vector<CellSolids> solids_in_cells() const;
    /// What the next gas step should not exceed, the same on all ranks [s]: what the solid stress bore in the last one
    /// (eq. 28 of the paper), and what the stability watch asks for.
    double longest_step() const { return std::min(stress_ ? stress_->longest_step() : DBL_MAX, watch_.longest_step()); }
    /// What the watch on stability has to tell of the last gas step; empty where there is nothing new.
    const std::string& news() const { return watch_.news(); }

    /// What was clamped, left a range or was told so far, on all ranks: cells cell by cell and particles particle by
    /// particle, step by step. Collective.
    std::vector<Count> counts() const;

    /// What the counts are parts of, but for the particles.
    Wholes wholes() const;

    /// What the next step needs of those before, beside what gas and particles have: with it a run goes on as if it had
    /// not been interrupted.
    void keep(Archive& archive);

    /// Bytes that this rank has sent to others in the exchange of particle and cell data so far.
    std::size_t bytes_sent() const;

private:
    template <class Record>
    struct Homeward {
        std::vector<Record> of_visitors, arrived;  ///< as sent, as arrived
    };

    void inspect_start();
    void place_in_periods(const ParticleView& particles);
    VectorsView images_of(const ParticleView& particles) const;
    void bring_particles_to_their_cells();
    void restore_gas_of_those_outside(const ParticleView& particles);
    void restore_gas_of_departures();
    void restore_gas(const std::vector<CellAddress>& homes);
    void restore_gas_in(const std::vector<CellAddress>& cells, const Scalars& volumes);
    void note_newcomers(const ParticleView& particles);
    void displace_gas_of_newcomers();
    std::vector<double> at_visitors(std::vector<double> of_travellers) const;
    void place_visitors();
    void map_voidage();
    void take_voidage(const Scalars& solid_volume);
    void map_solid_stress();
    void ask_for_forces(double dt);
    void solve_gas(double dt);
    void return_gas_to_particles(double dt);
    void leave_without_gas(const ParticleView& particles, std::size_t i);
    void move_particles(int substeps);
    void book();
    void book_solids(const ParticleView& particles);

    bool needs_solid_volume() const { return settings_.two_way || stress_; }
    bool asks_for_restraint() const { return settings_.two_way && long_step_; }
    Vector starting_velocity(const ParticleView& particles, std::size_t i) const;
    Vector impulse_to_take_back(const ParticleView& particles, std::size_t i) const;
    void kick_again(const ParticleView& particles, std::size_t i, const Vector& velocity, const Vector& others);
    Owed owed_to(const ParticleView& particles, std::size_t i) const;
    Restraint restraint_of(const ParticleView& particles, std::size_t i) const;
    void take_home(const ParticleView& particles, std::size_t i, const Answer& answer, double added_mass, double dt);
    void refuse_other_periods() const;
    void refuse_particles_outside(const ParticleView& particles) const;
    std::optional<Problem> trouble(const ParticleView& particles) const;

    Communicator comm_;
    const Settings& settings_;
    Gas& gas_;
    Solids& solids_;
    Stopwatch& stopwatch_;

    OwnerCellSearch owner_cell_search_;
    OwnerExchange owner_exchange_;
    Mapping mapping_;
    InterphaseForces forces_;
    Ledger ledger_;
    StepWatch watch_;
    OutletWatch outlets_;
    PopulationWatch population_;
    SolidStress* stress_model_;
    std::optional<StressExchange> stress_;  ///< of a model that wants it

    PeriodicBox periods_;
    Vectors images_;  ///< of the particles, within the periodic box; empty where there is none [m]
    std::vector<CellAddress> owner_cells_;
    std::vector<Vector> starts_;      ///< velocity with which each particle with an owner cell begins the step [m/s]
    Visitors travellers_, visitors_;  ///< as sent, as arrived
    Vectors positions_;               ///< of the visitors [m]
    Scalars volumes_;                 ///< of the visitors [m3]
    Homeward<Answer> answers_;
    Homeward<AddedMass> added_masses_;
    Homeward<StressAnswer> of_stress_;
    Scalars voidage_;       ///< own cells
    Scalars solid_volume_;  ///< own cells [m3]
    Scalars gas_volume_;    ///< own cells, by what has flowed in and out [m3]
    /// Of the particles with an owner cell: 1 where the gas did not have it in the last step.
    std::vector<double> newcomers_;
    double displaced_ = 0, restored_ = 0;  ///< gas volume that gave way, or came back, in this step [m3]
    Demand demand_;
    double cells_;  ///< of all ranks
    bool inspected_ = false;
    bool knows_last_step_ = false;  ///< where it mapped whom; a run that goes on from saved state does not at first
    double solid_step_ = 0;
    bool long_step_ = true;     ///< so long for some particle that contacts and pressure change what it asks of the gas
    bool kicks_again_ = false;  ///< the solids begin this gas step with its own forces
    long outside_ = 0, beyond_edge_ = 0;
    long relieved_ = 0;
    long pushed_ = 0;
    double booked_in_ = 0, booked_out_ = 0;  ///< solid volume that came and went, as far as it is in the ledger [m3]
};

}  // namespace interphase
