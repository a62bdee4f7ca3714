# SPDX-License-Identifier: GPL-3.0-or-later
# label: slow
# processors: 2
# timeout: 7200
"""A run that is stopped and goes on from its last checkpoint is the run that was not stopped, to the last bit: all methods, for 1,000 gas steps."""

import support
from resumed_run import ResumedMethods


class Resume(ResumedMethods, support.ProgramTest):
    stop, end = 0.02, 1.02
