# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
"""Parcels of MP-PIC in a bed that is one gas cell deep, periodic in that direction: nothing pushes them along it (cases/sscp1-slice)."""

import unittest

import numpy

import support


class OneCellDeep(support.ProgramTest):
    def test_parcels_stay_where_they_are_in_depth(self):
        """Round-off alone moves them, 1.6e-11 m in 30 s of the case; a stress that led them along it would do so by diameters."""
        for name, settings in (
            ("as it is", {}), ("parcels of 2", {"weight": 2}), ("parcels of 16", {"weight": 16}), ("deeper", {"depth": 0.03, "particleCount": 37400}),
            ("steps of 2 ms", {"system/controlDict:deltaT": 2e-3}), ("faster", {"inletVelocity": 4.38}),
        ):
            with self.subTest(name):
                folder = self.prepared("sscp1-slice", name.replace(" ", "-"), method="MPPIC", until=0.2, **{"weight": 8, **settings})
                snapshots = self.run_case(folder).run.snapshots
                first, last = snapshots[0].arrays(), snapshots[-1].arrays()
                numpy.testing.assert_array_equal(numpy.sort(first["id"]), numpy.sort(last["id"]))
                moved = numpy.abs(last["position"][numpy.argsort(last["id"])] - first["position"][numpy.argsort(first["id"])])
                depth = support.parameters(folder)["depth"]
                across = numpy.minimum(moved[:, 1], depth - moved[:, 1])  # as the image that is nearer
                self.assertLess(across.max(), 1e-9)
                self.assertGreater(moved[:, 2].max(), 0.01)


if __name__ == "__main__":
    unittest.main()
