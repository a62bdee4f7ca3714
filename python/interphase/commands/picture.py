# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw the bed of a run seen from the front: every tracked sphere at its true size, coloured by its vertical velocity.

x runs to the right and z up; what is nearer to the front wall (small y) covers what is behind.
"""

import argparse
import os
import sys
from dataclasses import dataclass

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end is chosen first)
from matplotlib.collections import EllipseCollection  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402

from interphase.input_error import InputError  # noqa: E402
from interphase.whole_records import whole_rows, whole_snapshots  # noqa: E402

PANELS = 4  # snapshots in a strip
DPI = 200
BACKGROUND = "white"
INK = "0.2"
COLOURS = "coolwarm"  # diverging, and at rest grey: visible on white
# What lies behind fades towards the background, so that bubbles in front of other particles stay visible.
FADE = 0.55


@dataclass
class Snapshot:
    """The tracked spheres at one time [s]: position [n, 3] and diameter [n] in m, vertical velocity [n] in m/s."""

    time: float
    position: np.ndarray
    diameter: np.ndarray
    vertical_velocity: np.ndarray


@dataclass
class Record:
    """What results.h5 says beside the particles; every part may be missing."""

    title: str
    domain: np.ndarray | None  # corners [2, 3] of the gas mesh, m
    time: np.ndarray | None  # [n], s
    pressure_drop: np.ndarray | None  # [n], Pa
    bed_weight_per_area: np.ndarray | None  # [n], of the particles there at each time, or [1]: of all times; Pa


def arguments():
    parser = argparse.ArgumentParser(
        prog="tools/picture", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Draw the bed of a run from the front, spheres at true size coloured by vertical velocity:\n"
        f"a strip of up to {PANELS} evenly spaced times above the pressure drop.",
        epilog="examples:\n  tools/picture runs/sscp1-CGPM-w8\n  tools/picture runs/sscp1-CGPM-w8 --time 0.5 -o bed-0.5s.png",
    )
    parser.add_argument("run", metavar="RUN", help="a run's folder (with particles.h5)")
    parser.add_argument("-o", "--output", metavar="FILE", help="the picture (default: RUN/bed.png; with --series RUN/frames)")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--time", metavar="T", type=float, help="one picture of the snapshot nearest to T, in s")
    which.add_argument(
        "--series", action="store_true",
        help="a picture of every snapshot, numbered, with one colour scale (frames of a film), into the folder FILE",
    )
    return parser.parse_args()


def snapshots(file):
    """(time [s], group) of every whole snapshot in `file`, in order of time."""
    groups = [(time, group) for time, _, group in whole_snapshots(file)]
    if not groups:
        raise InputError(f"{file.filename} holds no snapshots yet")
    return groups


def read_snapshot(time, group):
    position = np.asarray(group["position"][:], dtype=float).reshape(-1, 3)
    velocity = np.asarray(group["velocity"][:], dtype=float).reshape(-1, 3)
    return Snapshot(time, position, np.asarray(group["diameter"][:], dtype=float), velocity[:, 2])


def as_text(attribute):
    return attribute.decode() if isinstance(attribute, bytes) else str(attribute)


def weights(meta):
    """Real particles per tracked one: "8", or "1 to 27" where they differ."""
    low, high = (float(np.ravel(meta.get(name, meta["weight"]))[0]) for name in ("lowest_weight", "highest_weight"))
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def read_record(run):
    name = os.path.basename(os.path.abspath(run))
    path = os.path.join(run, "results.h5")
    if not os.path.isfile(path):
        return Record(name, None, None, None, None)
    with h5py.File(path, "r") as file:
        meta = dict(file["meta"].attrs) if "meta" in file else {}
        series = file.get("series", {})
        words = [as_text(meta.get("case", name))]
        if "method" in meta:
            words.append(as_text(meta["method"]))
        if "weight" in meta:
            words.append("W = " + weights(meta))
        rows = whole_rows(series) if series else 0
        both = "time" in series and "pressure_drop" in series and rows > 1
        domain = np.asarray(meta["domain"], dtype=float).reshape(2, 3) if "domain" in meta else None
        weight = np.ravel(meta["bed_weight_per_area"]).astype(float)[:1] if "bed_weight_per_area" in meta else None
        if both and weight is not None and "bed_weight_per_area" in series:
            weight = series["bed_weight_per_area"][:rows]
        return Record(
            "  ·  ".join(words), domain, series["time"][:rows] if both else None,
            series["pressure_drop"][:rows] if both else None, weight,
        )


def evenly_spaced(times, count):
    """Indices of up to `count` snapshots at evenly spaced times, the last one included.

    The start is left out where there are enough others: a bed at rest tells nothing.
    """
    if len(times) <= count:
        return list(range(len(times)))
    wanted = times[0] + (times[-1] - times[0]) * np.arange(1, count + 1) / count
    return sorted({int(np.argmin(np.abs(np.asarray(times) - w))) for w in wanted})


def velocity_scale(shown):
    """End of the colour scale [m/s]: a round number above 98 % of the speeds shown."""
    speeds = np.abs(np.concatenate([s.vertical_velocity for s in shown]))
    speeds = speeds[np.isfinite(speeds)]
    high = float(np.percentile(speeds, 98)) if speeds.size else 0.0
    if high <= 0:
        return 1.0
    unit = 10.0 ** np.floor(np.log10(high))
    return float(unit * next(step for step in (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10) if step * unit >= high * (1 - 1e-9)))


def view(shown, domain):
    """(left, right, bottom, top) in m, whether the top is the domain's, and (front, back) in y.

    The vessel where it is known, but no more of its empty upper part than the bed needs.
    """
    # The empty one keeps a snapshot without particles from having no extents.
    boxes = [(s.position - s.diameter[:, None] / 2, s.position + s.diameter[:, None] / 2) for s in shown if len(s.diameter)]
    if not boxes and domain is None:
        raise InputError("the snapshots hold no particles")
    low = np.min([b[0].min(axis=0) for b in boxes], axis=0) if boxes else domain[0]
    high = np.max([b[1].max(axis=0) for b in boxes], axis=0) if boxes else domain[1]
    if domain is None:
        return (low[0], high[0], low[2], high[2]), False, (low[1], high[1])
    left, right = min(low[0], domain[0][0]), max(high[0], domain[1][0])
    bottom, top = min(low[2], domain[0][2]), max(high[2], domain[1][2])
    needed = bottom + max(1.12 * (high[2] - bottom), 0.6 * (right - left))
    cropped = needed < 0.85 * top + 0.15 * bottom
    return (left, right, bottom, needed if cropped else top), not cropped, (domain[0][1], domain[1][1])


def faded(colours, depth):
    """`colours` [n, 4] mixed with the background by `depth` [n], 0 in front and 1 at the back."""
    share = (FADE * np.clip(depth, 0, 1))[:, None]
    mixed = colours.copy()
    mixed[:, :3] = colours[:, :3] * (1 - share) + np.array(matplotlib.colors.to_rgb(BACKGROUND)) * share
    return mixed


def draw_bed(axes, snapshot, mapper, box, closed, depth, points_per_metre):
    left, right, bottom, top = box
    order = np.argsort(-snapshot.position[:, 1], kind="stable")
    position, diameter = snapshot.position[order], snapshot.diameter[order]
    behind = (position[:, 1] - depth[0]) / max(depth[1] - depth[0], 1e-300)
    colours = faded(mapper.to_rgba(snapshot.vertical_velocity[order]), behind)
    # A rim tells spheres of one colour apart; it is drawn inside the true size and goes where it would fill it.
    rim = min(0.25, 0.06 * float(np.median(diameter)) * points_per_metre) if len(diameter) else 0.0
    edges = colours.copy()
    edges[:, :3] *= 0.55
    inner = diameter - rim / points_per_metre
    axes.add_collection(EllipseCollection(
        inner, inner, np.zeros_like(inner), units="xy", offsets=position[:, (0, 2)], transOffset=axes.transData,
        facecolors=colours, edgecolors=edges, linewidths=rim,
    ))
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    axes.spines["top"].set_visible(closed)
    axes.spines["right"].set_visible(True)
    inches = points_per_metre * (right - left) / 72
    narrow = inches < 1.2  # the last label would run into the next panel
    axes.xaxis.set_major_locator(
        MaxNLocator(2 if narrow else int(inches / 0.7), steps=[1, 2, 2.5, 5, 10], prune="upper" if narrow else None)
    )
    axes.set_xlabel("x [m]")


def draw_pressure(axes, record, shown):
    axes.plot(record.time, record.pressure_drop / 1000, color="#31688e", linewidth=1.0, label="pressure drop")
    if record.bed_weight_per_area is not None:
        weight = np.broadcast_to(record.bed_weight_per_area, record.time.shape)
        axes.plot(record.time, weight / 1000, color=INK, linestyle="--", linewidth=1.0, label="bed weight per area")
    for snapshot in shown:
        axes.axvline(snapshot.time, color="0.75", linewidth=0.8, zorder=0)
    axes.set_xlim(float(record.time[0]), float(record.time[-1]))
    # Start-up peaks are cut where they would flatten the rest.
    finite = record.pressure_drop[np.isfinite(record.pressure_drop)] / 1000
    if finite.size:
        low, high = np.percentile(finite, (0.5, 99.5)) if finite.size > 50 else (finite.min(), finite.max())
        ends = [low, high, 0.0] + (list(record.bed_weight_per_area / 1000) if record.bed_weight_per_area is not None else [])
        room = 0.08 * (max(ends) - min(ends)) or 1.0
        axes.set_ylim(min(ends) - (room if min(ends) < 0 else 0), max(ends) + room)
    axes.yaxis.set_major_locator(MaxNLocator(5))
    axes.set(xlabel="t [s]", ylabel="pressure drop [kPa]")
    axes.legend(loc="lower right", fontsize=7, ncol=2, framealpha=0.9, edgecolor="none")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def draw(path, record, shown, scale, box, closed, depth, with_pressure):
    """One picture of the snapshots `shown`, side by side, in inches laid out by hand so that spheres keep their size."""
    count = len(shown)
    aspect = (box[3] - box[2]) / max(box[1] - box[0], 1e-12)
    left, right, gap, above, below = 0.72, 1.0, 0.18, 0.72, 0.5
    width = {1: 4.2, 2: 2.9, 3: 2.4}.get(count, 2.1)
    height = width * aspect
    if not 1.2 <= height <= 8.5:  # a tall column or a flat box
        height = min(max(height, 1.2), 8.5)
        width = min(max(height / aspect, 0.8), 12.0 / count)
        height = width * aspect
    pressure = 1.35 if with_pressure else 0.0
    low = below + (pressure + 0.62 if with_pressure else 0.0)
    inside = count * width + (count - 1) * gap
    # Narrow strips are centred in a picture wide enough for title and pressure drop.
    strip = max(inside, 3.4)
    total = (left + strip + right, low + height + above)
    start = left + (strip - inside) / 2

    def place(x, y, w, h):
        return (x / total[0], y / total[1], w / total[0], h / total[1])

    figure = plt.figure(figsize=total, facecolor=BACKGROUND)
    mapper = plt.cm.ScalarMappable(matplotlib.colors.Normalize(-scale, scale), COLOURS)
    points_per_metre = 72 * width / max(box[1] - box[0], 1e-12)
    for number, snapshot in enumerate(shown):
        axes = figure.add_axes(place(start + number * (width + gap), low, width, height))
        draw_bed(axes, snapshot, mapper, box, closed, depth, points_per_metre)
        axes.set_title(f"t = {snapshot.time:.4g} s", fontsize=9)
        if number == 0:
            axes.set_ylabel("z [m]")
        else:
            axes.tick_params(labelleft=False)
    over = any(np.abs(s.vertical_velocity).max(initial=0) > scale for s in shown)
    bar_height = min(height, 3.2)
    bar = figure.add_axes(place(start + inside + 0.15, low + (height - bar_height) / 2, 0.13, bar_height))
    figure.colorbar(mapper, cax=bar, extend="both" if over else "neither").set_label("vertical velocity [m/s]")
    if with_pressure:
        draw_pressure(figure.add_axes(place(left, below, strip, pressure)), record, shown)
    figure.text(left / total[0], 1 - 0.18 / total[1], record.title, fontsize=11, ha="left", va="top", color=INK)
    if count > 1 and strip > 5:  # inches; beside the title
        figure.text((left + strip) / total[0], 1 - 0.22 / total[1], "spheres at true size, paler farther from the front",
                    fontsize=7, ha="right", va="top", color="0.45")
    figure.savefig(path, dpi=DPI)
    plt.close(figure)


def main():
    given = arguments()
    if not os.path.isdir(given.run):
        raise InputError(f"{given.run}: no such folder; give a run's folder, such as runs/sscp1-CGPM-w8")
    source = os.path.join(given.run, "particles.h5")
    if not os.path.isfile(source):
        raise InputError(f"{given.run} holds no particles.h5: no run of interphase has written particles there")
    record = read_record(given.run)
    plt.rcParams.update({"font.size": 8, "axes.edgecolor": INK, "axes.linewidth": 0.8, "axes.labelcolor": INK,
                         "xtick.color": INK, "ytick.color": INK, "text.color": INK})
    with h5py.File(source, "r") as file:
        all_of_them = snapshots(file)
        times = [time for time, _ in all_of_them]
        if given.series:
            film(given, record, all_of_them)
            return
        if given.time is not None:
            chosen = [int(np.argmin(np.abs(np.asarray(times) - given.time)))]
        else:
            chosen = evenly_spaced(times, PANELS)
        shown = [read_snapshot(*all_of_them[index]) for index in chosen]
    output = given.output or os.path.join(given.run, "bed.png")
    box, closed, depth = view(shown, record.domain)
    draw(output, record, shown, velocity_scale(shown), box, closed, depth,
         given.time is None and record.pressure_drop is not None)
    print(output)


def film(given, record, all_of_them):
    """Every snapshot in a picture of its own; scale and view come from some spread over the run, for all."""
    folder = given.output or os.path.join(given.run, "frames")
    os.makedirs(folder, exist_ok=True)
    some = [all_of_them[i] for i in evenly_spaced([time for time, _ in all_of_them], 12)]
    sample = [read_snapshot(*pair) for pair in some]
    scale, (box, closed, depth) = velocity_scale(sample), view(sample, record.domain)
    for number, pair in enumerate(all_of_them):
        path = os.path.join(folder, f"bed-{number:06d}.png")
        draw(path, record, [read_snapshot(*pair)], scale, box, closed, depth, with_pressure=False)
    print(os.path.join(folder, "bed-*.png"))


if __name__ == "__main__":
    try:
        main()
    except (InputError, OSError, KeyError) as error:
        print(f"tools/picture: error: {error}", file=sys.stderr)
        sys.exit(1)
