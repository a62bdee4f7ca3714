// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"
#include "engines/liggghts/plugins/plugin_opener.hpp"
#include "engines/liggghts/solids/liggghts_solids.hpp"
#include "run/particle_engine.hpp"

namespace interphase {

/// Makes LIGGGHTS the engine of the particles, with the methods of its own and those of plug-ins.
class LiggghtsMaker : public ParticleEngineMaker {
public:
    explicit LiggghtsMaker(LaterStart later = {}) : later_(later) {}

    Methods methods(const std::vector<std::string>& plugins) const override;
    std::string plugin_with(const std::string& method) const override;
    std::unique_ptr<ParticleEngine> make(const Communicator& comm, const Settings& settings) const override;

private:
    Communicator comm_;
    LaterStart later_;
};

/// LIGGGHTS's own, and those of the plug-ins.
Methods methods_of(const std::vector<OpenPlugin>& plugins);

/// What fixes of the plug-ins count.
std::vector<CountKind> counts_of(const std::vector<OpenPlugin>& plugins);

}  // namespace interphase
