# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""A coupled run with a plug-in that remembers its contacts, stopped and taken further, is the run that was not stopped, to the last bit."""

import os

import support
from resumed_run import ResumedRun

from contact_scenes import KEPT, PLAIN, PLUGINS


class Resumed(ResumedRun, support.ProgramTest):
    stop, end = 0.02, 0.04

    def check_contacts(self, plugin, ranks):
        self.check_plugin(f'"{os.path.join(PLUGINS, f"lib{plugin}.so")}"',
                          {"wall/tdhs": f"wall/{plugin}", "fix move   all tdhs": f"fix push all {plugin}/spheres\nfix move all nve/sphere"}, ranks)  # fmt: skip

    def test_with_memory(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.check_contacts(KEPT, ranks)

    def test_without(self):
        self.check_contacts(PLAIN, 2)
