// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/communicator.hpp"
#include "engines/liggghts/plugins/plugin_loader.hpp"
#include "plugin/solid_stress.hpp"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace interphase {

/// The fixes of a script that are of plug-ins, and what these say of themselves (plugin/plugin.hpp).
class PluginFixes {
public:
    PluginFixes(const LAMMPS_NS::LAMMPS& lmp, const std::vector<LoadedPlugin>& plugins, const std::string& script);

    bool any() const { return !fixes_.empty(); }
    const std::vector<LAMMPS_NS::Fix*>& all() const { return fixes_; }
    bool has(const LAMMPS_NS::Fix& fix) const;

    /// The longest solid step that all of them bear [s], if one says so. A UserError where that is not above 0.
    /// Collective.
    std::optional<double> step_limit(const Communicator& comm) const;
    /// The model of the one that wants a stress of the solids on the gas mesh, or null. A UserError where two do.
    SolidStress* solid_stress() const;
    /// Whether one of them says so.
    bool say(const char* what) const;

private:
    std::vector<LAMMPS_NS::Fix*> fixes_;
    std::string script_;
};

}  // namespace interphase
