# SPDX-License-Identifier: GPL-3.0-or-later
"""One impact, of a sphere on a wall and of two spheres, is the three-parameter solution of rigid bodies, to round-off.

The solution is written here once more, from the balance of momentum (Foerster, Louge, Chang and Allia, Phys. Fluids 6 (1994)
1108): the contact parts with -e_n times its normal velocity, and with -e_t times its tangential one unless Coulomb's mu times
the normal impulse is too little for it. The sphere on a wall is the one of cases/oblique-impact, which compares with measurements.
"""

import os
import re
import subprocess

import measured
import numpy

from hard_spheres import SOURCE, HardSphereTest, Scene, Spheres

# A few hundred operations in double precision, and positions of 1 m that a touch time within a step of 1e-5 m comes from.
ROUND_OFF = 1e-10


def norm(vectors):
    return numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def dot(a, b):
    return (a * b).sum(axis=-1, keepdims=True)


def impulse_on_second(normal, meeting, spins, mass, e_n, e_t, mu):
    """For [n] solid spheres. `normal`: from the first to the second [n, 3]; `meeting`: velocity of the second less that of the
    first; `spins`: sum of radius times spin; `mass`: m1 m2/(m1 + m2) [n, 1], a wall's being infinite."""
    contact = meeting - numpy.cross(spins, normal)
    approach = -dot(contact, normal)
    slip = contact + approach * normal
    pressing = (1 + e_n) * mass * approach
    # a tangential impulse P changes the slip by P (1/m_e + r1^2/I1 + r2^2/I2) = 7/2 P/m_e
    sticking = (1 + e_t) * norm(slip) * 2 / 7 * mass
    direction = slip / numpy.maximum(norm(slip), 1e-300)
    return pressing * normal - numpy.minimum(sticking, mu * pressing) * direction


class SphereOnWall(HardSphereTest):
    def check(self, e_n, e_t, mu, spin):
        angle = numpy.radians(numpy.arange(2.0, 60.5, 2.0))
        n, radius, speed, density = len(angle), 2.5e-3, 3.9, 4000.0
        position = numpy.column_stack([0.05 * numpy.arange(1, n + 1), numpy.full(n, 0.1), radius + 0.01 * numpy.linspace(0.3, 1, n)])
        velocity = speed * numpy.column_stack([numpy.sin(angle), numpy.zeros(n), -numpy.cos(angle)])
        spins = numpy.broadcast_to(numpy.asarray(spin, float), (n, 3))
        scene = Scene(Spheres(2 * radius, position, velocity, spins, density), (0, 0, -0.01), (0.05 * n + 1, 0.2, 0.2),
                      e=e_n, et=e_t, mu=mu, walls=("primitive type 2 zplane 0.0",))  # fmt: skip
        step, steps = 1e-4, 100
        h = self.run_scene(scene, step, steps, every=steps).history()

        mass = scene.spheres.mass[:, None]
        up = numpy.array([0, 0, 1.0])
        impulse = impulse_on_second(up, velocity, radius * spins, mass, e_n, e_t, mu)
        expected = velocity + impulse / mass
        expected_spin = spins - radius * numpy.cross(up, impulse) / scene.spheres.inertia[:, None]
        touch = ((position[:, 2] - radius) / -velocity[:, 2])[:, None]
        end = position + touch * velocity + (step * steps - touch) * expected

        def relative(a, b):
            return (norm(a - b) / norm(b).clip(max(1e-3 * norm(b).max(), 1e-300))).max()

        errors = {
            "rebound angle": relative(numpy.arctan2(h.velocity[-1, :, :1], h.velocity[-1, :, 2:]),
                                      numpy.arctan2(expected[:, :1], expected[:, 2:])),
            "tangential restitution": relative(h.velocity[-1, :, :1] / velocity[:, :1], expected[:, :1] / velocity[:, :1]),
            "spin": relative(h.spin[-1], expected_spin),
            "velocity": relative(h.velocity[-1], expected),
            "position": norm(h.position[-1] - end).max() / 0.1,
        }  # fmt: skip
        print(f"e_n {e_n}, e_t {e_t}, mu {mu}, spin {spin}: " + ", ".join(f"{name} {error:.1e}" for name, error in errors.items()))
        return errors

    def test_as_measured(self):
        """With the parameters of cases/oblique-impact, and what its `draw` finds beside the measurements. A contact that sticks has one ratio of
        tangential velocities here, a real one is a spring besides: the distances are what no e_t takes away."""
        for name, error in self.check(0.98, 0.26, 0.092, (0, 0, 0)).items():
            measured.below(self, f"impact on a wall at 2 to 60 degrees: error of the {name}", error, ROUND_OFF, "", "Foerster et al., Phys. Fluids 6 (1994) 1108")
        done = subprocess.run([os.path.join(SOURCE, "cases/oblique-impact/draw"), "--out", os.path.join(self.folder(), "picture.png")], capture_output=True,
                              text=True, timeout=120)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        found = re.search(r"rebound angle (\S+) deg, tangential restitution (\S+), spin (\S+) rad/s", done.stdout).groups()
        for name, value, limit, unit in zip(("rebound angle, to 57 deg", "ratio of tangential velocities, to 0.90", "spin, to 613 rad/s"), found, (0.7, 0.08, 36),
                                            ("deg", "", "rad/s")):  # fmt: skip
            measured.below(self, f"aluminium oxide on glass, {name}: root mean square distance from the measurements", float(value), limit, unit,
                           "Kharaz, Gorham and Salman, Powder Technol. 120 (2001) 281")

    def test_other_laws_and_spins(self):
        for e_n, e_t, mu in ((1, 1, 10), (0, 0, 10), (0.5, 0, 0.3), (0.9, 1, 0.05), (0.7, 0.4, 0)):
            for spin in ((0, 0, 0), (0, 500, 0), (300, -200, 100)):
                with self.subTest(e_n=e_n, e_t=e_t, mu=mu, spin=spin):
                    for name, error in self.check(e_n, e_t, mu, spin).items():
                        self.assertLess(error, ROUND_OFF, name)


