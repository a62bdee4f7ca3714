// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/read_settings.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "forces/drag/drag_law.hpp"
#include "forces/terms.hpp"
#include "settings/read_statistics.hpp"
#include "settings/reader.hpp"

namespace interphase {

namespace {

std::vector<std::string> names_of(const Methods& methods)
{
    std::vector<std::string> names;
    for (const Method& method : methods)
        names.push_back(method.name);
    return names;
}

void read_method(Reader& dict, Settings& settings, const MethodSource& source)
{
    dict.names({"plugins", "plug-ins with collision methods and fix styles for the script, by name or \"path\""},
               settings.plugins);
    const Methods methods = source.methods(settings.plugins);
    std::string name = methods.front().name;
    if (const std::string given = dict.word("method"); !given.empty()) {
        const auto is_it = [&given](const Method& method) { return method.name == given; };
        const std::string plugin = std::none_of(methods.begin(), methods.end(), is_it) ? source.plugin_with(given) : "";
        if (!plugin.empty())
            throw dict.complaint(
                "method", "`method " + given + ";` is of the plug-in " + plugin + ", which `plugins` does not name",
                "add `plugins (" + plugin + ");`");
    }
    dict.choice(
        {"method",
         "who handles collisions: pair styles of LIGGGHTS, a method that one of the `plugins` brings, or one that "
         "brings none (PLUGIN); `interphase -help methods` tells of them all"},
        name, names_of(methods));
    settings.method =
        *std::find_if(methods.begin(), methods.end(), [&](const Method& each) { return each.name == name; });
    if (settings.method.collisions_of_plugin && settings.plugins.empty())
        throw dict.complaint("method", "`method " + name + ";` takes its collisions from a plug-in, and none is named",
                             "add `plugins (NAME);` with the name or \"path\" of yours");
    dict.number({"weight", "real particles per tracked one, unless the script gives each its own"}, settings.weight,
                at_least(1));
    if (!settings.method.tracks_parcels && settings.weight != 1)
        throw dict.complaint(
            "weight", "`weight " + text(settings.weight) + ";` with method " + name + ", which tracks real particles",
            or_with_parcels("set `weight 1;`", settings.method));
}

/// How long a solid step is: given, or by one of two rules.
void read_solid_step(Reader& dict, Settings& settings)
{
    const Method& method = settings.method;
    const bool resolved = method.resolves_contacts;
    settings.steps_per_collision = method.steps_per_collision;
    dict.number({"stepsPerCollision",
                 "solid steps in the time of one collision: 10 to 60 are usual where they resolve it; elsewhere the "
                 "time is that of a DEM",
                 "", "as the method says", "at least 10 (where a plug-in collides: above 0)"},
                settings.steps_per_collision, resolved ? at_least(10) : above(0));
    dict.number(
        {"solidStep", "time of a solid step, where it is given instead", "s", "the collision time / stepsPerCollision"},
        settings.solid_step, above(0));
    dict.number({"largestOverlap",
                 "part of the tracked diameter that two spheres may overlap: sets the solid step, with impactSpeed, "
                 "where a plug-in collides",
                 "", "none"},
                settings.largest_overlap, between(0, 1));
    dict.number({"impactSpeed", "speed at which spheres meet, for largestOverlap", "m/s", "none"},
                settings.impact_speed, above(0));

    if (!method.single_collisions)
        for (const char* key : {"stepsPerCollision", "largestOverlap", "impactSpeed"})
            if (dict.has(key))
                throw dict.complaint(
                    key, std::string(key) + " with method " + method.name + ", which has no single collisions",
                    "leave it away for the gas step, or give solidStep");
    for (const char* key : {"largestOverlap", "impactSpeed"})
        if (resolved && dict.has(key))
            throw dict.complaint(
                key, std::string(key) + " with method " + method.name + ", whose step has to resolve each contact",
                "give stepsPerCollision or solidStep instead");
    if (dict.has("largestOverlap") != dict.has("impactSpeed")) {
        const char* given = dict.has("largestOverlap") ? "largestOverlap" : "impactSpeed";
        throw dict.complaint(given, std::string(given) + " is given alone",
                             "give both: the solid step is largestOverlap * diameter / impactSpeed");
    }
    std::vector<std::string> rules;
    for (const char* key : {"stepsPerCollision", "solidStep", "largestOverlap"})
        if (dict.has(key)) rules.emplace_back(key);
    if (rules.size() > 1)
        throw dict.complaint(rules[1], "both " + rules[1] + " and " + rules[0] + " are given", "keep one of them");
}

void read_commands(Reader& dict, Settings& settings)
{
    dict.own_blocks({"commands", "commands of LIGGGHTS at a time of the run: to open a gate, to start a feed"},
                    [&](const std::string& name, Reader& block) {
                        TimedCommands commands{name, 0, {}};
                        std::optional<double> time;
                        block.number(
                            {"time", "before the first gas step that begins then or later", "s", "must be given"}, time,
                            at_least(0));
                        if (!time && block.has("lines"))
                            throw block.complaint("lines", "commands `" + name + "` have no time",
                                                  "add `time T;`, in seconds of the run");
                        block.texts({"lines", "as a script of LIGGGHTS has them"}, commands.lines);
                        commands.time = time.value_or(0);
                        settings.commands.push_back(commands);
                    });
    std::stable_sort(settings.commands.begin(), settings.commands.end(),
                     [](const TimedCommands& a, const TimedCommands& b) { return a.time < b.time; });
}

void read_particles(Reader& dict, Settings& settings, const std::filesystem::path& folder)
{
    dict.required_text({"script", "LIGGGHTS script, from the case folder on"}, settings.script,
                       "name the LIGGGHTS script, e.g. `script \"dem/in.liggghts\";`");
    if (dict.has("script") && !std::filesystem::is_regular_file(folder / settings.script))
        throw dict.complaint("script", "there is no LIGGGHTS script `" + settings.script + "` in the case",
                             "correct the name, or put the script there");
    dict.own_entries({"variables", "handed to the script as LIGGGHTS variables, with `weight`"}, settings.variables);
    read_commands(dict, settings);
    read_solid_step(dict, settings);
    dict.number(
        {"stepAtTimeZero",
         "the step that LIGGGHTS counts at the gas's time 0, for a start at a later time by read_restart: of a bed "
         "that a run without gas had made, or steps that were longer or shorter before",
         "", "0", "a step's number"},
        settings.step_at_time_zero, any_number());
}

void read_gas(Reader& dict, Settings& settings)
{
    dict.choice({"model", "solved (pimple), held as its fields say (frozen), or none"}, settings.gas,
                {{"pimple", GasModel::pimple}, {"frozen", GasModel::frozen}, {"none", GasModel::none}});
    const bool solved = settings.gas == GasModel::pimple;
    settings.two_way = solved;
    dict.choice({"coupling", "whether the particles act on the gas", "", "twoWay (a gas that is not solved: oneWay)"},
                settings.two_way, {{"twoWay", true}, {"oneWay", false}});
    if (settings.two_way && !solved)
        throw dict.complaint("coupling",
                             std::string("`coupling twoWay;` with a gas that is not solved (model ") +
                                 (settings.gas == GasModel::frozen ? "frozen" : "none") + ")",
                             "set `coupling oneWay;`");
}

void read_drag(Reader& dict, Settings& settings)
{
    std::vector<std::string> laws;
    for (const DragLaw& law : drag_laws())
        laws.emplace_back(law.name);
    dict.choice({"law", "drag law, on the real particle's diameter"}, settings.drag_law, laws);
    dict.choice(
        {"selfDisturbance",
         "what a particle sees of its own drag and solids in the gas: taken out of voidage and slip, or left in"},
        settings.self_disturbance, {{"corrected", true}, {"left", false}});
}

void read_mapping(Reader& dict, Settings& settings)
{
    MappingRules& rules = settings.mapping;
    dict.choice({"type", "what a particle belongs to: cells in a kernel's reach, or the one that holds its centre"},
                rules.type, {{"kernel", MappingType::kernel}, {"cellCentre", MappingType::cell_centre}});
    dict.number({"widthInDiameters",
                 "the kernel's width at half height where cells are narrower than 0.8 of it, in diameters of the "
                 "tracked sphere"},
                rules.width_in_diameters, above(0));
    dict.number({"width", "that least width for all spheres, whatever their size", "m", "by widthInDiameters"},
                rules.width, above(0));
    for (const char* key : {"width", "widthInDiameters"})
        if (dict.has(key) && rules.type == MappingType::cell_centre)
            throw dict.complaint(key, "a kernel width with `type cellCentre;`", "remove it, or set `type kernel;`");
    if (dict.has("width") && dict.has("widthInDiameters"))
        throw dict.complaint("width", "two widths of the kernel, `width` and `widthInDiameters`", "keep one of them");
    dict.number({"maximumPacking", "solid fraction above which a cell hands its excess to its neighbours"},
                rules.maximum_packing, between(0, 1));
}

void read_records(Reader& dict, Settings& settings)
{
    dict.number({"interval", "time between two rows of /series", "s"}, settings.record_interval, above(0));
    dict.number({"snapshotInterval", "time between two snapshots of the particles", "s", "when the gas is written"},
                settings.snapshot_interval, above(0));
    dict.points({"pressureTaps",
                 "the pressure of the first less that of the last is recorded: /series/pressure_drop, which "
                 "there is only then",
                 "m", "none"},
                settings.pressure_taps, 2,
                "give two points or more: the pressure of the first less that of the last is recorded");
}

void read_checkpoint(Reader& dict, Settings& settings)
{
    dict.number({"interval", "simulated time between two checkpoints", "s", "none by simulated time"},
                settings.checkpoint_interval, above(0));
    dict.number({"wallInterval",
                 "time of the wall clock between two checkpoints, longer where they take more than a hundredth of the "
                 "time; 0: none by the clock",
                 "s"},
                settings.checkpoint_wall_interval, at_least(0));
}

void read_all(Reader& dict, Settings& settings, const std::filesystem::path& folder, const MethodSource& source)
{
    read_method(dict, settings, source);
    dict.required_block({"particles", "what LIGGGHTS is to do; of the keys for the solid step, one rule at most"},
                        "add it, with the LIGGGHTS script",
                        [&](Reader& block) { read_particles(block, settings, folder); });
    dict.block({"gas", "what is solved of the gas"}, [&](Reader& block) { read_gas(block, settings); });
    dict.block({"drag", "the drag of the particles"}, [&](Reader& block) { read_drag(block, settings); });
    dict.names({"forces", "interphase terms beside drag and the pressure gradient"}, settings.forces,
               names_of_optional_terms());
    dict.block({"mapping", "between particles and gas cells"}, [&](Reader& block) { read_mapping(block, settings); });
    dict.choice({"outsideMesh",
                 "what becomes of particles whose centre is in no gas cell: the run stops, or they move without gas "
                 "and may leave "
                 "through the boundary of the particles' domain, counted"},
                settings.outside_mesh, {{"stop", OutsideMesh::stop}, {"ignore", OutsideMesh::ignore}});
    dict.block({"records", "what is written to results.h5 and particles.h5"},
               [&](Reader& block) { read_records(block, settings); });
    dict.block({"statistics",
                "taken in the run, rows of /statistics in results.h5, from which tools/report makes means and errors; "
                "x goes across, y is the depth from the front wall on, z is up"},
               [&](Reader& block) { read_statistics(block, settings.statistics); });
    if (settings.statistics.tap_interval > 0 && settings.pressure_taps.empty())
        throw dict.complaint("statistics",
                             "`tapInterval " + text(settings.statistics.tap_interval) +
                                 ";` without records.pressureTaps: there is no pressure to take",
                             "add `pressureTaps ((x y z) (x y z));` to `records`, or remove tapInterval");
    if (settings.statistics.fields.wanted && settings.statistics.interval > 0 && settings.gas == GasModel::none)
        throw dict.complaint(
            "statistics",
            "a block `fields` in `statistics` with `model none;`: there are no gas cells to have means "
            "and no files of the gas",
            "remove `fields`, or set `gas { model frozen; coupling oneWay; }`");
    dict.block({"checkpoint",
                "when the state is written from which the option -resume goes on; with either of these also at the "
                "end. `touch checkpoint` in the case's folder or SIGUSR1 asks for one"},
               [&](Reader& block) { read_checkpoint(block, settings); });
}

}  // namespace

Settings read_settings(const Dictionary& coupling, const Dictionary& scene, const std::filesystem::path& folder,
                       const MethodSource& source)
{
    Settings settings;
    Reader dict(coupling);
    read_all(dict, settings, folder, source);
    dict.refuse_unknown_keys(scene.keys());
    return settings;
}

std::vector<KeyDescription> setting_keys(const MethodSource& source)
{
    std::vector<KeyDescription> keys;
    Reader dict(keys);
    Settings defaults;
    read_all(dict, defaults, {}, source);
    return keys;
}

}  // namespace interphase
