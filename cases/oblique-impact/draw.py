# SPDX-License-Identifier: GPL-3.0-or-later
"""Run in.liggghts with the plug-in hard_sphere and draw what comes out beside measurements.csv.

    cases/oblique-impact/draw                          the picture, oblique-impact.png in the current folder, and the rms distances
    cases/oblique-impact/draw --tangential 0.5         another e_t
    cases/oblique-impact/draw --scan                   no picture: rms distances for e_t from 0 to 1, and the e_t of least squares
"""

import argparse
import csv
import os
import sys
import tempfile

import matplotlib
import numpy

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end is chosen first)

HERE = os.path.dirname(os.path.realpath(__file__))
from interphase import InputError, launch, liggghts_dump  # noqa: E402

QUANTITIES = {
    "rebound_angle": "angle of the centre's rebound [deg]",
    "tangential_restitution": "$v_t'/v_t$ of the centre",
    "spin": "spin after the impact [rad/s]",
}
INK, OURS, THEIRS = "0.2", "#1b6ca8", "#d1495b"


def measurements():
    """{quantity: (impact angle [deg, n], value [n])}"""
    with open(os.path.join(HERE, "measurements.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: numpy.array([[float(row["impact_angle"]), float(row["value"])] for row in rows if row["quantity"] == name]).T
            for name in QUANTITIES}  # fmt: skip


def simulate(tangential):
    """(impact angle [deg, n], {quantity: [n]}) for this e_t."""
    with tempfile.TemporaryDirectory(prefix="interphase-") as folder:
        try:
            launch.liggghts(os.path.join(HERE, "in.liggghts"), folder, {"et": tangential}, ["hard_sphere"])
        except (InputError, launch.StepFailed) as error:
            sys.exit(f"draw: {error}")
        before, after = (frame.load().quantities for frame in liggghts_dump.Dump(folder, [os.path.join(folder, "dump")]).frames())
    v, w = before["velocity"], after["velocity"]
    return numpy.degrees(numpy.arctan2(v[:, 0], -v[:, 2])), {
        "rebound_angle": numpy.degrees(numpy.arctan2(w[:, 0], w[:, 2])),
        "tangential_restitution": w[:, 0] / v[:, 0],
        "spin": after["spin"][:, 1],
    }


def distances(measured, angle, simulated):
    """{quantity: rms distance from the measurements}; `angle` is fine enough for a straight line in between."""
    return {name: numpy.sqrt(numpy.mean((numpy.interp(at, angle, simulated[name]) - values) ** 2))
            for name, (at, values) in measured.items()}  # fmt: skip


def told(found):
    return (f"rebound angle {found['rebound_angle']:.2f} deg, tangential restitution {found['tangential_restitution']:.3f}, "
            f"spin {found['spin']:.0f} rad/s")  # fmt: skip


def scan(measured):
    largest = {name: values.max() for name, (_, values) in measured.items()}
    sums = {}
    for tangential in numpy.linspace(0, 1, 51).round(2).tolist():
        found = distances(measured, *simulate(tangential))
        sums[tangential] = sum((found[name] / largest[name]) ** 2 for name in QUANTITIES)
        print(f"e_t = {tangential:.2f}: rms distance of {told(found)}; sum of squares {sums[tangential]:.5f}")
    print(f"least at e_t = {min(sums, key=sums.get)} (each quantity as a share of its largest measurement)")


def picture(measured, angle, simulated, tangential, path):
    plt.rcParams.update({"font.size": 9, "axes.edgecolor": INK, "axes.labelcolor": INK, "xtick.color": INK,
                         "ytick.color": INK, "text.color": INK})  # fmt: skip
    figure, panels = plt.subplots(1, 3, figsize=(10.5, 3.2))
    for axes, (name, label) in zip(panels, QUANTITIES.items()):
        axes.plot(angle, simulated[name], color=OURS, linewidth=1.5, label=f"tdhs, $e_n$ 0.98, $e_t$ {tangential:g}, $\\mu$ 0.092")
        axes.plot(*measured[name], "o", color=THEIRS, markersize=4.5, label="measured (Kharaz et al. 2001)")
        axes.set_xlabel("angle of impact from the normal [deg]")
        axes.set_ylabel(label)
        axes.set_xlim(0, 62)
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
    panels[1].set_ylim(0.5, 1)
    for axes in panels[::2]:
        axes.set_ylim(0)
    panels[0].legend(loc="upper left", frameon=False, fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(prog="draw", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tangential", type=float, default=0.26, help="e_t (0.26)")
    parser.add_argument("--out", default="oblique-impact.png", help="the picture (oblique-impact.png)")
    parser.add_argument("--scan", action="store_true", help="rms distances for e_t from 0 to 1")
    given = parser.parse_args()
    measured = measurements()
    if given.scan:
        return scan(measured)
    angle, simulated = simulate(given.tangential)
    print(f"e_t = {given.tangential:g}: rms distance of {told(distances(measured, angle, simulated))}")
    picture(measured, angle, simulated, given.tangential, given.out)
    print(given.out)


if __name__ == "__main__":
    main()
