# SPDX-License-Identifier: GPL-3.0-or-later
"""LIGGGHTS's distributions of sizes reach the gas: what fix insert makes of one stands in the snapshots, the voidage and the books."""

import math
import os

import numpy

import boxes
import support

SIZE, CELLS, DENSITY = (0.06, 0.03, 0.24), (6, 3, 24), 2500.0
COUNT = 400


class InsertedSizes(support.ProgramTest):
    integrator = "fix move all nve/sphere\n"

    def inserted(self, templates, kind, names):
        """Diameters and places of COUNT particles that were inserted at once beside one of 1 mm."""
        more = "".join(f"fix {name} all particletemplate/sphere {prime} atom_type 1 density constant {DENSITY!r} {radius}\n"
                       for name, prime, radius in templates)
        more += f"fix sizes all particledistribution/discrete{kind} 32452843 {len(templates)} {names}\n"
        more += ("region above block 0.002 0.058 0.002 0.028 0.05 0.23 units box\n"
                 "fix pour all insert/pack seed 86028121 distributiontemplate sizes insert_every once "
                 f"overlapcheck yes all_in yes particles_in_region {COUNT} region above\n")
        scene = boxes.Box(SIZE, CELLS, [1e-3], DENSITY, [[0.03, 0.015, 0.02]], None, method="DEM", walls="", more=more,
                          integrator=self.integrator, particles="solidStep 1e-4;", gravity=9.81, fluid=(1.2, 1.8e-5),
                          step=1e-3, end=0.02)
        done = self.done = self.run_case(scene.write(os.path.join(self.root, f"case{kind.replace('/', '')}")))
        self.assert_books_close(done, ("momentum", "volume"))
        last = done.last()
        self.assertEqual(len(last["id"]), COUNT + 1)
        return last["diameter"][1:]

    def test_tabulated_by_number_and_by_mass(self):
        """Two sizes, half of the number or half of the mass each; LIGGGHTS fills in what its numbers leave by chance."""
        templates = [("small", 15485863, "radius constant 0.0005"), ("large", 15485867, "radius constant 0.001")]
        for kind, large in (("/numberbased", 0.5), ("/massbased", 1 / 9)):
            with self.subTest(kind):
                diameter = self.inserted(templates, kind, "small 0.5 large 0.5")
                numpy.testing.assert_allclose(numpy.unique(diameter.round(9)), [1e-3, 2e-3])
                # three times the standard deviation of a draw
                self.assertAlmostEqual((diameter > 1.5e-3).mean(), large, delta=3 * math.sqrt(large * (1 - large) / COUNT))

    def test_in_many_classes(self):
        """LIGGGHTS 3.8 knows templates of one radius only: a continuous distribution is a table of classes."""
        radii, shares = (3e-4, 4e-4, 5e-4, 6e-4, 8e-4), (0.1, 0.2, 0.4, 0.2, 0.1)
        templates = [(f"class{k}", prime, f"radius constant {r!r}") for k, (r, prime) in enumerate(
            zip(radii, (15485863, 15485867, 49979693, 32452867, 49979687)))]
        diameter = self.inserted(templates, "/numberbased", " ".join(f"class{k} {share}" for k, share in enumerate(shares)))
        for r, share in zip(radii, shares):
            found = numpy.isclose(diameter, 2 * r, rtol=1e-9).mean()
            self.assertAlmostEqual(found, share, delta=3 * math.sqrt(share * (1 - share) / COUNT))

    def test_without_an_integrator_they_are_told(self):
        """The integrator's group was made before they came: they hang in the air."""
        self.integrator = "group old id 1\nfix move old nve/sphere\n"
        self.inserted([("one", 15485863, "radius constant 0.0005")], "", "one 1.0")
        self.assertEqual(self.done.err.count(f"no fix of the script moves {COUNT} of the {COUNT + 1} particles"), 1, self.done.err)
        self.assertRegex(self.done.out, rf"particles that no fix moves +{COUNT} +99\.751 %")  # of 401
