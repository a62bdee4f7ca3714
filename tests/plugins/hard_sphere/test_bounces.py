# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""A sphere dropped on a plane comes back to e^2 of its height, bounce after bounce, and the more exactly the shorter the step.

Its centre peaks at r + (h0 - r) e^(2k) after k bounces. The impact is resolved within the step, on the straight path that the
sphere has in it; gravity bends the true path by g dt^2/8, so the error falls faster than the step.
"""

import measured
import numpy

from hard_spheres import HardSphereTest, Scene, Spheres

GRAVITY = 9.81
RADIUS = 5e-3
DROP = 0.1  # of the lowest point [m]
RESTITUTION = (0.5, 0.7, 0.9, 1.0)
BOUNCES = 5
PHASES = 16  # spheres of each restitution, from slightly different heights: an error depends on when in a step a sphere hits
STEPS = (1.6e-3, 8e-4, 4e-4, 2e-4)  # [s]


def peaks(time, height):
    """Heights and times of the maxima between two bounces, from the parabola through three points [(t, h)]."""
    found = []
    for k in range(1, len(height) - 1):
        if height[k - 1] < height[k] >= height[k + 1]:
            a = (height[k + 1] - 2 * height[k] + height[k - 1]) / 2
            b = (height[k + 1] - height[k - 1]) / 2
            found.append((time[k] - b / (2 * a) * (time[1] - time[0]), height[k] - b * b / (4 * a)))
    return found


class Bounces(HardSphereTest):
    @classmethod
    def setUpClass(cls):
        drops = DROP * (1 + 0.02 * numpy.arange(PHASES) / PHASES)
        cls.drop = numpy.tile(drops, len(RESTITUTION))
        cls.kind = numpy.repeat(numpy.arange(len(RESTITUTION)), PHASES)

    def scene(self):
        n = len(self.drop)
        position = numpy.column_stack([0.05 * (1 + numpy.arange(n)), numpy.full(n, 0.1), RADIUS + self.drop])
        laws = numpy.ones((len(RESTITUTION) + 1, len(RESTITUTION) + 1))
        laws[-1, :-1] = laws[:-1, -1] = RESTITUTION
        return Scene(
            Spheres(2 * RADIUS, position, type=1 + self.kind), (0, 0, -0.01), (0.05 * (n + 2), 0.2, 0.2), e=laws,
            types=len(laws), walls=(f"primitive type {len(laws)} zplane 0.0",),
            before=f"fix weight all gravity {GRAVITY} vector 0 0 -1\n",
        )  # fmt: skip

    def errors(self, step):
        """Error of the height above the plane, relative to what it should be [restitution, phases, bounces]."""
        fall = numpy.sqrt(2 * 1.02 * DROP / GRAVITY)
        done = self.run_scene(self.scene(), step, int(fall * (2 * BOUNCES + 2) / step))
        history = done.history()
        errors = numpy.full((len(self.drop), BOUNCES), numpy.nan)
        for i, (drop, kind) in enumerate(zip(self.drop, self.kind)):
            heights = [h - RADIUS for _, h in peaks(history.time, history.position[:, i, 2])]
            self.assertGreaterEqual(len(heights), BOUNCES, f"step {step}, e = {RESTITUTION[kind]}: {heights}")
            expected = drop * RESTITUTION[kind] ** (2 * numpy.arange(1, BOUNCES + 1))
            errors[i] = numpy.array(heights[:BOUNCES]) / expected - 1
        return errors.reshape(len(RESTITUTION), PHASES, BOUNCES)

    def test_heights(self):
        errors = numpy.array([self.errors(step) for step in STEPS])
        size = numpy.sqrt((errors**2).mean(axis=2))  # [steps, restitution, bounces]
        logarithms = numpy.log(size).reshape(len(STEPS), -1)
        order = numpy.polyfit(numpy.log(STEPS), logarithms, 1)[0].reshape(size.shape[1:])
        for e, table, orders in zip(RESTITUTION, size.swapaxes(0, 1), order):
            print(f"e = {e}: error of the height of bounce 1 ... {BOUNCES}, order {numpy.round(orders, 2)}")
            for step, row in zip(STEPS, table):
                print(f"  step {step:.1e} s: " + " ".join(f"{value:.1e}" for value in row))

        # The flattest of all flights, e = 0.5 after five bounces, lasts 9 ms, 45 of the shortest steps.
        measured.below(self, "ball bouncing five times, e = 0.5 to 1, step 0.2 ms: error of the height", 100 * abs(errors[-1]).max(), 1, "%", "e^2 of the height before")
        # Straight paths within a step are an error of second order; of 16 phases the mean is good to a tenth of the order.
        self.assertGreater(order.min(), 1.8)
        measured.within(self, "the same: order in the step, largest of all", order.max(), 2, 0.2, "", "straight paths within a step")
