#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two spheres meet; one meets a wall. What the fix promises is checked on 1 and 2 ranks: momentum stays, to round-off, and
the speeds after a collision are `restitution` times those before.

ctest sets RUNNER (interphase-liggghts) and PLUGIN (the library).
"""

import os
import subprocess
import tempfile
import unittest

RESTITUTION = 0.7

# The spheres meet at x = 0.05 m, where two ranks meet too.
SCRIPT = f"""
units           si
atom_style      granular
atom_modify     map array sort 0 0
boundary        f f f
newton          off
communicate     single vel yes
processors      * 1 1
region          box block 0 0.1 0 0.1 0 0.1 units box
create_box      1 box
create_atoms    1 single 0.040 0.05 0.05 units box
create_atoms    1 single 0.061 0.05 0.05 units box
set             atom 1 diameter 0.010 density 2000
set             atom 2 diameter 0.014 density 1000
velocity        all set ${{vx}} ${{vy}} ${{vz}} units box
group           second id 2
velocity        second set -${{vx}} 0.0 0.0 units box
neighbor        0.005 bin
fix             push all @NAME@/spheres stiffness 1000 restitution {RESTITUTION}
fix             move all nve/sphere
dump            state all custom ${{steps}} state id vx vy vz mass
dump_modify     state sort id format "%d %.17g %.17g %.17g %.17g"
timestep        5e-6
run             ${{steps}}
"""


def run(ranks, steps, **variables):
    """The states (id, vx, vy, vz, mass) of both spheres at the start and at the end."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "in.script"), "w", encoding="utf-8") as file:
            file.write(SCRIPT)
        command = [os.environ["RUNNER"], "-plugin", os.environ["PLUGIN"], "-in", "in.script", "-log", "none"]
        for name, value in {"steps": steps, **variables}.items():
            command += ["-var", name, str(value)]
        if ranks > 1:
            command = ["mpirun", "-n", str(ranks), "--oversubscribe", *command]
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=100)
        if done.returncode != 0:
            raise AssertionError(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
        with open(os.path.join(folder, "state"), encoding="utf-8") as file:
            rows = [[float(word) for word in line.split()] for line in file if line[0].isdigit() and line.count(" ") >= 4]
    return rows[:2], rows[-2:]


class Collisions(unittest.TestCase):
    def test_two_spheres(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                before, after = run(ranks, 4000, vx=1.0, vy=0.0, vz=0.0)
                parting = (after[0][1] - after[1][1]) / (before[0][1] - before[1][1])
                self.assertAlmostEqual(parting, -RESTITUTION, delta=0.01 * RESTITUTION)
                momentum = [sum(row[1] * row[4] for row in rows) for rows in (before, after)]
                self.assertAlmostEqual(momentum[0], momentum[1], delta=1e-14 * before[0][4])

    def test_a_wall(self):
        """One sphere flies down to the floor and comes back."""
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                before, after = run(ranks, 12000, vx=0.0, vy=0.0, vz=-1.0)
                self.assertAlmostEqual(after[0][3] / before[0][3], -RESTITUTION, delta=0.01 * RESTITUTION)


if __name__ == "__main__":
    unittest.main()
