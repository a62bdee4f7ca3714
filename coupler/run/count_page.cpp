// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/count_page.hpp"

#include <cstdio>

#include "base/engine_warnings.hpp"
#include "forces/drag/drag_counts.hpp"
#include "forces/terms.hpp"
#include "run/count_news.hpp"
#include "step/step_counts.hpp"

namespace interphase {

namespace {

std::string when(const CountKind& kind)
{
    switch (kind.worry) {
        case Worry::any:
            return "Look at it as soon as there is one.";
        case Worry::above: {
            char limit[64];
            std::snprintf(limit, sizeof limit, "Look at it above %g %s.", kind.limit, kind.unit);
            return limit;
        }
        case Worry::never:
            return "It is ordinary.";
        case Worry::share:
            break;
    }
    return "Look at it above " + percent(tolerable_share) + ".";
}

std::string part(const CountKind& kind)
{
    const std::string whole = name_of(kind.whole);
    std::string page = "## " + std::string(kind.text) + "\n\n`" + kind.key + "`";
    if (!whole.empty()) page += ", a share " + whole;
    page += ". " + std::string(kind.meaning) + "\n\n- " + when(kind) + " " + kind.reason + "\n";
    if (*kind.remedy != '\0') page += "- Remedy: " + std::string(kind.remedy) + ".\n";
    return page;
}

}  // namespace

CountKinds counts_of_the_step()
{
    CountKinds all{&cells_relieved,     &particles_outside_mesh, &centres_beyond_edge,      &cells_pushed,
                   &held_at_outlet,     &beyond_drag_range,      &self_disturbance_limited, &steps_alternating,
                   &steps_accelerating, &steps_across_cells,     &steps_outrun_by_waves,    &cells_beyond_close_packing,
                   &step_crosses_cells, &step_beyond_relaxation};
    for (const OptionalTerm& term : optional_terms())
        for (const Count& count : term.make()->counts())
            all.push_back(count.kind);
    return all;
}

std::string count_page(const CountKinds& of_engines, const std::vector<CountKind>& of_plugins)
{
    std::string page =
        "# What a run counts\n\nAs `interphase -help counts` prints it. Ranges that were left, clamps and steps that "
        "were too long are counted from the start of a run, over its resumes, and stand at the end of the screen's "
        "output: the number, what share it is, and whether to look at it. `/ledger` of `results.h5` has most of them "
        "step by step; those of a plug-in's fixes stand in `/counters`. While the run goes on, it looks every " +
        std::to_string(CountNews::steps_between_looks) +
        " gas steps at these alone, and tells of a count that is to be looked at, the first time.\n\nWhere a share "
        "decides, the limit is " +
        percent(tolerable_share) +
        ": what is off in a hundredth of all places and steps, and there by no more than its own size, moves a mean "
        "over all of them by at most 1 %. The drop of `cases/sscp1`, a mean that is known well, has a standard error "
        "of 0.4 %, and drag laws that claim the same range differ by more. A share is no bound for what happens in one "
        "place: look where it happens if that is what you want to know.\n";
    for (const CountKind* kind : counts_of_the_step())
        page += "\n" + part(*kind);
    for (const CountKind* kind : of_engines)
        page += "\n" + part(*kind);
    for (const CountKind& kind : of_plugins)
        page += "\n" + part(kind);
    return page + "\n" + part(warnings_of_engine);
}

}  // namespace interphase
