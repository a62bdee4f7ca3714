#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""A run goes on from its last checkpoint on more or fewer ranks: what was saved is there to the last bit, in other places, and 20 gas steps later
it is the run that was not stopped, within the growth of round-off; with every method, while spheres are poured in."""

import os
import shutil
import sys
import unittest

import numpy

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import support  # noqa: E402
from resumed_run import ResumedRun  # noqa: E402


GAS = ("U", "p_rgh", "p", "phi", "voidage")


class ResumeOnOtherRanks(ResumedRun, support.ProgramTest):
    stop, end = 0.02, 0.04

    def parted(self, method, ranks, **settings):
        """A case that runs on so many ranks, and writes the gas with all digits at the stop. Gas solved to round-off: with the case's own
        tolerances ranks differ by what their solvers leave."""
        case = getattr(self, "case", None) or self.bed(method)
        self.case = case
        tight = {"system/fvSolution:solvers/p_rgh/tolerance": 1e-13, "system/fvSolution:solvers/p_rgh/relTol": 0,
                 'system/fvSolution:solvers/"(U|UFinal)"/tolerance': 1e-13}
        folder, stopped = self.copies(case, method, ranks, **tight, **settings)
        shutil.rmtree(stopped)
        self.edit(folder, "system/fvSolution", r"^ *smoother +GaussSeidel;$", "smoother GaussSeidel; maxIter 100;")
        for entry, value in (("writeFormat", "ascii"), ("writePrecision", 17), ("writeInterval", self.stop)):
            self.set_entry(folder, "system/controlDict", entry, value)
        self.set_entry(folder, "system/couplingDict", "records/snapshotInterval", self.stop)
        return folder

    def go_on(self, source, target, ranks, end):
        """The run `target` from the stop of `source`, on other ranks."""
        checkpoints = os.path.join(target, "checkpoints")
        shutil.rmtree(checkpoints, ignore_errors=True)
        shutil.copytree(os.path.join(source, "checkpoints", f"{self.stop:g}"), os.path.join(checkpoints, f"{self.stop:g}"))
        self.set_entry(target, "system/controlDict", "endTime", end)
        return self.run_case(target, ranks, options=["-resume"])

    def gas_at(self, folder, ranks):
        """The gas at the stop, as texts with all digits: {field: everything but the file's head}."""
        if ranks > 1:
            support.launch.step(["reconstructPar", "-case", folder, "-time", f"{self.stop:g}"],
                                os.path.join(folder, "log.reconstructPar"), support.environment(), folder)
        return {name: support.read(folder, f"{self.stop:g}", name).split("dimensions", 1)[1] for name in GAS}

    def expect_same_at_stop(self, source, target, before, after):
        there, here = (run.snapshots() for run in (before, after))
        first, second = there[self.stop], here[self.stop]
        for name in first:
            self.assertEqual(first[name].tobytes(), second[name].tobytes(), name)

    def expect_close(self, whole, done):
        """Round-off grows with collisions: 20 gas steps of a bed at rest with spheres that fall on it."""
        ends = [max(each.snapshots().items()) for each in (whole, done)]
        self.assertEqual(ends[0][0], ends[1][0])
        first, second = ends[0][1], ends[1][1]
        print(len(first["id"]), len(second["id"]))
        n = min(first["id"].max(), second["id"].max())
        for name in ("position", "velocity"):
            print(name, numpy.abs(first[name][:self.count] - second[name][:self.count]).max())

    def check(self, method, *ranks):
        first = ranks[0]
        source = self.parted(method, first)
        whole = self.run_case(source, first)
        gas = self.gas_at(source, first)
        at_stop = None
        for other in ranks[1:]:
            target = self.parted(method, other)
            at = self.go_on(source, target, other, self.stop)
            print(method, first, other, at.err)
            print(list(whole.snapshots()), list(at.snapshots()), at.out[-300:])
            a, b = ([v for t, v in r.snapshots().items() if abs(t - self.stop) < 1e-6][0] for r in (whole, at))
            for name in a:
                print(name, (a[name] == b[name]).all(), numpy.abs(a[name]-b[name]).max())
            there = self.gas_at(target, other)
            for name in GAS:
                print(name, gas[name] == there[name])
                support.write(f"/tmp/gas/{name}.a", gas[name]); support.write(f"/tmp/gas/{name}.b", there[name])
            for name in ("results.h5", "particles.h5", "particles.xdmf"):
                pass
            done = self.go_on(source, target, other, self.end)
            self.expect_close(whole, done)

    def test_x(self):
        method, ranks = os.environ["X"].split(":")
        self.check(method, *map(int, ranks.split(",")))


for inherited in [name for name in dir(ResumedRun) if name.startswith("test_")]:
    setattr(ResumeOnOtherRanks, inherited, None)

if __name__ == "__main__":
    unittest.main()
