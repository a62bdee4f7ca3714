// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/plugin_fixes.hpp"

#include <algorithm>
#include <limits>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "fix.h"
#include "lammps.h"
#include "modify.h"
#include "plugin/plugin.hpp"

namespace interphase {

PluginFixes::PluginFixes(const LAMMPS_NS::LAMMPS& lmp, const std::vector<LoadedPlugin>& plugins,
                         const std::string& script)
    : script_(script)
{
    const LAMMPS_NS::Modify& modify = *lmp.modify;
    std::copy_if(modify.fix, modify.fix + modify.nfix, std::back_inserter(fixes_),
                 [&](const LAMMPS_NS::Fix* fix) { return plugin_with(fix->style, plugins) != nullptr; });
}

bool PluginFixes::has(const LAMMPS_NS::Fix& fix) const
{
    return std::find(fixes_.begin(), fixes_.end(), &fix) != fixes_.end();
}

std::optional<double> PluginFixes::step_limit(const Communicator& comm) const
{
    constexpr double none = std::numeric_limits<double>::max();
    double limit = none;
    std::optional<Problem> problem;
    for (LAMMPS_NS::Fix* fix : fixes_) {
        int dimension = 0;
        const auto* told = static_cast<const double*>(fix->extract(extract_solid_step_limit, dimension));
        if (!told) continue;
        if (!(*told > 0))
            problem = Problem{std::string("fix ") + fix->id + " (" + fix->style +
                                  ") says that it bears a solid step of at most " + text(*told) + " s",
                              script_, std::string("correct the plug-in's ") + extract_solid_step_limit};
        limit = std::min(limit, *told);
    }
    comm.fail_together(problem);
    limit = comm.min(limit);
    if (limit == none) return std::nullopt;
    return limit;
}

SolidStress* PluginFixes::solid_stress() const
{
    SolidStress* found = nullptr;
    std::string by;
    for (LAMMPS_NS::Fix* fix : fixes_) {
        int dimension = 0;
        auto* model = static_cast<SolidStress*>(fix->extract(extract_solid_stress, dimension));
        if (!model) continue;
        if (found)
            throw UserError("two fixes want the solids' stress on the gas mesh: " + by + " and " + fix->id, script_,
                            "keep one of them; it moves all particles");
        found = model;
        by = fix->id;
    }
    return found;
}

bool PluginFixes::say(const char* what) const
{
    for (LAMMPS_NS::Fix* fix : fixes_) {
        int dimension = 0;
        const auto* told = static_cast<const int*>(fix->extract(what, dimension));
        if (told && *told) return true;
    }
    return false;
}

}  // namespace interphase
