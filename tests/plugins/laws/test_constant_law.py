# SPDX-License-Identifier: GPL-3.0-or-later
"""The built-in law, written as a plug-in's, gives the same numbers to the last bit, whether the solver takes 8, 4 or 1 contacts at once."""

import os

import numpy

from hard_spheres import HardSphereTest, Scene, Spheres


class ConstantLaw(HardSphereTest):
    def history(self, law, plugin, lanes):
        draw = numpy.random.default_rng(4)
        places = numpy.stack([k.ravel() for k in numpy.mgrid[0:6, 0:6, 0:6]], axis=1) * 0.0125 + 0.0115
        spheres = Spheres(draw.uniform(0.008, 0.012, 216), places, draw.normal(0, 0.3, (216, 3)), draw.normal(0, 20, (216, 3)))
        walls = tuple(f"primitive type 2 {axis}plane {at}" for axis in "xyz" for at in (0, 0.09))
        scene = Scene(spheres, (-0.01,) * 3, (0.11,) * 3, walls=walls, before="fix weight all gravity 9.81 vector 0 0 -1\n", e=0.8, et=0.3, mu=0.3,
                      law=law, plugin=os.path.join(*plugin))  # fmt: skip
        before = os.environ.get("INTERPHASE_LANES")
        self.addCleanup(lambda: os.environ.pop("INTERPHASE_LANES", None) if before is None else os.environ.update(INTERPHASE_LANES=before))
        os.environ["INTERPHASE_LANES"] = str(lanes)
        return self.run_scene(scene, 3e-4, 800, every=100).history()

    def test_to_the_last_bit(self):
        for lanes in (8, 4, 1):
            built_in = self.history("", ("plugins", "libhard_sphere.so"), lanes)
            as_plugin = self.history("constant_law", ("tests", "plugins", "libconstant_law.so"), lanes)
            self.assertTrue((built_in.position == as_plugin.position).all() and (built_in.spin == as_plugin.spin).all(), f"{lanes} lanes")
            self.assertGreater(abs(built_in.position[-1] - built_in.position[0]).max(), 0.01)
