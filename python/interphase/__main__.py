# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 -m interphase COMMAND [ARGUMENT ...]: the same as tools/COMMAND."""

from interphase.commands import main

main()
