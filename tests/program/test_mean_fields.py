# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 4
# timeout: 900
"""Mean and variance fields are those of the snapshots and of OpenFOAM's fieldAverage at the same times; a run that is stopped and goes on has
the same to the last bit, one on more ranks the same within round-off. The bed is that of test_resume: spheres are poured into it."""

import os
import unittest

import numpy

import support
import vessel
from interphase import foam_field
from resumed_run import WEIGHTS, ResumedRun

INTERVAL, START = 0.002, 0.01  # [s]
BLOCK = f"""statistics
{{
    interval    {INTERVAL};
    windows     none;
    overlaps    none;
    voidage     none;
    surface     none;
    fields      {{ from {START}; }}
}}
"""
NAMES = ("meanVoidage", "varianceVoidage", "meanU", "varianceU", "meanSolidsU", "varianceSolidsU")
SIDE, CELLS = 0.006, (8, 4, 16)  # of the cells [m]
ROUND_OFF = 1e-12  # of sums over some ten spheres and samples of numbers of one


def in_cells(snapshot, solid_step):
    """Solid volume [n, m3] and velocity [n x 3, m/s] of each cell; spheres begin a step with half a kick by the force on them."""
    x, y, z = numpy.floor(snapshot["position"] / SIDE).astype(int).T
    cell = x + CELLS[0] * (y + CELLS[1] * z)
    volumes = numpy.pi / 6 * snapshot["diameter"] ** 3
    start = snapshot["velocity"] + solid_step / 2 * snapshot["force"] / (snapshot["density"] * volumes)[:, None]

    def summed(weights):
        return numpy.bincount(cell, weights, minlength=numpy.prod(CELLS))

    volume = summed(volumes)
    flow = numpy.stack([summed(volumes * v) for v in start.T], axis=1)
    return volume, numpy.divide(flow, volume[:, None], out=numpy.zeros_like(flow), where=volume[:, None] > 0)


def mean_and_variance(values, weights):
    """Of [samples, n, q] by [samples, n]; 0 where there is no weight."""
    weights = weights[..., None]
    total = numpy.maximum(weights.sum(axis=0), 1e-300)
    mean = (weights * values).sum(axis=0) / total
    return mean, (weights * (values - mean) ** 2).sum(axis=0) / total


