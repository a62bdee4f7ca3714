# SPDX-License-Identifier: GPL-3.0-or-later
"""The entries of system/couplingDict that the program knows, from the page that it prints by `interphase -help keys`."""

import functools
import os
import re

from interphase import program_page

PAGE = os.path.join("coupler", "settings", "KEYS.md")


@functools.lru_cache(maxsize=None)
def of_coupling():
    """Their paths in the order of the page, nested by `/`: method, drag/law, ...; InputError where the page cannot be read."""
    return paths(program_page.text(PAGE, "keys"))


def paths(page):
    """The paths of the keys on a page of `interphase -help keys`, a tuple."""
    found, above = [], ""
    for line in page.splitlines():
        if section := re.match(r"## (\S+) \{", line):
            above = section[1].replace(".", "/") + "/"
        elif key := re.match(r"- `([^`]+)`", line):
            found.append(above + key[1])
    return tuple(found)
