# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""The templates of tools/new-plugin: momentum, walls, spheres that come, go and grow, on 1, 2 and 4 ranks alike."""

import numpy

from contact_scenes import FLOOR, GRAVITY, KEPT, PLAIN, ContactTest, scene, sphere, vectors

RANKS = (1, 2, 4)
BOTH = (PLAIN, KEPT)
SIDES = "".join(f"fix {axis}{k} all wall/{{plugin}} primitive type 1 {axis}plane {0.1 * k}\n" for axis in "xy" for k in (0, 1))


def packing(count, seed, low=0.004, high=0.096, speed=0.5):
    """Lines of `count` spheres of two materials and radii of 1 to 4 mm that do not touch."""
    draw = numpy.random.default_rng(seed)
    lines, placed = "", []
    while len(placed) < count:
        radius, x = draw.uniform(0.001, 0.004), draw.uniform(low, high, 3)
        if all(numpy.linalg.norm(x - y) > radius + r for y, r in placed):
            placed.append((x, radius))
            lines += sphere(len(placed), radius, x.tolist(), draw.uniform(-speed, speed, 3).tolist(), kind=1 + len(placed) % 2)
    return lines


def feed(radius, count, region):
    """Lines that insert spheres into a box. (On several ranks LIGGGHTS inserts nothing into a region as wide as a few of them.)"""
    return f"""
fix one all particletemplate/sphere 10007 atom_type 1 density constant 2000 radius constant {radius}
fix sizes all particledistribution/discrete 10009 1 one 1.0
region spot block {region} units box
fix feed all insert/pack seed 10037 distributiontemplate sizes insert_every once overlapcheck yes all_in yes particles_in_region {count} region spot
"""


class Conservation(ContactTest):
    def test_momentum_in_a_periodic_gas(self):
        """150 spheres, sizes 1:4, two materials, with friction: collisions take momentum from no pair."""
        for plugin in BOTH:
            for ranks in RANKS:
                with self.subTest(plugin=plugin, ranks=ranks):
                    states = self.states(plugin, scene(plugin, packing(150, 7), "run 4000\n", 4000, boundary="p p p"), ranks)
                    before, after = [(s["mass"][:, None] * vectors(s)) for s in (states[0], states[-1])]
                    self.assertGreater(numpy.abs(vectors(states[-1], "omega")).max(), 1, "they met")
                    # 1e5 additions to 150 velocities, each rounded by 1e-16 of its size
                    self.assertLess(numpy.abs((after - before).sum(axis=0)).max(), 1e-14 * numpy.abs(before).sum())


class Ranks(ContactTest):
    def test_alike_by_id(self):
        """Spheres of two materials between six walls: where each is after its collisions does not tell the number of ranks."""
        walls = "".join(f"fix {axis}{k} all wall/{{plugin}} primitive type {k + 1} {axis}plane {0.1 * k}\n" for axis in "xyz" for k in (0, 1))
        for plugin in BOTH:
            found = [self.states(plugin, scene(plugin, packing(100, 3), GRAVITY + walls + "run 3000\n", 3000), n)[-1] for n in RANKS]
            self.assertGreater(numpy.abs(vectors(found[0], "omega")).max(), 1)
            for other in found[1:]:
                numpy.testing.assert_array_equal(found[0]["id"], other["id"])
                # forces are summed up in another order; collisions enlarge the 1e-17 m that this makes
                numpy.testing.assert_allclose(vectors(other, "x"), vectors(found[0], "x"), rtol=0, atol=1e-12)
                numpy.testing.assert_allclose(vectors(other, "omega"), vectors(found[0], "omega"), rtol=0, atol=1e-7)

    def test_more_contacts_than_liggghts_has_room_for(self):
        """A large sphere flies to the next rank with a crust of 300: it packs 2,400 numbers, where LIGGGHTS spares 1,000."""
        golden = numpy.pi * (3 - 5**0.5)
        lines = sphere(1, 0.02, (0.04, 0.05, 0.05), (1, 0, 0))
        for k in range(300):
            z = 1 - (2 * k + 1) / 300
            around = numpy.array([(1 - z * z) ** 0.5 * numpy.cos(k * golden), (1 - z * z) ** 0.5 * numpy.sin(k * golden), z])
            lines += sphere(k + 2, 0.001, (numpy.array([0.04, 0.05, 0.05]) + 0.02099 * around).tolist(), (1, 0, 0))
        found = [self.states(KEPT, scene(KEPT, lines, "run 2000\n", 2000), ranks)[-1] for ranks in (1, 2)]
        self.assertGreater(found[0]["x"][0], 0.055)
        numpy.testing.assert_allclose(vectors(found[1], "x"), vectors(found[0], "x"), rtol=0, atol=1e-12)