class MeanFields(ResumedRun, support.ProgramTest):
    stop, end = 0.02, 0.04

    def case(self, folder):
        """With the block above, and fields written at the stop."""
        self.edit(folder, "system/couplingDict", r"^statistics\n\{[\s\S]*?^\}\n", BLOCK)
        self.set_entry(folder, "system/controlDict", "writeInterval", self.stop)
        return folder

    def expect_means_of_snapshots(self, done, end):
        """The gas feels in a step the spheres as they were when it began."""
        snapshots, step = done.snapshots(), done.meta["solid_step"]
        times = numpy.arange(START, end + INTERVAL / 2, INTERVAL) - vessel.GAS_STEP
        taken = [in_cells(snapshots[min(snapshots, key=lambda one: abs(one - time))], step) for time in times]
        volume, velocity = (numpy.array(each) for each in zip(*taken))
        voidage = 1 - volume / SIDE**3
        self.assertGreater(voidage.min(), 0.26)  # no cell is above the packing limit, and hands over
        self.assertTrue((volume == 0).all(axis=0).any())
        expected = dict(zip(NAMES[:2], (voidage.mean(axis=0), voidage.var(axis=0))))
        expected.update(zip(NAMES[4:], mean_and_variance(velocity, volume)))
        for name, values in expected.items():
            numpy.testing.assert_allclose(done.run.fields(name, end).values, values, rtol=0, atol=ROUND_OFF, err_msg=name)
        return len(times)

    def test_are_those_of_snapshots_and_of_openfoam(self):
        folder = self.case(self.ready("DEM")[0])
        self.edit(folder, "system/couplingDict", r"type +kernel;", "type cellCentre;")
        self.set_entry(folder, "system/couplingDict", "records/snapshotInterval", vessel.GAS_STEP)
        self.edit(folder, "system/controlDict", r"enabled +no;\n +timeStart +10;",
                  f"timeStart {START}; executeControl timeStep; executeInterval {round(INTERVAL / vessel.GAS_STEP)};")  # fmt: skip
        done = self.run_case(folder)
        self.expect_means_of_snapshots(done, self.stop)
        samples = self.expect_means_of_snapshots(done, self.end)
        for name, unit in zip(NAMES, ("1", "1", "m/s", "m2/s2", "m/s", "m2/s2")):
            self.assertEqual(done.run.fields(name, self.end).unit, unit, name)
        for time in (self.stop, self.end):
            for own, theirs, parts in (("meanVoidage", "voidageMean", ...), ("varianceVoidage", "voidagePrime2Mean", ...),
                                       ("meanU", "UMean", ...), ("varianceU", "UPrime2Mean", (..., [0, 3, 5]))):  # fmt: skip
                numpy.testing.assert_allclose(done.run.fields(own, time).values, done.run.fields(theirs, time).values[parts], rtol=0,
                                              atol=ROUND_OFF, err_msg=own)  # fmt: skip
        with done.results() as file:
            said = dict(file["statistics"].attrs)
            self.assertEqual((file["statistics/time"][:] > START - 1e-9).sum(), samples)
        self.assertEqual(said["mean_fields_samples"], samples)
        numpy.testing.assert_allclose([said["mean_fields_first"], said["mean_fields_last"]], [START, self.end], atol=1e-9)

    def check(self, method, ranks=1):
        straight, stopped = map(self.case, self.ready(method, ranks))
        self.compare(straight, stopped, ranks)
        for part in ("",) if ranks == 1 else [f"processor{rank}" for rank in range(ranks)]:
            for name in NAMES:
                self.assertEqual(*(foam_field.content(os.path.join(folder, part, f"{self.end:g}", name)) for folder in (straight, stopped)), name)

    def test_go_on_on_two_ranks(self):
        self.check("CGPM", ranks=2)

    def test_go_on_with_a_stress(self):
        self.check("MPPIC")

    def test_time_taken_is_that_of_all_parts(self):
        folder = self.case(self.ready("CGPM")[1])
        spent = []
        for end, options in ((self.stop, ()), (self.end, ["-resume"])):
            self.set_entry(folder, "system/controlDict", "endTime", end)
            with self.run_case(folder, options=options).results() as file:
                spent.append(file["statistics"].attrs["wall_time"])
        self.assertGreater(spent[1], spent[0])
        # a third part that is at its end at once takes no sample
        with self.run_case(folder, options=["-resume"]).results() as file:
            self.assertEqual(file["statistics"].attrs["wall_time"], spent[1])

    def test_are_alike_on_more_ranks(self):
        """Spheres at rest, so that a difference does not grow by collisions, and a gas that is solved to round-off."""
        lines, _ = vessel.bed(4, diameter=vessel.DIAMETER * WEIGHTS["CGPM"] ** (1 / 3))
        case = vessel.case(os.path.join(self.root, "rest"), particles=lines)
        tight = {"system/fvSolution:solvers/p_rgh/tolerance": 1e-13, "system/fvSolution:solvers/p_rgh/relTol": 0,
                 'system/fvSolution:solvers/"(U|UFinal)"/tolerance': 1e-13}  # fmt: skip
        found = []
        for ranks in (1, 2, 4):
            folder = self.case(vessel.prepared(self, case, "CGPM", ranks, self.stop, weight=WEIGHTS["CGPM"], **tight))
            self.edit(folder, "system/fvSolution", r"^ *smoother +GaussSeidel;$", "smoother GaussSeidel; maxIter 100;")
            done = self.run_case(folder, ranks)
            if ranks > 1:
                command = ["reconstructPar", "-case", folder, "-latestTime"]
                support.launch.step(command, os.path.join(folder, "log.reconstructPar"), support.environment(), folder)
            found.append({name: done.run.fields(name, self.stop).values for name in NAMES})
        self.assertGreater(found[0]["varianceU"].max(), 0)
        for other in found[1:]:
            for name in NAMES:
                # of what solvers that stop at 1e-13 leave in 20 steps, 2e-11 of a velocity of 1.9 m/s were seen
                numpy.testing.assert_allclose(other[name], found[0][name], rtol=0, atol=1e-9, err_msg=name)


if __name__ == "__main__":
    unittest.main()
