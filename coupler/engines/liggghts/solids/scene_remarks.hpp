// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"
#include "base/problem.hpp"
#include "engines/liggghts/plugins/plugin_fixes.hpp"
#include "settings/settings.hpp"

namespace interphase {

/// What is doubtful in a scene and runs all the same: told once each, and counted.
class SceneRemarks {
public:
    SceneRemarks(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp, const Settings& settings,
                 const std::vector<LoadedPlugin>& plugins);

    /// What there is to be said now that was not before: the first time of the scene, later of what came and of
    /// contacts that the solid step does not resolve. A UserError where particles that came are moved twice.
    /// Collective.
    std::vector<Problem> now();
    std::vector<Count> counts() const;

    void keep(Archive& archive)
    {
        archive.keep("overlaps", overlaps_);
        archive.keep("unmoved", unmoved_);
        archive.keep("fast_steps", fast_steps_);
    }

private:
    std::vector<Problem> of_scene();
    std::vector<Problem> of_overlaps();
    std::optional<Problem> of_unmoved();
    std::optional<Problem> of_fast_contacts();
    bool has_fix(const char* start_of_style) const;

    Communicator comm_;
    LAMMPS_NS::LAMMPS& lmp_;
    const Settings& settings_;
    const std::vector<LoadedPlugin>& plugins_;
    bool may_touch_too_fast_;                           ///< contacts by Hertz's law
    bool looked_at_ = false;                            ///< the scene
    long overlaps_ = 0, unmoved_ = 0, fast_steps_ = 0;  ///< at the start; at present; gas steps
};

}  // namespace interphase
