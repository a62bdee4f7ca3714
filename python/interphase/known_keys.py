# SPDX-License-Identifier: GPL-3.0-or-later
"""The entries of system/couplingDict that the program knows, from the page that it prints by `interphase -help keys`."""

import functools
import os
import re

from interphase.input_error import InputError

PAGE = os.path.join("coupler", "settings", "KEYS.md")


@functools.lru_cache(maxsize=None)
def of_coupling():
    """Their paths in the order of the page, nested by `/`: method, drag/law, ...; InputError where the page cannot be read."""
    from interphase.tree import REPOSITORY
    try:
        with open(os.path.join(REPOSITORY, PAGE), encoding="utf-8") as stream:
            return paths(stream.read())
    except OSError as error:
        raise InputError(f"{PAGE}: cannot be read: {error.strerror}; `interphase -help keys > {PAGE}` writes it") from None


def paths(page):
    """The paths of the keys on a page of `interphase -help keys`, a tuple."""
    found, above = [], ""
    for line in page.splitlines():
        if section := re.match(r"## (\S+) \{", line):
            above = section[1].replace(".", "/") + "/"
        elif key := re.match(r"- `([^`]+)`", line):
            found.append(above + key[1])
    return tuple(found)
