// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/method_page.hpp"

#include <cstdio>

namespace interphase {

namespace {

std::string step_of(const Method& method)
{
    if (!method.single_collisions) return "gas step";
    char step[32];
    std::snprintf(step, sizeof step, "t_c/%g", method.steps_per_collision);
    return step;
}

std::string row_of(const Method& method)
{
    const char* owner = method.collisions_of_plugin ? "any plug-in" : "LIGGGHTS";
    const char* contacts = !method.single_collisions ? "none" : method.resolves_contacts ? "resolved" : "single";
    std::string row = "|";
    for (const std::string& cell :
         {"`" + method.name + "`", method.plugin.empty() ? std::string(owner) : "`" + method.plugin + "`",
          std::string(method.tracks_parcels ? "parcels" : "particles"),
          method.with_parcels.empty() ? std::string("") : "`" + method.with_parcels + "`", std::string(contacts),
          step_of(method), std::string(method.bears_pair_style ? "yes" : "no"), method.about})
        row += " " + cell + (cell.empty() ? "|" : " |");
    return row + "\n";
}

}  // namespace

std::string method_page(const Methods& methods)
{
    std::string page =
        "# Collision methods\n\nAs `interphase -help methods` prints them, those of LIGGGHTS and of plug-ins at hand; "
        "`interphase -help methods PLUGIN...` tells of plug-ins by name or path.\n\n"
        "- `method NAME;` in `system/couplingDict`, or `tools/run CASE --method NAME`, chooses one. Those of a plug-in "
        "need "
        "it in `plugins (...)`, and `any plug-in` is for a plug-in that brings no method.\n"
        "- One that tracks particles has weight 1; beside it stands the one to take for parcels.\n"
        "- Contacts are `resolved` over at least ten solid steps each, `single` ones are resolved in a step, and with "
        "`none` "
        "spheres feel each other through a mean.\n"
        "- The solid step is told where the case does not give one; t_c is the time of a collision by the script's kn "
        "and "
        "coefficientRestitution, where it has them. plugins/README.md tells what there is without.\n"
        "- A pair style of LIGGGHTS that collides is refused where it would count twice.\n\n"
        "| method | of | tracks | for parcels | contacts | solid step | pair style | collisions by |\n"
        "|---|---|---|---|---|---|---|---|\n";
    for (const Method& method : methods)
        page += row_of(method);
    return page;
}

}  // namespace interphase
