# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
"""Agglomerates in a stream of gas: spheres that stick to a plane, in a chain downstream of it, are blown off where their drag is the force that
parts them, and the chain parts where that force is least for what hangs on it.

Each of n spheres feels the drag D of the law: the bond of the first one to the plane carries n D, the one behind the k-th sphere (n - k) D.
"""

import os

import numpy

import gas_box
import support
from hard_spheres import Spheres
from interphase.drag_laws import LAWS
from law_scenes import law_scene

RADIUS = 1e-3
PLANE = 0.05  # z [m]; gas passes it
RANGE = 2e-4
SPEED = 0.5  # of the gas, upwards [m/s]
GAS_DENSITY, VISCOSITY = 1.2, 1.8e-5
DRAG = 6 * numpy.pi * VISCOSITY * RADIUS * SPEED * LAWS["SchillerNaumann"](1.0, GAS_DENSITY * SPEED * 2 * RADIUS / VISCOSITY)

# Spheres in the chain; force of its foot over that of its other bonds; drag of a sphere that parts it, over the latter force; how many stay then.
CHAINS = ((1, 1, 1, 0), (2, 1, 1 / 2, 0), (3, 1, 1 / 3, 0), (3, 2, 1 / 2, 1), (4, 4, 1 / 3, 1))


class BlownOff(support.ProgramTest):
    def stay(self, share, coupling):
        """How many of each chain are at their places after 0.2 s, their drag being `share` of what parts it, and the run."""
        wall = len(CHAINS) + 1
        work = numpy.zeros((wall, wall))
        places, types = [], []
        for k, (n, foot, parts, _) in enumerate(CHAINS):
            force = DRAG / (share * parts)
            work[k, k] = force / (numpy.pi * RADIUS)  # 2 pi w r_e: r_e is half a radius between two, a radius at the plane
            work[k, -1] = work[-1, k] = foot * force / (2 * numpy.pi * RADIUS)
            x, y = 0.0125 + 0.025 * numpy.array([k % 4, 2 * (k // 4)])  # the middle of a gas cell
            places += [[x, y, PLANE + RADIUS + 2 * RADIUS * j] for j in range(n)]
            types += n * [k + 1]
        spheres = Spheres(2 * RADIUS, places, density=100.0, type=types)  # light: what is parted leaves soon
        scene = law_scene("cohesive", spheres, (0, 0, 0), (0.1, 0.1, 0.2), e=0.5, mu=0.3, types=wall, walls=(f"primitive type {wall} zplane {PLANE}",))
        scene.properties = {"workOfAdhesion": scene.matrix(work), "cohesionRange": scene.matrix(RANGE)}

        patches = {side: {"U": "type slip;"} for side in ("left", "right", "front", "back")}
        folder = gas_box.write(os.path.join(self.root, f"{coupling}{share}"), patches, end=0.2, density=GAS_DENSITY, viscosity=VISCOSITY,
                               at_start=f"(0 0 {SPEED})")  # fmt: skip
        self.edit(folder, "constant/g", "-9.81", "0")
        self.edit(folder, "system/couplingDict", "method DEM;", "method TDHS; plugins (hard_sphere laws);")
        self.edit(folder, "system/couplingDict", "oneWay", coupling)
        support.write(os.path.join(folder, "dem/in.liggghts"), scene.script() + "thermo_modify norm no lost ignore\n")
        support.write(os.path.join(folder, "spheres.data"), scene.data())
        done = self.run_case(folder)
        gone = done.last()["position"][:, 2] - spheres.position[:, 2]
        self.assertTrue(((abs(gone) < 0.01 * RANGE) | (gone > RANGE)).all(), gone)  # between is neither here nor there
        return [int((gone[spheres.type == k + 1] < RANGE).sum()) for k in range(len(CHAINS))], done

    def check(self, coupling, within):
        whole, parted = [n for n, *_ in CHAINS], [stay for *_, stay in CHAINS]
        for share, expected in ((1 - within, whole), (1 + within, parted)):
            with self.subTest(coupling, share=share):
                found, done = self.stay(share, coupling)
                self.assertEqual(found, expected)

    def test_in_a_stream_that_does_not_feel_them(self):
        """Solids of a gas cell, 0.0003 of it for each sphere, change the drag by 0.1 %."""
        self.check("oneWay", 0.002)

    def test_in_a_stream_that_they_slow_down(self):
        """What a sphere does to the gas of its own cell is taken out within 5 % of the drag; those of its chain are in the same cell."""
        self.check("twoWay", 0.05)