class ComeGoAndGrow(ContactTest):
    def test_200_inserted_spheres_stay(self):
        """Into an empty box: none falls through the floor or another one."""
        after = GRAVITY + FLOOR + SIDES + feed(0.003, 200, "0.0 0.1 0.0 0.1 0.0 0.1") + "run 30000\n"
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                end = self.states(PLAIN, scene(PLAIN, "", after, 30000), ranks)[-1]
                self.assertEqual(len(end["id"]), 200)
                apart = numpy.linalg.norm(vectors(end, "x")[:, None] - vectors(end, "x")[None], axis=2)[numpy.triu_indices(200, 1)]
                self.assertGreater(apart.min(), 0.95 * 0.006, "they lie on each other")
                self.assertGreater(end["z"].min(), 0.95 * 0.003)

    def test_larger_ones_inserted_between_small_ones(self):
        """What is there at the start says nothing of them. The large one does not fall through the small ones."""
        lines = "".join(sphere(1 + 20 * i + j, 0.0025, (0.0025 + 0.005 * i, 0.0025 + 0.005 * j, 0.0025)) for i in range(20) for j in range(20))
        after = GRAVITY + FLOOR + SIDES + feed(0.01, 1, "0.0 0.1 0.0 0.1 0.03 0.1") + "run 15000\n"
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                states = self.states(PLAIN, scene(PLAIN, lines, after, 100), ranks)[1:]
                gaps = [numpy.linalg.norm(vectors(s, "x")[:-1] - vectors(s, "x")[-1], axis=1).min() for s in states]
                self.assertEqual(states[-1]["radius"][-1], 0.01)
                # it meets them at 1.2 m/s and less, where four springs give way by 1.8 mm
                self.assertGreater(min(gaps), 0.0125 - 0.003)
                self.assertLess(min(gaps), 0.0125)

    def test_growing_over_ranks(self):
        """Two spheres far apart grow until they touch, over the two ranks between them. No other one is as large at the start."""
        lines = sphere(1, 0.002, (0.02, 0.05, 0.05)) + sphere(2, 0.002, (0.08, 0.05, 0.05))
        after = "variable size equal 0.004+0.064*step/2000\nfix grow all adapt 1 atom diameter v_size\nrun 2000\n"
        found = {}
        for plugin in BOTH:
            for ranks in RANKS:
                end = self.states(plugin, scene(plugin, lines, after, 2000, skin=0.0005), ranks)[-1]
                self.assertLess(end["vx"][0], -0.01, "they push each other apart")
                found[ranks] = vectors(end, "x")
                momentum = end["mass"] * end["vx"]
                self.assertLess(abs(momentum.sum()), 1e-14 * abs(momentum).sum())
            for ranks in RANKS[1:]:
                numpy.testing.assert_allclose(found[ranks], found[1], rtol=0, atol=1e-15)

    def test_removed_in_the_middle_of_a_heap(self):
        """Where ids are given anew after it, or not, those that stay go on alike."""
        lines = "".join(sphere(k + 1, 0.004, (0.03 + 0.0079 * k, 0.05, 0.0039), kind=1 + k % 2) for k in range(6))
        slope = "fix gravity all gravity 9.81 vector 0.1 0.0 -1.0\nfix stop all wall/{plugin} primitive type 1 xplane 0.0739\n" + FLOOR
        for plugin in BOTH:
            for ranks in (1, 2):
                ends = []
                for compress in ("no", "yes"):
                    after = slope + f"run 5000\ngroup one id 1\ndelete_atoms group one compress {compress}\ngroup one delete\nrun 5000\n"
                    ends.append(self.states(plugin, scene(plugin, lines, after, 10000), ranks)[-1])
                self.assertEqual([sorted(end["id"]) for end in ends], [[2, 3, 4, 5, 6], [1, 2, 3, 4, 5]])
                by_place = [vectors(end, "x")[numpy.argsort(end["x"])] for end in ends]
                numpy.testing.assert_array_equal(*by_place)
