# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere thrown along a rough plane slips until it rolls: at 5/7 of its first speed, after 2/7 u0/(mu g).

Friction mu m g slows the centre by mu g and spins the sphere up by 5/2 mu g/r, until the point of contact stands still
(Lamb, Statics, 1912, and every textbook since). Then it rolls on for ever: a hard plane takes no energy from it.
"""

import measured
import numpy

from hard_spheres import HardSphereTest, Scene, Spheres

GRAVITY = 9.81
RADIUS = 5e-3
CASES = [(u0, mu) for u0 in (0.2, 1.0, 3.0) for mu in (0.1, 0.3, 0.6)]
STEP = 2e-4


class SlipToRoll(HardSphereTest):
    def history(self, angle, beside_a_wall):
        """All cases side by side, each with its own material, thrown at `angle` from the x axis [rad]. A smooth wall along its
        way makes a sphere one of two contacts, for which the iterative solver is responsible."""
        n = len(CASES)
        speed, mu = numpy.array(CASES).T
        floor, side = n + 1, n + 2
        frictions = numpy.zeros((side, side))
        frictions[floor - 1, :n] = frictions[:n, floor - 1] = mu
        position = numpy.column_stack([numpy.full(n, 0.1), 0.1 + 0.1 * numpy.arange(n), numpy.full(n, RADIUS)])
        velocity = speed[:, None] * [numpy.cos(angle), numpy.sin(angle), 0]
        walls = [f"primitive type {floor} zplane 0.0"]
        if beside_a_wall:
            walls += [f"primitive type {side} yplane {y - RADIUS!r}" for y in position[:, 1].tolist()]
        scene = Scene(
            Spheres(2 * RADIUS, position, velocity, type=1 + numpy.arange(n)), (0, -1, -0.01), (4, 5, 0.1), e=0.5, et=0.5,
            mu=frictions, types=side, walls=walls, before=f"fix weight all gravity {GRAVITY} vector 0 0 -1\n",
        )  # fmt: skip
        longest = (2 / 7 * speed / (mu * GRAVITY)).max()
        return self.run_scene(scene, STEP, int(1.2 * longest / STEP)).history()

    def check(self, angle=0.0, beside_a_wall=False, round_off=1e-9):
        h = self.history(angle, beside_a_wall)
        along = numpy.array([numpy.cos(angle), numpy.sin(angle), 0])
        spin_axis = numpy.array([-numpy.sin(angle), numpy.cos(angle), 0])
        rolls, ends = [], []
        for i, (u0, mu) in enumerate(CASES):
            speed = h.velocity[:, i] @ along / u0
            rolling = RADIUS * h.spin[:, i] @ spin_axis / u0
            time = mu * GRAVITY * h.time / u0
            slipping = (speed > 0.75) & (time > 0)
            # the straight line of the slip meets the speed of rolling
            slope, start = numpy.polyfit(time[slipping], speed[slipping], 1)
            end = (speed[-1] - start) / slope
            last_slip = time[speed - rolling > 1e-5][-1]
            rolls.append(abs(speed[-1] - 5 / 7))
            ends.append(abs(end - 2 / 7))
            with self.subTest(u0=u0, mu=mu, angle=angle, beside_a_wall=beside_a_wall):
                # Each step's impulse of friction is exact, and so are speed and spin; the slip's end is within a step.
                self.assertAlmostEqual(rolling[-1], 5 / 7, delta=round_off)
                self.assertLess(abs(last_slip - 2 / 7), 0.01 * 2 / 7 + mu * GRAVITY * STEP / u0)
                # on the plane all the time, and straight on
                self.assertLess(abs(h.position[:, i, 2] / RADIUS - 1).max(), max(round_off, 1e-9))
                self.assertLess(abs(h.velocity[:, i] @ spin_axis).max(), round_off * u0)
        name = f"sphere slipping along a plane{' beside a wall' if beside_a_wall else ''}, thrown at {angle:g} rad: "
        measured.below(self, name + "speed at which it rolls off 5/7 of the first", max(rolls), round_off, "", "Lamb, Statics (1912)")
        measured.below(self, name + "time of slip off 2/7 u/(mu g)", max(ends), 1e-4, "", "Lamb, Statics (1912)")

    def test_alone(self):
        for angle in (0.0, 1.1):
            self.check(angle)

    def test_beside_a_wall(self):
        # impulses of several contacts are kept in single precision
        self.check(beside_a_wall=True, round_off=1e-7)
