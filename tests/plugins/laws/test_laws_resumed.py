# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 1200
"""Coupled runs whose contacts remember couples against rolling and stick together, or have a state of their own, stopped and taken further, are
the runs that were not stopped, to the last bit."""

import os

import support
from resumed_run import ResumedRun

from law_scenes import AGING

# Of each law: the plug-in, and what its script says beside that of tdhs.
LAWS = {
    "cohesive_rolling": ("laws", """\
fix roll all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1
fix stick all property/global workOfAdhesion peratomtypepair 2 0.02 0.02 0.02 0.02
fix reach all property/global cohesionRange peratomtypepair 2 1e-4 1e-4 1e-4 1e-4
"""),
    "aging": (f'"{AGING}"', "fix ages all property/global frictionGrowth peratomtypepair 2 10 10 10 10\n"),
}  # fmt: skip


class Resumed(ResumedRun, support.ProgramTest):
    stop, end = 0.02, 0.04

    def check_law(self, law, ranks):
        plugin, numbers = LAWS[law]
        self.check_plugin(plugin, {"wall/tdhs": f"wall/tdhs/{law}", "fix move   all tdhs": f"{numbers}fix move all tdhs/{law}"}, ranks)

    def test_couples_and_cohesion(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.check_law("cohesive_rolling", ranks)

    def test_state_of_contacts(self):
        self.check_law("aging", 2)
