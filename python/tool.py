# SPDX-License-Identifier: GPL-3.0-or-later
"""tool.py COMMAND [ARGUMENT ...]: a command of the package beside this file, or a script (a path that ends in .py) that uses it.

Python looks for modules in this folder first; a script's own folder comes before."""

from interphase.commands import main

main()
