// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/communicator.hpp"
#include "settings/settings.hpp"
#include "step/solids.hpp"

namespace interphase {

/// The engine of the particles, after it has read the case's script.
class ParticleEngine : public Solids {
public:
    virtual std::string version() const = 0;  ///< its name and version
    virtual std::string plugins() const = 0;  ///< those loaded, with their styles; "none"

    /// The shortest collision time t_c [s], where the contact model tells.
    virtual std::optional<double> contact_duration() const = 0;

    /// The longest solid step [s] that the plug-ins bear, where one tells.
    virtual std::optional<double> step_limit() const = 0;

    virtual double largest_diameter() const = 0;   ///< of the tracked spheres [m]. Collective.
    virtual double smallest_diameter() const = 0;  ///< of the tracked spheres [m]. Collective.

    /// Sets the step [s] and readies the run of about `steps` steps, with or without a gas. Collective.
    virtual void start(double solid_step, long steps, bool with_gas) = 0;
};

using MakeParticleEngine = std::function<std::unique_ptr<ParticleEngine>(const Communicator&, const Settings&)>;

}  // namespace interphase
