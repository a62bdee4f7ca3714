// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/read_settings.hpp"

#include <algorithm>
#include <iterator>

#include "IFstream.H"
#include "List.H"
#include "OSspecific.H"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/openfoam/dictionary_reader.hpp"
#include "forces/drag/drag_law.hpp"
#include "vector.H"

namespace interphase {

namespace {

bool positive(double value) { return value > 0; }

Foam::dictionary parsed(const Foam::fileName& file)
{
    Foam::IFstream stream(file);
    return Foam::dictionary(stream);
}

/// The scene's own numbers are included in couplingDict beside its entries.
std::vector<std::string> scene_parameters(const Foam::fileName& root)
{
    const Foam::fileName file = root / "parameters";
    std::vector<std::string> keys{"FoamFile"};
    if (!Foam::isFile(file)) return keys;
    for (const auto& key : parsed(file).toc())
        keys.push_back(key);
    return keys;
}

void read_method(DictionaryReader& dict, Settings& settings)
{
    constexpr Method methods[] = {Method::dem,  Method::cgpm,   Method::tdhs,
                                  Method::cghs, Method::mp_pic, Method::plugin};
    const std::string method = dict.choice("method", "DEM", {"DEM", "CGPM", "TDHS", "CGHS", "MPPIC", "PLUGIN"});
    settings.method =
        *std::find_if(std::begin(methods), std::end(methods), [&](Method m) { return name_of(m) == method; });
    settings.weight = dict.number(
        "weight", 1, [](double w) { return w >= 1; }, "the real particles per tracked one, at least 1");
    if (!tracks_parcels(settings.method) && settings.weight != 1)
        throw dict.complaint(
            "weight", "`weight " + text(settings.weight) + ";` with method " + method + ", which tracks real particles",
            std::string("set `weight 1;`, or `method ") + (method == "DEM" ? "CGPM" : "CGHS") + ";`");
}

void read_plugins(DictionaryReader& dict, Settings& settings)
{
    for (Foam::string name : dict.names("plugins")) {
        name.expand(true);  // $HOME, ~ and the like
        settings.plugins.push_back(name);
    }
    const std::string method = name_of(settings.method);
    if (resolves_contacts(settings.method) || !settings.plugins.empty()) return;
    throw dict.complaint("method", "`method " + method + ";` takes its collisions from a plug-in, and none is named",
                         is_hard_sphere(settings.method) ? "add `plugins (hard_sphere);`"
                         : settings.method == Method::mp_pic
                             ? "add `plugins (mp_pic);`"
                             : "add `plugins (NAME);` with the name or \"path\" of yours");
}

/// How long a solid step is: given, or by one of two rules.
void read_solid_step(DictionaryReader& dict, Settings& settings)
{
    const bool resolved = resolves_contacts(settings.method);
    if (is_hard_sphere(settings.method)) settings.steps_per_collision = 1;
    settings.steps_per_collision = dict.number(
        "stepsPerCollision", settings.steps_per_collision, [&](double s) { return resolved ? s >= 10 : s > 0; },
        resolved ? "at least 10 (solid steps in which one collision is resolved; 10 to 60 are usual)"
                 : "above 0 (solid steps in the time that DEM would take for one collision)");
    settings.solid_step = dict.number("solidStep", 0, positive, "above 0 (seconds)");
    settings.largest_overlap = dict.number(
        "largestOverlap", 0, [](double o) { return o > 0 && o < 1; },
        "between 0 and 1 (part of the tracked diameter that two spheres may overlap)");
    settings.impact_speed = dict.number("impactSpeed", 0, positive, "above 0 (m/s, at which spheres meet)");

    if (settings.method == Method::mp_pic)
        for (const char* entry : {"stepsPerCollision", "largestOverlap", "impactSpeed"})
            if (dict.has(entry))
                throw dict.complaint(entry, std::string(entry) + " with method MPPIC, which has no single collisions",
                                     "leave it away for the gas step, or give solidStep");
    for (const char* entry : {"largestOverlap", "impactSpeed"})
        if (resolved && dict.has(entry))
            throw dict.complaint(entry,
                                 std::string(entry) + " with method " + name_of(settings.method) +
                                     ", whose step has to resolve each contact",
                                 "give stepsPerCollision or solidStep instead");
    if (dict.has("largestOverlap") != dict.has("impactSpeed")) {
        const char* given = dict.has("largestOverlap") ? "largestOverlap" : "impactSpeed";
        throw dict.complaint(given, std::string(given) + " is given alone",
                             "give both: the solid step is largestOverlap * diameter / impactSpeed");
    }
    std::vector<std::string> rules;
    for (const char* entry : {"stepsPerCollision", "solidStep", "largestOverlap"})
        if (dict.has(entry)) rules.emplace_back(entry);
    if (rules.size() > 1)
        throw dict.complaint(rules[1], "both " + rules[1] + " and " + rules[0] + " are given", "keep one of them");
}

void read_particles(DictionaryReader dict, Settings& settings, const Foam::fileName& root)
{
    settings.script = dict.text_of("script", "name the LIGGGHTS script, e.g. `script \"dem/in.liggghts\";`");
    if (!Foam::isFile(root / settings.script))
        throw dict.complaint("script", "there is no LIGGGHTS script `" + settings.script + "` in the case",
                             "correct the name, or put the script there");
    DictionaryReader variables = dict.sub("variables");
    for (const auto& key : variables.raw().toc()) {
        Foam::ITstream& stream = variables.raw().lookup(key);
        settings.variables.emplace_back(key, stream.size() == 1 && stream.first().isString()
                                                 ? std::string(stream.first().stringToken())
                                                 : std::string(stream.toString()));
    }
    read_solid_step(dict, settings);
    dict.refuse_unknown_keys();
}

void read_gas(DictionaryReader dict, Settings& settings)
{
    const std::string model = dict.choice("model", "pimple", {"pimple", "frozen", "none"});
    settings.gas = model == "pimple" ? GasModel::pimple : model == "frozen" ? GasModel::frozen : GasModel::none;
    const std::string fallback = settings.gas == GasModel::pimple ? "twoWay" : "oneWay";
    settings.two_way = dict.choice("coupling", fallback, {"twoWay", "oneWay"}) == "twoWay";
    if (settings.two_way && settings.gas != GasModel::pimple)
        throw dict.complaint("coupling", "`coupling twoWay;` with a gas that is not solved (model " + model + ")",
                             "set `coupling oneWay;`");
    dict.refuse_unknown_keys();
}

void read_mapping(DictionaryReader dict, Settings& settings)
{
    settings.mapping = dict.choice("type", "kernel", {"kernel", "cellCentre"}) == "kernel" ? MappingType::kernel
                                                                                           : MappingType::cell_centre;
    settings.kernel_width = dict.number("width", 0, positive, "above 0 (the kernel's least half-width in metres)");
    if (settings.kernel_width > 0 && settings.mapping == MappingType::cell_centre)
        throw dict.complaint("width", "a kernel width with `type cellCentre;`", "remove it, or set `type kernel;`");
    settings.maximum_packing = dict.number(
        "maximumPacking", settings.maximum_packing, [](double p) { return p > 0 && p < 1; },
        "a solid fraction between 0 and 1");
    dict.refuse_unknown_keys();
}

void read_drag(DictionaryReader dict, Settings& settings)
{
    std::vector<std::string> names;
    for (const DragLaw& law : drag_laws())
        names.emplace_back(law.name);
    settings.drag_law = dict.choice("law", settings.drag_law, names);
    dict.refuse_unknown_keys();
}

void read_records(DictionaryReader dict, Settings& settings)
{
    settings.record_interval = dict.number("interval", settings.record_interval, positive, "above 0 (seconds)");
    settings.snapshot_interval = dict.number("snapshotInterval", 0, positive, "above 0 (seconds)");
    if (dict.has("pressureTaps")) {
        const Foam::List<Foam::vector> taps(dict.raw().lookup("pressureTaps"));
        if (taps.size() != 2)
            throw dict.complaint("pressureTaps", std::to_string(taps.size()) + " pressure taps",
                                 "give two points: the pressure of the first less that of the second is recorded");
        for (const Foam::vector& p : taps)
            settings.pressure_taps.emplace_back(p.x(), p.y(), p.z());
    }
    dict.refuse_unknown_keys();
}

}  // namespace

Settings read_coupling_dict(const Foam::fileName& root)
{
    const Foam::fileName file = root / "system" / "couplingDict";
    const Foam::dictionary parsed_dict = parsed(file);
    DictionaryReader dict(parsed_dict, "system/couplingDict");

    Settings settings;
    read_method(dict, settings);
    read_plugins(dict, settings);
    if (!dict.has("particles"))
        throw dict.complaint("particles", "the block `particles { ... }` is missing",
                             "add it, with the LIGGGHTS script");
    read_particles(dict.sub("particles"), settings, root);
    read_gas(dict.sub("gas"), settings);
    read_drag(dict.sub("drag"), settings);
    read_mapping(dict.sub("mapping"), settings);
    settings.outside_mesh =
        dict.choice("outsideMesh", "stop", {"stop", "ignore"}) == "stop" ? OutsideMesh::stop : OutsideMesh::ignore;
    read_records(dict.sub("records"), settings);
    dict.refuse_unknown_keys(scene_parameters(root));
    return settings;
}

}  // namespace interphase
