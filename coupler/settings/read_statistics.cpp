// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/read_statistics.hpp"

#include "base/text.hpp"

namespace interphase {

namespace {

void read_windows(Reader& dict, StatisticsSettings::Windows& windows)
{
    dict.whole_number(
        {"count", "windows side by side across x", "", "5, fewer where they would be below 4 largest diameters"},
        windows.count);
    dict.number({"left", "x of the left end of the first", "m", "the vessel's"}, windows.left, any_number());
    dict.number({"right", "x of the right end of the last", "m", "the vessel's"}, windows.right, any_number());
    dict.number({"centre", "z of their middle", "m", "the mean height of all solids at the start"}, windows.centre,
                any_number());
    dict.number(
        {"height", "their height", "m", "a window's width, 4 largest diameters at least, the vessel's height at most"},
        windows.height, above(0));
    dict.number({"front", "y of the front wall", "m", "the vessel's"}, windows.front, any_number());
    dict.number({"frontDepth", "depth of the slice behind it", "m", "the largest diameter"}, windows.front_depth,
                above(0));
    if (windows.left && windows.right && *windows.right <= *windows.left)
        throw dict.complaint("right",
                             "`right " + text(*windows.right) + ";` is not right of `left " + text(*windows.left) +
                                 ";`: the windows are empty",
                             "correct one of the two [m]");
}

void read_overlaps(Reader& dict, StatisticsSettings::Overlaps& overlaps)
{
    dict.numbers({"shares", "the number of overlaps below each, over the smaller diameter"}, overlaps.shares, above(0));
    Scalars percentiles{50, 90, 99};
    dict.numbers({"percentiles", "of the overlaps, that tools/report gives", "%"}, percentiles, between(0, 100));
}

void read_voidage(Reader& dict, StatisticsSettings::Voidage& voidage)
{
    dict.number({"lowest", "the histogram's low end"}, voidage.lowest, from_to(0, 1));
    dict.number({"highest", "its high end"}, voidage.highest, from_to(0, 1));
    dict.whole_number({"bins", "bins between them"}, voidage.bins);
    dict.numbers({"limits", "the number of cells between these"}, voidage.limits, from_to(0, 1));
    if (voidage.highest <= voidage.lowest)
        throw dict.complaint("highest",
                             "`highest " + text(voidage.highest) + ";` is not above `lowest " + text(voidage.lowest) +
                                 ";`: the histogram is empty",
                             "correct one of the two");
    std::optional<Vector> point;
    Scalars cells;
    dict.vector({"low",
                 "low corner of a mesh on which tools/report puts the spheres of snapshots where they lie, "
                 "with high and cells",
                 "m", "the box of blockMeshDict where it is one, else the vessel's"},
                point);
    dict.vector({"high", "its high corner", "m", "the same"}, point);
    dict.numbers({"cells", "its cells in each direction", "", "the same; 4 mean diameters wide in the vessel's"}, cells,
                 above(0), Reader::Order::any);
}

}  // namespace

void read_statistics(Reader& dict, StatisticsSettings& settings)
{
    dict.number({"interval", "time between two rows of /statistics; 0: none are taken", "s"}, settings.interval,
                at_least(0));
    dict.number({"tapInterval",
                 "time between two rows of /taps, the pressure at each of records.pressureTaps, at each gas step at "
                 "most; 0: none are taken",
                 "s"},
                settings.tap_interval, at_least(0));
    std::optional<double> from;
    dict.number({"from", "start-up, which tools/report leaves out", "s", "found by tools/report"}, from, any_number());
    dict.block_or_none({"windows",
                        "velocities and granular temperature at places across the bed, in a slice at the "
                        "front wall and over the whole depth"},
                       settings.windows.wanted, [&](Reader& block) { read_windows(block, settings.windows); });
    dict.block_or_none({"overlaps", "of all pairs of spheres that overlap"}, settings.overlaps.wanted,
                       [&](Reader& block) { read_overlaps(block, settings.overlaps); });
    dict.block_or_none({"voidage", "of the gas cells, as the gas has it"}, settings.voidage.wanted,
                       [&](Reader& block) { read_voidage(block, settings.voidage); });
    dict.block_or_none(
        {"surface",
         "of the bed as a camera sees it: per column of width the height below which a share of its solids lies"},
        settings.surface.wanted, [&](Reader& block) {
            block.whole_number({"columns", "columns across x", "", "as wide as a gas cell, 4 mean diameters at least"},
                               settings.surface.columns);
            block.number({"share", "of a column's solids below its surface"}, settings.surface.share, between(0, 1));
        });
    dict.block_or_none(
        {"bubbles", "connected gas cells of high voidage below the surface of the bed; takes surface, too"},
        settings.bubbles.wanted, [&](Reader& block) {
            block.number({"voidage", "above which a cell belongs to a bubble"}, settings.bubbles.voidage,
                         between(0, 1));
        });
    if (settings.bubbles.wanted && !settings.surface.wanted && dict.has("bubbles"))
        throw dict.complaint("bubbles", "a block `bubbles` with `surface none;`: gas above the bed is no bubble",
                             "remove `surface none;`, or set `bubbles none;`");
    settings.bubbles.wanted = settings.bubbles.wanted && settings.surface.wanted;
    settings.fields.wanted = dict.has("fields");
    dict.block_or_none(
        {"fields",
         "mean and variance over the samples, cell by cell, of voidage, gas velocity and solid velocity (this by solid "
         "volume), as fields meanVoidage, varianceVoidage, meanU, varianceU, meanSolidsU, varianceSolidsU in the gas's "
         "time folders, each up to its time; only where the block is there, and be it empty"},
        settings.fields.wanted, [&](Reader& block) {
            block.number({"from", "samples before it are left out", "s", "that of `statistics`, else the start"},
                         settings.fields.from, any_number());
        });
    if (!settings.fields.from) settings.fields.from = from;
    if (settings.fields.wanted && !dict.has("interval"))
        throw dict.complaint("fields", "a block `fields` without an `interval`: no sample is taken",
                             "add `interval 0.05;` to the block `statistics`, or remove `fields`");
}

}  // namespace interphase
