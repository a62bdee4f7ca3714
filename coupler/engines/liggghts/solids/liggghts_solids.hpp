// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engines/liggghts/plugins/plugin_counters.hpp"
#include "engines/liggghts/plugins/plugin_loader.hpp"
#include "engines/liggghts/script/earlier_files.hpp"
#include "engines/liggghts/script/last_words.hpp"
#include "engines/liggghts/script/listening_screen.hpp"
#include "engines/liggghts/solids/command_queue.hpp"
#include "engines/liggghts/solids/insertions.hpp"
#include "engines/liggghts/solids/scene_remarks.hpp"
#include "run/particle_engine.hpp"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace interphase {

class FixFluid;
class FixPopulation;

/// How a run starts that is not the first in its case.
struct LaterStart {
    double time = 0;       ///< of the gas's first fields [s]
    bool resumes = false;  ///< from a checkpoint: go_on_from() will follow
    bool is_one() const { return resumes || time > 0; }
};

/// LIGGGHTS, unmodified, as the engine of the particles.
class LiggghtsSolids : public ParticleEngine {
public:
    /// Runs the case's script (in the current folder). An error in it ends the program, with LIGGGHTS's own words and
    /// the line it choked on. `later`: files of the run before stay. Collective.
    LiggghtsSolids(const Communicator& comm, const Settings& settings, LaterStart later = {});
    ~LiggghtsSolids() override;

    std::optional<double> contact_duration() const override { return contact_duration_; }
    std::optional<double> rayleigh_time() const override { return rayleigh_time_; }
    std::optional<double> step_limit() const override { return step_limit_; }
    std::string plugins() const override { return described(plugins_); }
    std::vector<PluginBuild> plugins_in_use() const override;
    double largest_diameter() const override;
    double smallest_diameter() const override;
    void go_on_from(Archive& kept, double time) override;
    void start(double solid_step, long steps, bool with_gas) override;
    std::vector<std::string> begin_gas_step(double time) override;
    void end_after(long steps) override;
    std::optional<Problem> cannot_be_kept() const override;
    std::string memories_lost() const override;
    void keep(Archive& archive) override;

    ParticleView particles() override;
    Vector gravity() const override { return gravity_; }
    PeriodicBox periods() const override;
    const std::vector<Departure>& departures() const override;
    const std::vector<std::size_t>& arrivals() const override;
    Scalars radii_to_come() const override;
    Scalars weights_to_come() const override;
    bool kicks_before_moving() const override { return !moves_come_first_; }
    bool takes_new_forces() const override { return takes_new_forces_; }
    void kick_again(std::size_t i, const Vector& velocity, const Vector& force) override;
    SolidStress* solid_stress() override { return solid_stress_; }
    void advance(int substeps) override;

    std::string version() const override;

    std::vector<Problem> remarks() override;
    std::vector<Count> counts() const override;
    std::vector<Count> counters() const override { return counters_.now(comm_); }
    static std::vector<const CountKind*> count_kinds();  ///< what counts() may have
    EngineWarnings* warnings() override;                 ///< flushed

private:
    void refuse_faster_contacts() const;
    void add_own_fixes(bool with_gas);
    void set_up();
    void repeat_commands();
    void carry_out(const std::vector<TimedCommands>& commands);
    void refuse_other_scene();

    Communicator comm_;
    const Settings& settings_;
    LaterStart later_;
    EarlierFiles earlier_;
    std::vector<Problem> told_;  ///< to be, of the start
    EngineWarnings warnings_{"LIGGGHTS", LastWords::log_name};
    std::unique_ptr<ListeningScreen> screen_;
    LAMMPS_NS::LAMMPS* lmp_ = nullptr;
    FixFluid* fluid_ = nullptr;
    FixPopulation* population_ = nullptr;
    const LAMMPS_NS::Fix* weights_ = nullptr;  ///< the script's, or null: all have that of the settings
    std::vector<LoadedPlugin> plugins_;
    CommandQueue commands_;
    PluginCounters counters_;
    std::optional<double> contact_duration_, rayleigh_time_, step_limit_;
    SolidStress* solid_stress_ = nullptr;  ///< a fix's
    bool moves_come_first_ = false, takes_new_forces_ = false;
    Vector gravity_ = Vector::Zero();
    std::unique_ptr<SceneRemarks> remarks_;
    Archive* kept_ = nullptr;  ///< that this run is to go on from
    std::vector<SpheresToCome> to_come_;
    double largest_known_radius_ = 0;  ///< of those there are and will be, at the start [m]
};

}  // namespace interphase
