// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"
#include "base/engine_warnings.hpp"
#include "settings/method.hpp"
#include "settings/settings.hpp"
#include "step/solids.hpp"

namespace interphase {

/// A plug-in that was loaded.
struct PluginBuild {
    std::string name, file;
    std::string sha256;  ///< of the file
};

/// The engine of the particles, after it has read the case's script.
class ParticleEngine : public Solids {
public:
    virtual std::string version() const = 0;  ///< its name and version
    virtual std::string plugins() const = 0;  ///< those loaded, with their styles; "none"

    /// Those that the run depends on: none while no fix of any is in it nor can come into it.
    virtual std::vector<PluginBuild> plugins_in_use() const { return {}; }

    /// The shortest collision time t_c [s], where the contact model tells.
    virtual std::optional<double> contact_duration() const = 0;

    /// The time [s] that a Rayleigh wave takes along the surface of the sphere that it crosses first, where the script
    /// gives elastic moduli.
    virtual std::optional<double> rayleigh_time() const { return std::nullopt; }

    /// The longest solid step [s] that the plug-ins bear, where one tells.
    virtual std::optional<double> step_limit() const = 0;

    /// The weights that particles still to be made are given in so many words [n]; the same on all ranks.
    virtual Scalars weights_to_come() const { return {}; }

    virtual double largest_diameter() const = 0;   ///< of the tracked spheres [m]. Collective.
    virtual double smallest_diameter() const = 0;  ///< of the tracked spheres [m]. Collective.

    /// Before start(): this run is to go on, at `time` [s], from what keep() took in, as "solids", which follows
    /// start(). `kept` outlives it.
    virtual void go_on_from(Archive& kept, double time) = 0;

    /// Why the state of this scene cannot be kept, if it cannot.
    virtual std::optional<Problem> cannot_be_kept() const { return std::nullopt; }

    /// What of the scene remembers something that begins anew in a run that goes on, in words; empty where nothing
    /// does.
    virtual std::string memories_lost() const { return {}; }

    /// Between two advance(): all that the next ones depend on; what it gives back takes the place of all particles.
    /// Views of particles are no longer valid. Collective.
    virtual void keep(Archive& archive) = 0;

    /// Sets the step [s] and readies the run of about `steps` steps, with or without a gas. Collective.
    virtual void start(double solid_step, long steps, bool with_gas) = 0;

    /// A gas step begins at `time` [s]: does what the case has for it by then. Returns what it did, in words.
    /// Collective.
    virtual std::vector<std::string> begin_gas_step(double /*time*/) { return {}; }

    /// The end has moved: about `steps` steps are left. After start(). Collective.
    virtual void end_after(long steps) = 0;

    /// What a user should know of the scene, which runs all the same: all that came up since the last call. After
    /// start(). Throws a UserError for what cannot go on. Collective.
    virtual std::vector<Problem> remarks() { return {}; }

    /// What is counted of it. Collective.
    virtual std::vector<Count> counts() const { return {}; }

    /// What fixes of plug-ins count and measure of themselves, always the same kinds. Collective.
    virtual std::vector<Count> counters() const { return {}; }

    /// What it warned of so far; null where it has no words of its own.
    virtual EngineWarnings* warnings() { return nullptr; }
};

/// Makes the engine of the particles once the case's settings are read, for which it tells the methods.
class ParticleEngineMaker : public MethodSource {
public:
    /// Collective.
    virtual std::unique_ptr<ParticleEngine> make(const Communicator& comm, const Settings& settings) const = 0;
};

}  // namespace interphase