class SphereOnSphere(HardSphereTest):
    def test_pairs_of_any_size_and_spin(self):
        """Each pair flies alone and meets at a random point of both; four pairs of materials in turn."""
        draw = numpy.random.default_rng(5)
        n = 200
        laws = numpy.array([(0.98, 0.26, 0.092), (1, 1, 10), (0, 0, 0.2), (0.7, 0.5, 0.4)])
        diameter = draw.uniform(2e-3, 2e-2, (n, 2))
        normal = draw.normal(size=(n, 3))
        normal /= norm(normal)
        meeting = draw.normal(size=(n, 3))
        meeting *= -numpy.sign(dot(meeting, normal))  # approaching
        touch = draw.uniform(1e-4, 9e-4, (n, 1))  # not in the first step: what meets then is seen at its end
        place = 0.1 * numpy.stack([k.ravel() for k in numpy.mgrid[1:9, 1:6, 1:6]], axis=1).astype(float)
        first_velocity = draw.normal(size=(n, 3))
        velocity = numpy.stack([first_velocity, first_velocity + meeting], axis=1)  # [n, 2, 3]
        at_touch = numpy.stack([place, place + diameter.mean(axis=1, keepdims=True) * normal], axis=1)
        position = at_touch - touch[:, None] * velocity
        spin = draw.normal(size=(n, 2, 3)) * 200
        density = draw.uniform(500, 4000, (n, 2))
        kind = numpy.tile(numpy.arange(4), n)[:n]

        # material 2k + 1 meets 2k + 2
        types = 8
        e, et, mu = (numpy.full((types, types), 0.123) for _ in range(3))
        for k, values in enumerate(laws):
            for matrix, value in zip((e, et, mu), values):
                matrix[2 * k, 2 * k + 1] = matrix[2 * k + 1, 2 * k] = value
        spheres = Spheres(diameter.ravel(), position.reshape(-1, 3), velocity.reshape(-1, 3), spin.reshape(-1, 3), density.ravel(),
                          numpy.stack([2 * kind + 1, 2 * kind + 2], axis=1).ravel())  # fmt: skip
        step, steps = 1e-4, 10
        h = self.run_scene(Scene(spheres, (0, 0, 0), (1, 1, 1), e, et, mu, types), step, steps, every=steps).history()

        mass, inertia = spheres.mass.reshape(n, 2, 1), spheres.inertia.reshape(n, 2, 1)
        e_n, e_t, friction = (column[:, None] for column in laws[kind].T)
        radius = diameter[:, :, None] / 2
        impulse = impulse_on_second(normal, meeting, (radius * spin).sum(axis=1), mass.prod(axis=1) / mass.sum(axis=1),
                                    e_n, e_t, friction)  # fmt: skip
        signs = numpy.array([-1.0, 1.0])[None, :, None]
        expected = velocity + signs * impulse[:, None] / mass
        expected_spin = spin - radius * numpy.cross(normal, impulse)[:, None] / inertia
        end = at_touch + (step * steps - touch)[:, None] * expected
        errors = {
            "velocity": (norm(h.velocity[-1].reshape(n, 2, 3) - expected) / norm(expected)).max(),
            "spin": (norm(h.spin[-1].reshape(n, 2, 3) - expected_spin) / norm(expected_spin)).max(),
            "position": norm(h.position[-1].reshape(n, 2, 3) - end).max() / 1e-3,
        }
        print(f"{n} pairs: " + ", ".join(f"{name} {error:.1e}" for name, error in errors.items()))
        changed = norm(h.velocity[-1].reshape(n, 2, 3) - velocity).min()
        self.assertGreater(changed, 0, "a pair has missed")
        for name, error in errors.items():
            measured.below(self, f"{n} pairs of spheres of any size, spin and law: error of the {name}", error, ROUND_OFF, "", "Foerster et al., Phys. Fluids 6 (1994) 1108")

    def test_pairs_that_pass_by_do_not_feel_each_other(self):
        """Gaps of 1e-4 to 1e-1 of the radius on passing: a contact that is expected and does not come about gives nothing."""
        draw = numpy.random.default_rng(6)
        n, radius = 100, 5e-3
        place = 0.1 * numpy.stack([k.ravel() for k in numpy.mgrid[1:5, 1:6, 1:6]], axis=1).astype(float)
        beside = draw.normal(size=(n, 3))
        beside /= norm(beside)
        along = numpy.cross(beside, draw.normal(size=(n, 3)))
        along /= norm(along)
        other = place + 2 * radius * (1 + 10 ** draw.uniform(-4, -1, (n, 1)) / 2) * beside - draw.uniform(4e-4, 7e-4, (n, 1)) * along
        position = numpy.stack([place, other], axis=1)
        velocity = numpy.stack([numpy.zeros((n, 3)), along], axis=1)
        scene = Scene(Spheres(2 * radius, position.reshape(-1, 3), velocity.reshape(-1, 3)), (0, 0, 0), (1, 1, 1), 0.9, 0.3, 0.3)
        h = self.run_scene(scene, 3e-4, 6, every=6).history()
        change = norm(h.velocity[-1].reshape(n, 2, 3) - velocity).max()
        print(f"{n} pairs that pass by: the velocity changes by up to {change:.1e} of the relative one")
        self.assertLess(change, ROUND_OFF)
