# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/compare tells: a report as a dict, for JSON, and the same as text."""

import dataclasses
import math

import numpy

from interphase import tables
from interphase.statistical_comparison import CONSTANT, DIFFERENT, GROSS, SAME, UNJUDGED


def of_difference(verdict, a, b, difference, tolerances):
    """The report of a comparison number by number."""
    beyond = set(difference.beyond(tolerances))
    quantities = []
    for q in difference.quantities.values():
        quantities.append({
            "name": q.name, "unit": q.unit, "largest": q.size, "relative": q.relative, "rms": q.rms,
            "particle": q.particle, "at": q.at, "values": q.values,
            "first": q.first, "first_particle": q.first_particle, "differing": q.differing, "compared": q.compared,
            "periodic_images": q.images, "nan_on_both_sides": q.unknown,
            "allowed": q.allowed(tolerances), "within": q.name not in beyond,
        })
    return {
        "verdict": verdict, "a": a.describe(), "b": b.describe(), "tolerance": bool(tolerances),
        "common_times": difference.times, "first_time": difference.first_time, "last_time": difference.last_time,
        "times_only_in": _sides(difference.only_times), "particles_only_in": _sides(difference.only_ids),
        "quantities_only_in": {side: sorted(names) for side, names in zip("AB", difference.only_columns)},
        "quantities": quantities, "history": difference.history, "notes": difference.notes,
    }


def _sides(pair):
    return {side: dataclasses.asdict(one) for side, one in zip("AB", pair)}


def of_statistics(verdict, a, b, comparisons, notes, confidence):
    """The report of a comparison of means."""
    rows = []
    for c in comparisons:
        row = {"name": c.name, "verdict": c.verdict, "reason": c.reason, "certain": c.certain, "ranges_apart": c.apart, "chance_in_one_flow": c.chance}
        for side, mean in (("a", c.a), ("b", c.b)):
            row[side] = None if mean is None else dataclasses.asdict(mean)
        if c.difference is not None:
            row.update(dataclasses.asdict(c.difference) | {"seen_from": c.seen_from})
        rows.append(row)
    return {
        "verdict": verdict, "a": a.describe(), "b": b.describe(), "confidence": confidence, "statistics": rows,
        "notes": notes,
    }


def plain(value):
    """`value` as JSON knows it: numpy's numbers as Python's, NaN and infinities as text."""
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    if isinstance(value, numpy.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value


def text(report):
    """The report for people; its first line is the verdict."""
    lines = [report["verdict"], f"A: {report['a']}", f"B: {report['b']}"]
    lines += _statistics(report) if "statistics" in report else _difference(report)
    lines += [f"note: {note}" for note in report["notes"]]
    return "\n".join(lines)


def _difference(report):
    lines = []
    if report["common_times"]:
        span = f"{report['first_time']} to {report['last_time']}"
        lines.append(f"{report['common_times']} common times of particles: {span}")
    for what, key in (("times", "times_only_in"), ("particles", "particles_only_in")):
        for side, one in report[key].items():
            if one["count"]:
                more = " ..." if one["count"] > len(one["examples"]) and what == "times" else ""
                summed = "" if what == "times" else ", summed over the common times"
                lines.append(f"only in {side}: {one['count']} {what}{summed}: {'; '.join(one['examples'])}{more}")
    for side, names in report["quantities_only_in"].items():
        if names:
            lines.append(f"only in {side}, not compared: {', '.join(names)}")
    differing = [q for q in report["quantities"] if q["differing"]]
    equal = [q["name"] for q in report["quantities"] if not q["differing"]]
    if equal:
        lines.append(f"bit-equal: {', '.join(equal)}")
    for q in report["quantities"]:
        if q["periodic_images"]:
            moved = f"{q['periodic_images']} of {q['compared']}"
            lines.append(f"{q['name']}: {moved} are a periodic box length apart, compared by nearest image")
        if q["nan_on_both_sides"]:
            lines.append(f"{q['name']}: NaN on both sides, taken as equal: {q['nan_on_both_sides']} of {q['compared']}")
    if differing:
        table = [["largest difference", "", "relative", "particle", "at", "differing"]]
        for q in differing:
            name = f"{q['name']} [{q['unit']}]" if q["unit"] else q["name"]
            particle = "-" if q["particle"] is None else str(q["particle"])
            row = [name, f"{q['largest']:.6g}", f"{q['relative']:.3g}", particle, q["at"]]
            table.append([*row, f"{q['differing']} of {q['compared']}"])
            if report["tolerance"]:
                table[-1].append(f"{'within' if q['within'] else 'beyond'} {q['allowed']:.3g}")
        lines += tables.columns(table, indent=2)
        for q in differing:
            first = q["first"] + ("" if q["first_particle"] is None else f" (particle {q['first_particle']})")
            a, b = map(_shown, q["values"])
            lines.append(f"{q['name']}: A {a}, B {b}; differs first at {first}")
    return lines


def _shown(value):
    return "(" + " ".join(f"{v!r}" for v in value) + ")" if isinstance(value, list) else repr(value)


def _statistics(report):
    rows = report["statistics"]
    table = [["mean", "A", "B", "B - A", "/ error", "seen from", "verdict"]]
    for row in rows:
        shown = [_mean(row[side]) for side in "ab"]
        if "ratio" in row:
            shown += [f"{row['value']:+.4g}", f"{row['ratio']:+.2f}", f"{row['seen_from']:.2g}"]
        else:
            shown += ["", "", ""]
        table.append([row["name"], *shown, row["verdict"] + _because(row)])
    lines = tables.columns(table, indent=2)
    counts = {v: sum(row["verdict"] == v for row in rows) for v in (SAME, DIFFERENT, GROSS, UNJUDGED, CONSTANT)}
    shown = [f"{counts[v]} {v}" for v in counts if counts[v] or v in (SAME, DIFFERENT)]
    lines.append(f"{', '.join(shown)}; at {100 * report['confidence']:g} % confidence for all together")
    if counts[CONSTANT]:
        lines.append("constant on both sides, and the same, says nothing of a flow: not counted")
    seen = [(row["seen_from"] / max(row["a"]["deviation"], row["b"]["deviation"]), row["seen_from"], row["name"])
            for row in rows if row["verdict"] == SAME]
    if seen:
        deviations, size, name = max(seen)
        lines.append(f"least sharp: {name}: a difference below {size:.2g}, {deviations:.2g} of its deviations in time, would not "
                     "have shown")
    lines.append("means are given with their standard error, autocorrelation taken in")
    return lines


def _because(row):
    apart = ""
    if row["ranges_apart"]:
        chance = row["chance_in_one_flow"]
        apart = "ranges apart, " + (f"by chance in one flow: {chance:.2g}" if chance < 1 else "too short to say how likely in one flow")
    words = "; ".join(each for each in (apart, row["reason"]) if each)
    return f" ({words})" if words else ""


def _mean(mean):
    if mean is None:
        return "-"
    return f"{mean['value']:.6g}" if math.isnan(mean["error"]) else f"{mean['value']:.6g} +- {mean['error']:.2g}"
