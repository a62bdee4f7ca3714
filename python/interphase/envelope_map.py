# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of tools/envelope as a picture, a CSV file and a table in Markdown. `rows` are dicts, see FIELDS."""

import csv

from interphase import tables
from interphase.envelope_verdict import BEYOND, ERROR, FAILED, RIGHT, TOLD, VERDICTS

FIELDS = ("scene", "method", "phi", "ratio", "gas_step", "steps", "ranks", "verdict", "seen", "error", "rms", "alternation", "books",
          "exit_code", "wall_time")  # fmt: skip
TITLES = {
    "closed": "closed box, water", "fluidized": "liquid-fluidized column", "packed": "packed bed in gas", "fine": "fine bed in air",
}
MARKS = {RIGHT: ("#1b7837", "o"), ERROR: ("#dfc27d", "s"), TOLD: ("#4393c3", "D"), FAILED: ("#b2182b", "X"), BEYOND: ("#bbbbbb", "_")}
LETTERS = {RIGHT: "right", TOLD: "told", FAILED: "**failed**", BEYOND: "-"}


def write_csv(path, rows):
    """The FIELDS of all rows."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)


def _ordered(values):
    return list(dict.fromkeys(values))


def markdown(rows):
    """A table a scene: a line per method and solid fraction, a column per gas step over relaxation time."""
    text = []
    for scene in _ordered(row["scene"] for row in rows):
        of_scene = [row for row in rows if row["scene"] == scene]
        ratios = sorted({row["ratio"] for row in of_scene})
        text += [f"**{TITLES[scene]}**", "", tables.markdown_head(["method", "phi", *(f"x = {x:g}" for x in ratios)])]
        for method in _ordered(row["method"] for row in of_scene):
            for phi in sorted({row["phi"] for row in of_scene if row["method"] == method}):
                cells = {row["ratio"]: row for row in of_scene if row["method"] == method and row["phi"] == phi}
                shown = [
                    "" if x not in cells else LETTERS.get(cells[x]["verdict"]) or f"{100 * cells[x]['error']:+.1f} %" for x in ratios]
                text.append(tables.markdown_row([method, f"{phi:g}", *shown]))
        text.append("")
    counts = {name: sum(row["verdict"] == name for row in rows) for name in VERDICTS}
    text.append(", ".join(f"{name}: {count}" for name, count in counts.items()))
    return "\n".join(text) + "\n"


def draw(path, rows):
    """A panel per scene and method: x along, solid fraction up, one mark a run."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    scenes, methods = _ordered(row["scene"] for row in rows), _ordered(row["method"] for row in rows)
    figure, axes = pyplot.subplots(
        len(scenes), len(methods), squeeze=False, sharex=True, sharey="row", figsize=(1.0 + 2.6 * len(methods), 1.2 + 1.9 * len(scenes)))
    for i, scene in enumerate(scenes):
        for j, method in enumerate(methods):
            here = [row for row in rows if row["scene"] == scene and row["method"] == method]
            panel = axes[i][j]
            for name, (colour, mark) in MARKS.items():
                of_kind = [row for row in here if row["verdict"] == name]
                panel.scatter([row["ratio"] for row in of_kind], [row["phi"] for row in of_kind], c=colour, marker=mark, s=55)
            panel.set_xscale("log")
            panel.set_xlim(4e-4, 2.5e2)
            panel.set_ylim(0, 0.65)
            panel.grid(alpha=0.25)
            if i == 0:
                panel.set_title(method)
            if i == len(scenes) - 1:
                panel.set_xlabel("gas step / relaxation time")
            if j == 0:
                panel.set_ylabel(f"{TITLES[scene]}\nsolid fraction", fontsize=8)
    handles = [pyplot.Line2D([], [], color=colour, marker=mark, linestyle="", label=name) for name, (colour, mark) in MARKS.items()]
    figure.legend(handles=handles, loc="lower center", ncol=min(len(handles), 1 + len(methods)), frameon=False, fontsize=8)
    figure.tight_layout(rect=(0, 0.6 / figure.get_figheight(), 1, 1))
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
