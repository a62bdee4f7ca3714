# SPDX-License-Identifier: GPL-3.0-or-later
"""A bed of hard spheres that falls and comes to rest, without gas: what tools/bench takes the time of."""

import contextlib
import io
import math
import os
import re
import tempfile
from dataclasses import dataclass, field

from interphase import launch
from interphase.commands import bed

PARTS = ("search", "walls", "contacts", "integration", "communication")
DIAMETER, DENSITY = 3.256e-3, 1131.0  # m, kg/m3: those of sscp1
SCENE = """units si
atom_style granular
atom_modify map array sort 200 {bins}
boundary f f f
newton off
communicate single vel yes
read_data bed.data
neighbor {diameter} bin
neigh_modify delay 0
fix en all property/global coefficientRestitution peratomtypepair 2 0.84 0.92 0.92 0.92
fix et all property/global tangentialRestitution peratomtypepair 2 0.84 0.92 0.92 0.92
fix mu all property/global coefficientFriction peratomtypepair 2 0.35 0.35 0.35 0.35
{properties}fix w1 all wall/{style} primitive type 2 xplane 0
fix w2 all wall/{style} primitive type 2 xplane {width}
fix w3 all wall/{style} primitive type 2 yplane 0
fix w4 all wall/{style} primitive type 2 yplane {width}
fix w5 all wall/{style} primitive type 2 zplane 0
fix gravity all gravity 9.81 vector 0 0 -1
fix hs all {style}
timestep 3.5e-4
thermo_style custom step atoms v_hs_pairs {parts}
thermo 1000000
"""


@dataclass
class Law:
    """A fix style of hard spheres: of which plug-in, and the properties {name: value of all pairs of types} that it has beside those of `tdhs`. `environment`: of another
    build, {variable: text}."""

    plugin: str = "hard_sphere"
    style: str = "tdhs"
    properties: dict = field(default_factory=dict)
    environment: dict = field(default_factory=dict)


@dataclass
class Span:
    """What steps took, all of them: seconds per step as a whole and by part {name: seconds}; pairs within the margin at their end."""

    seconds: float
    parts: dict
    pairs: float


def loop_seconds(said):
    """Of each `run` of a script."""
    return [float(seconds) for seconds in re.findall(r"Loop time of (\S+)", said)]


def spans(count, steps, law=Law()):
    """[Span] of as many steps each, one after the other: the bed of `count` spheres falls from a lattice of 0.4 at the start and rests after some 800."""
    width = max(8 * DIAMETER, (count * math.pi / 6 * DIAMETER**3 / 0.4 / 4) ** (1 / 3))
    with tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
        with contextlib.redirect_stdout(io.StringIO()):
            bed.main(["--count", str(count), "--diameter", repr(DIAMETER), "--density", repr(DENSITY), "--box", "0", repr(width), "0", repr(width), "0",
                      repr(12 * width), "--packing", "0.4", "--types", "2", "--out", os.path.join(scratch, "bed.data")])  # fmt: skip
        properties = "".join(f"fix {name} all property/global {name} peratomtypepair 2{4 * f' {value!r}'}\n" for name, value in law.properties.items())
        with open(os.path.join(scratch, "in.bed"), "w") as stream:
            stream.write(SCENE.format(bins=2 * DIAMETER, diameter=DIAMETER, width=width, style=law.style, properties=properties,
                                      parts=" ".join(f"v_hs_{part}" for part in PARTS)))  # fmt: skip
            stream.writelines(f"run {number}\n" for number in steps)
        said = launch.liggghts("in.bed", scratch, plugins=[law.plugin], environment=law.environment)
    rows = [list(map(float, line.split())) for line in said.splitlines() if re.fullmatch(r"[\d\s.e+-]+", line) and len(line.split()) == 3 + len(PARTS)]
    before, after = rows[0::2], rows[1::2]
    return [Span(seconds / number, {part: (b[k] - a[k]) / number for k, part in enumerate(PARTS, 3)}, b[2])
            for seconds, number, a, b in zip(loop_seconds(said), steps, before, after)]  # fmt: skip
