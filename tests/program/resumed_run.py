# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that is stopped and goes on from its last checkpoint is the run that was not stopped: particles, gas, clock, books and counts are
equal to the last bit, with every method, while spheres are poured in."""

import os
import re

import numpy

import support
import vessel
from vessel import DENSITY, DEPTH, DIAMETER, WIDTH

# some in every second gas step; parcels of eight are twice as wide
POUR = """\
fix one all particletemplate/sphere 15485863 atom_type 1 density constant {density} radius constant {radius}
fix kinds all particledistribution/discrete 32452843 1 one 1.0
region fill block 0.002 {x} 0.002 {y} 0.07 0.09 units box
fix pour all insert/rate/region seed 49979687 distributiontemplate kinds nparticles 100000 particlerate 5000 insert_every {every} &
    overlapcheck yes all_in yes vel constant 0 0 -0.5 region fill
"""
WEIGHTS = {"DEM": 1, "CGPM": 8, "TDHS": 1, "CGHS": 8, "MPPIC": 8, "PLUGIN": 1}


def states(checkpoint, ranks):
    """The state of each rank, as bytes."""
    found = []
    for rank in range(ranks):
        with open(os.path.join(checkpoint, f"rank{rank}.state"), "rb") as stream:
            found.append(stream.read())
    return found


def parts(state):
    """{name: bytes} of a state."""
    found, at, words = {}, 0, []
    while at < len(state):
        size = int.from_bytes(state[at : at + 8], "little")
        words.append(state[at + 8 : at + 8 + size])
        at += 8 + size
    for name, value in zip(words[::2], words[1::2]):
        found[name.decode()] = value
    del found["spent"], found["processor/seconds"]  # no two runs take the same
    found.pop("statistics/seconds", None)
    return found


class ResumedScene:
    """A bed into which spheres are poured."""

    @staticmethod
    def weight(method):
        return WEIGHTS[method]

    def bed(self, method):
        diameter = DIAMETER * WEIGHTS[method] ** (1 / 3)
        lines, self.count = vessel.bed(6 if WEIGHTS[method] == 1 else 4, diameter=diameter)
        every = {"DEM": 40, "CGPM": 40, "PLUGIN": 40}.get(method, 2)
        pour = POUR.format(density=DENSITY, radius=diameter / 2, x=WIDTH - 0.002, y=DEPTH - 0.002, every=every)
        root = os.path.join(self.root, f"bed{len(os.listdir(self.root))}")
        return vessel.case(root, particles=lines, fixes=pour)


class ResumedRun(ResumedScene):
    """With `stop` and `end` [s]: multiples of the one, gas steps of a thousandth."""

    def ready(self, method, ranks=1, **settings):
        return self.copies(self.bed(method), method, ranks, **settings)

    def copies(self, case, method, ranks=1, **settings):
        """The case twice, each with checkpoints at the stop and at the end."""
        folder = vessel.prepared(self, case, method, ranks, self.end, weight=WEIGHTS[method], **settings)
        coupling = os.path.join(folder, "system/couplingDict")
        support.write(coupling, support.read(coupling) + f"\ncheckpoint {{ interval {self.stop}; }}\n")
        return folder, self.copied(folder, f"stopped-{method}-{ranks}")

    def resumed(self, folder, ranks=1):
        self.set_entry(folder, "system/controlDict", "endTime", self.stop)
        self.run_case(folder, ranks)
        self.set_entry(folder, "system/controlDict", "endTime", self.end)
        return self.run_case(folder, ranks, options=["-resume"])

    def check_plugin(self, plugins, replaced, ranks, method="PLUGIN"):
        """Compares a bed of the plug-ins' own fixes: those of the method (PLUGIN: of the case's hard spheres) with texts `replaced` {before: after}, each of them there."""
        case = self.bed(method)
        text = support.read(os.path.join(case, "dem", f"{'hard_spheres' if method == 'PLUGIN' else method}.liggghts"))
        for before, after in replaced.items():
            self.assertIn(before, text)
            text = text.replace(before, after)
        support.write(os.path.join(case, "dem", f"{method}.liggghts"), text)
        self.edit(case, "system/couplingDict", r"^plugins .*$", f"plugins ({plugins});")
        self.compare(*self.copies(case, method, ranks), ranks)

    def check(self, method, ranks=1):
        self.compare(*self.ready(method, ranks), ranks)

    def compare(self, straight, stopped, ranks=1):
        """A case that runs through with its copy that is stopped."""
        whole = self.run_case(straight, ranks)
        done = self.resumed(stopped, ranks)
        self.expect_equal([os.path.join(folder, "checkpoints", f"{self.end:g}") for folder in (straight, stopped)], whole, done, ranks)

    def expect_equal(self, checkpoints, whole, done, ranks=1):
        """The two checkpoints, and what the two runs recorded last."""
        for rank, pair in enumerate(zip(*(states(checkpoint, ranks) for checkpoint in checkpoints))):
            expected, found = map(parts, pair)
            self.assertEqual(expected.keys(), found.keys())
            differ = [name for name in expected if expected[name] != found[name]]
            self.assertEqual(differ, [], f"rank {rank}{self.warnings_of(whole, done) if differ else ''}")
        ends = [max(each.snapshots().items()) for each in (whole, done)]
        self.assertEqual(ends[0][0], ends[1][0])
        self.assertGreater(len(ends[0][1]["id"]), self.count)
        for name, values in ends[0][1].items():
            self.assertEqual(values.tobytes(), ends[1][1][name].tobytes(), name)
        self.expect_equal_rows(whole, done)

    @staticmethod
    def warnings_of(*runs):
        """What OpenFOAM warned of in each."""
        logs = [support.read(run.path("log.openfoam")) for run in runs]
        return "".join("\n" + "\n".join(re.findall(r"--> FOAM (?:Warning|Serious)(?:.*\n){1,6}", log)) for log in logs)

    def expect_equal_rows(self, whole, done):
        """The series, the books and the statistics have no seam."""
        with whole.results() as expected, done.results() as found:
            for table in ("series", "ledger", "statistics", "taps"):
                self.assertEqual(table in expected, table in found)
                for name, column in expected.get(table, {}).items():
                    self.assertEqual(column[:].tobytes(), found[table][name][:].tobytes(), f"{table}/{name}")
            self.expect_counted_on(found["processor_time"], found["series"])

    def expect_counted_on(self, spent, series):
        """Of its processors a run counts on where it goes on."""
        self.assertEqual(spent["time"][:].tobytes(), series["time"][:].tobytes())
        for phase in ("solids", "gas", "setup") if "pressure_drop" in series else ("solids", "setup"):
            steps = numpy.diff(spent[phase][:])
            self.assertGreaterEqual(steps.min(), 0, phase)
            self.assertGreater(spent[phase][-1], 0, phase)


class ResumedMethods(ResumedRun):
    """All of them."""

    def test_dem(self):
        self.check("DEM")

    def test_parcels_with_springs(self):
        self.check("CGPM", ranks=2)

    def test_hard_spheres(self):
        self.check("TDHS")

    def test_hard_parcels(self):
        self.check("CGHS", ranks=2)

    def test_mp_pic(self):
        self.check("MPPIC")
