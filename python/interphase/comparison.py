# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare two sources, number by number or by their statistics, and judge: the verdicts of tools/compare.

`options` are those of tools/compare: start, end, timestep, tolerances, only, same_times, confidence.
"""

import os

import numpy

from interphase import snapshot_measures, statistical_comparison
from interphase.difference import Difference, compare_particles, compare_series, wanted
from interphase.foam_file import nearest
from interphase.input_error import InputError
from interphase.liggghts_dump import Dump, find_dumps
from interphase.matching_times import matching_of
from interphase.run_records import find_run

EQUAL, DIFFERS, CANNOT, UNJUDGED = 0, 1, 2, 3


def opened(path, name):
    """The run or dump that `path` means."""
    if os.path.exists(path):
        run = find_run(path)
        if run is not None:
            return run
        if os.path.isfile(path) and os.path.getsize(path) == 0:
            raise InputError(f"{name} = {path}: the file is empty; was the run cut short?")
    files = find_dumps(path)
    if files:
        return Dump(path, files)
    if not os.path.lexists(path):
        raise InputError(f"{name} = {path}: no such file or folder, and no dump file matches it as a pattern")
    if os.path.isdir(path):
        raise InputError(
            f"{name} = {path}: a folder with neither particles.h5 nor results.h5 nor text of LIGGGHTS's `dump custom` "
            "in it; give a run's folder, or the dump files"
        )
    raise InputError(
        f"{name} = {path}: neither a run's .h5 file nor text of LIGGGHTS's `dump custom` ('ITEM: TIMESTEP' first); "
        "VTK and binary dumps are not read"
    )


def has_particles(source):
    """Whether a source shows particles: a dump does, a run may not."""
    return source.kind != "run" or source.particles is not None


def refuse_unknown(names, known, what):
    """InputError with the nearest of `known` for a name that is not among them."""
    for name in names:
        if name not in known:
            raise InputError(f"{what} {name}: not in both A and B: {nearest(name, sorted(known))}")


def numbers(a, b, options):
    """Compare number by number; returns (exit code, verdict, Difference, Matching)."""
    matching = matching_of(a, b, options.timestep)
    difference = Difference()
    both_particles = has_particles(a) and has_particles(b)
    series = [source.series() if source.kind == "run" else None for source in (a, b)]
    if not both_particles and None in series:
        raise InputError(
            f"A and B have no records in common: {a.describe()}, {b.describe()}. "
            "Particles (particles.h5 or a dump) or /series (results.h5) are needed on both sides."
        )
    only_series = options.only and all(name.split("/")[0] == "series" for name in options.only)
    lone_times = [0, 0]
    if both_particles and not (only_series and None not in series):
        compare_particles(a, b, matching, difference, options.start, options.end, options.only)
    elif not both_particles:
        difference.notes.append("particles are not compared: not on both sides")
    if None not in series:
        common, lone_times = compare_series(*series, matching, difference, options.start, options.end, options.only)
        if not common and not difference.times:
            raise InputError(f"A and B have no time in common in /series/time of {a.results} and {b.results}")
    known = difference.common | {name.split("/")[0] for name in difference.common}
    refuse_unknown(options.only, known, "--only")
    refuse_unknown(options.tolerances.names(), known, "tolerance of")
    if not difference.quantities:
        lone = [listed(names) for names in difference.only_columns]
        raise InputError(
            f"A and B have no quantity in common: {a.path} has {lone[0]}, {b.path} {lone[1]}. "
            "Dump the same columns, such as x y z vx vy vz."
        )
    if not any(q.compared for q in difference.quantities.values()):
        raise InputError(
            "A and B have no particle in common at any common time, so nothing was compared: are the ids numbered "
            "the same way?"
        )
    for name, source in (("A", a), ("B", b)):
        if source.digits is not None and source.digits < 15:
            difference.notes.append(
                f"{name} shows {source.digits} digits: what is smaller cannot be seen. "
                'dump_modify ID format "%d ... %.17g ..." shows all'
            )
        if source.text_columns:
            difference.notes.append(f"{name}: columns of text are not compared: {listed(source.text_columns)}")
    code, verdict = judged(difference, options, lone_times)
    return code, verdict, difference, matching


def listed(names):
    """Names in order, for a message."""
    return ", ".join(sorted(names)) or "nothing"


def judged(difference, options, lone_times):
    """(exit code, verdict) of a `Difference`."""
    if options.same_times and (any(side.count for side in difference.only_times) or any(lone_times)):
        return DIFFERS, "different"
    if difference.bit_equal():
        return EQUAL, "bit-equal up to periodic images" if difference.images() else "bit-equal"
    if options.tolerances and not difference.missing_particles() and not difference.beyond(options.tolerances):
        return EQUAL, "equal within tolerance"
    return DIFFERS, "different"


def means(a, b, options):
    """Compare statistics; returns (exit code, verdict, [Comparison], notes, Matching)."""
    matching = matching_of(a, b, options.timestep)
    notes = []
    collected, spans = [{}, {}], [0.0, 0.0]
    sources = (a, b)
    series = [source.series() if source.kind == "run" else None for source in sources]
    if None not in series:
        for side, (times, values) in enumerate(series):
            inside = numpy.array([matching.inside(t, options.start, options.end) for t in times], dtype=bool)
            note_uneven(times[inside], "AB"[side], "series", notes)
            spans[side] = _span(times[inside])
            collected[side].update({f"series/{name}": column[inside] for name, column in values.items()})
    if has_particles(a) and has_particles(b):
        first = [next((frame.load() for frame in source.frames()), None) for source in sources]
        weigh = all(state is not None and "diameter" in state.quantities for state in first)
        place, left_out = snapshot_measures.place_of(sources, matching, options.start, options.end)
        notes += left_out
        for side, source in enumerate(sources):
            times, values = statistical_comparison.snapshot_series(source, matching, options.start, options.end, weigh, place)
            spans[side] = max(spans[side], _span(times))
            note_uneven(times, "AB"[side], "snapshots", notes)
            collected[side].update(values)
    both = [name for name in collected[0] if name in collected[1]]
    if not both:
        within = " within --from/--until" if (options.start, options.end) != (None, None) else ""
        raise InputError(
            f"A and B have no series in common to take statistics of{within}: "
            f"{a.describe()} has {listed(collected[0])}, {b.describe()} {listed(collected[1])}"
        )
    shown = {name.split(" ")[0]: name for name in both}
    refuse_unknown(options.only, set(shown) | {name.split("/")[0] for name in shown}, "--only")
    chosen = [full for short, full in shown.items() if wanted(short, options.only)]
    pair = ({name: side[name] for name in chosen} for side in collected)
    comparisons = statistical_comparison.compare(*pair, options.confidence)
    code, verdict = judged_means(comparisons)
    if code == UNJUDGED:
        notes.append(remedy(comparisons, min(spans), "s" if matching.by == "time" or matching.solid_step else "steps"))
    return code, verdict, comparisons, notes, matching


def judged_means(comparisons):
    """(exit code, verdict). What is constant on both sides does not count; where most of the rest is not judged, or ranges
    lie apart, the runs are not called alike."""
    varying = [c for c in comparisons if c.verdict != statistical_comparison.CONSTANT]
    if any(c.certain for c in varying):
        return DIFFERS, "statistically different"
    unjudged = [c for c in varying if c.verdict != statistical_comparison.SAME]
    if not varying or 2 * len(unjudged) > len(varying) or any(c.apart for c in unjudged):
        return UNJUDGED, "cannot be judged"
    return EQUAL, "statistically indistinguishable"


def remedy(comparisons, span, unit):
    """What would make runs judgeable whose records are `span` long."""
    varying = [c for c in comparisons if c.verdict != statistical_comparison.CONSTANT]
    if not varying:
        return "nothing varies: compare the numbers themselves, without --statistics"
    words = []
    apart = sum(c.apart for c in varying)
    if apart:
        words.append(f"of {len(varying)} quantities that vary, {apart} have ranges that lie apart: they differ grossly, or these records are too "
                     "short to show how far one flow goes")
    factor = statistical_comparison.needed(comparisons)
    if factor is not None and factor > 1:
        words.append(f"for half of what varies to be judged, both need about {factor * span:.2g} {unit} instead of {span:.2g}, at "
                     "least: motions slower than the record do not show in it. Snapshots closer together help where samples are too few")
    elif apart:
        words.append("run longer")
    return "; ".join(words) or "run longer, or skip the start-up with --from"


def _span(times):
    return float(times[-1] - times[0]) if len(times) > 1 else 0.0


def note_uneven(times, side, what, notes):
    """Add to `notes` where samples at `times` [n] are not evenly spaced."""
    spread = statistical_comparison.uneven(times)
    if spread:
        apart = f"{spread[0]:.4g} to {spread[1]:.4g} apart"
        notes.append(f"{side}: {what} are {apart}; means are over samples, not over time")
