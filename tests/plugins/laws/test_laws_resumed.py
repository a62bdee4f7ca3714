# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""A coupled run whose contacts remember couples against rolling, and stick together, stopped and taken further, is the run that was not stopped,
to the last bit."""

import os

import support
from resumed_run import ResumedRun

LAW = "cohesive_rolling"
NUMBERS = """\
fix roll all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1
fix stick all property/global workOfAdhesion peratomtypepair 2 0.02 0.02 0.02 0.02
fix reach all property/global cohesionRange peratomtypepair 2 1e-4 1e-4 1e-4 1e-4
"""


class Resumed(ResumedRun, support.ProgramTest):
    stop, end = 0.02, 0.04

    def test_resumed(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                case = self.bed("PLUGIN")
                text = support.read(os.path.join(case, "dem/hard_spheres.liggghts"))
                for of_tdhs, ours in (("wall/tdhs", f"wall/tdhs/{LAW}"), ("fix move   all tdhs", f"{NUMBERS}fix move all tdhs/{LAW}")):
                    self.assertIn(of_tdhs, text)
                    text = text.replace(of_tdhs, ours)
                support.write(os.path.join(case, "dem/PLUGIN.liggghts"), text)
                self.edit(case, "system/couplingDict", r"^plugins .*$", "plugins (laws);")
                self.compare(*self.copies(case, "PLUGIN", ranks), ranks)
