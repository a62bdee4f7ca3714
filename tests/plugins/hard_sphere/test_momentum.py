# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 600
"""Whatever collides, momentum stays: a cloud of rough rotating spheres, sizes 1 to 10, on 1, 2 and 4 ranks.

The same impulse goes to both spheres of a contact, so linear momentum is kept to round-off however a contact is resolved, and on
however many ranks. Impulses act at one point, so the angular momentum of a free pair is kept, too.
"""

import measured
import numpy

from hard_spheres import HardSphereTest, Scene, Spheres

RANKS = (1, 2, 4)
STEPS, STEP = 1000, 5e-5


def cloud(edge=0.03, solid_fraction=0.15, seed=3):
    """Spheres of 1 to 10 mm diameter (a few of the large), none overlapping across the periodic box, at 1 m/s and 300 rad/s."""
    draw = numpy.random.default_rng(seed)
    left = solid_fraction * edge**3
    sizes = []
    while left > 0:
        # equal volume in equal parts of the logarithm of size
        d = 1e-3 * (1 + draw.uniform(0, 1) * (10 ** -2 - 1)) ** (-1 / 2)
        d = min(d, 0.01)
        sizes.append(d)
        left -= numpy.pi / 6 * d**3
    diameter = numpy.sort(sizes)[::-1]
    position = numpy.zeros((0, 3))
    for k, d in enumerate(diameter):
        while True:
            place = draw.uniform(0, edge, 3)
            apart = position - place
            apart -= edge * numpy.round(apart / edge)
            if (numpy.linalg.norm(apart, axis=1) > (diameter[:k] + d) / 2).all():
                break
        position = numpy.vstack([position, place])
    n = len(diameter)
    return diameter, position, draw.normal(size=(n, 3)), 300 * draw.normal(size=(n, 3))


def sums(spheres, velocity, spin):
    """Momentum [3], energy of translation and of rotation, size of the momenta."""
    mass, inertia = spheres.mass[:, None], spheres.inertia[:, None]
    return ((mass * velocity).sum(axis=0), (mass * velocity**2).sum() / 2, (inertia * spin**2).sum() / 2,
            (mass * numpy.linalg.norm(velocity, axis=1, keepdims=True)).sum())  # fmt: skip


class Cloud(HardSphereTest):
    def test_periodic_on_ranks(self):
        diameter, position, velocity, spin = cloud()
        edge = 0.03
        results = {}
        for ranks in RANKS:
            scene = Scene(Spheres(diameter, position, velocity, spin), (0.0, 0.0, 0.0), (edge,) * 3, e=0.9, et=0.3, mu=0.2,
                          boundary="p p p", processors="* * *", skin=0.001)  # fmt: skip
            done = self.run_scene(scene, STEP, STEPS, every=100, ranks=ranks)
            h = done.history()
            p0, e0, r0, size = sums(scene.spheres, h.velocity[0], h.spin[0])
            drift = max(numpy.linalg.norm(sums(scene.spheres, v, w)[0] - p0) for v, w in zip(h.velocity, h.spin)) / size
            _, e1, r1, _ = sums(scene.spheres, h.velocity[-1], h.spin[-1])
            # of each sphere, so that many small ones count and not the few that carry the energy
            results[ranks] = norm(h.velocity[-1])[:, 0], norm(h.spin[-1])[:, 0] * diameter
            print(f"{len(diameter)} spheres of {1e3 * diameter.min():.1f} to {1e3 * diameter.max():.1f} mm on {ranks} ranks: momentum "
                  f"{drift:.1e} of the sum of its sizes after {STEPS} steps; energy {e1 / e0:.4f} (translation), {r1 / r0:.4f} (rotation)")
            with self.subTest(ranks=ranks):
                # 1000 steps times some hundred impulses at 1e-16 each, of random sign
                measured.below(self, f"cloud of rough spinning spheres, sizes 1 to 10, {STEPS} steps, ranks: {ranks}: change of momentum", drift, 1e-13, "", "conservation")
                self.assertLess(e1 + r1, e0 + r0)
        for ranks in RANKS[1:]:
            for name, alone, parted in zip(("speed", "surface speed"), results[1], results[ranks]):
                error = numpy.sqrt((alone.var() + parted.var()) / len(diameter))
                apart = (parted.mean() - alone.mean()) / error
                print(f"mean {name} on {ranks} ranks: {parted.mean():.4f} m/s, on one {alone.mean():.4f} m/s: {apart:+.1f} standard errors")
                with self.subTest(statistics=ranks):
                    # chaos parts the runs after a few collisions; beyond 4 standard errors chance goes once in 16,000 times
                    self.assertLess(abs(apart), 4)


class FreePair(HardSphereTest):
    def test_angular_momentum(self):
        draw = numpy.random.default_rng(8)
        drifts = []
        for k in range(10):
            diameter = numpy.array([1e-2, 10 ** draw.uniform(-3, -2)])
            normal = draw.normal(size=3)
            normal /= numpy.linalg.norm(normal)
            velocity = draw.normal(size=(2, 3)) * 0.3
            velocity[1] -= 1.0 * normal
            # they touch after 3.3 steps
            position = numpy.array([[0.0, 0, 0], normal * diameter.mean()]) - 3.3 * STEP * velocity
            spheres = Spheres(diameter, position, velocity, 300 * draw.normal(size=(2, 3)), [1000.0, 2500.0])
            scene = Scene(spheres, (-0.1,) * 3, (0.1,) * 3, e=0.8, et=0.4, mu=0.3)
            h = self.run_scene(scene, STEP, 20).history()
            mass, inertia = spheres.mass[:, None], spheres.inertia[:, None]

            def total(t):
                return (numpy.cross(h.position[t], mass * h.velocity[t]) + inertia * h.spin[t]).sum(axis=0)

            size = (numpy.linalg.norm(h.position, axis=2).max(axis=0) * (mass * norm(h.velocity[0]))[:, 0]
                    + (inertia * norm(h.spin[0]))[:, 0]).sum()  # fmt: skip
            drift = numpy.linalg.norm(total(-1) - total(0)) / size
            linear = numpy.linalg.norm((mass * (h.velocity[-1] - h.velocity[0])).sum(axis=0)) / (mass * norm(h.velocity[0])).sum()
            self.assertGreater(abs(h.velocity[-1] - h.velocity[0]).max(), 0.01, "they have missed")
            drifts.append(drift)
            self.assertLess(linear, 1e-14)
        # round-off of positions and velocities, multiplied; the contact is where they touch within the step
        measured.below(self, "ten free pairs: change of angular momentum", max(drifts), 1e-13, "", "conservation")


def norm(vectors):
    return numpy.linalg.norm(vectors, axis=-1, keepdims=True)
