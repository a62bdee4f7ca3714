# SPDX-License-Identifier: GPL-3.0-or-later
"""The collision methods: what the program says of them by `interphase -help methods`.

Those of LIGGGHTS and of this tree's plug-ins stand on a page in the tree, so that nothing has to be built to know them; for one that is not there the
program is asked for the methods of the plug-ins that a case names.
"""

import functools
import os
import re
import subprocess
from dataclasses import dataclass

from interphase import program_page
from interphase.foam_file import nearest
from interphase.input_error import InputError

PAGE = os.path.join("coupler", "settings", "METHODS.md")
ANY_PLUGIN = "any plug-in"


@dataclass(frozen=True)
class Method:
    """A row of the page."""

    name: str
    plugin: str  # that brings it; "" where it is LIGGGHTS's own
    collisions_of_plugin: bool  # by a fix of a plug-in, whichever that is
    of_particles: bool  # every particle is tracked: W = 1
    with_parcels: str  # of such a one: the method to take for parcels; "" where there is none
    contacts: str  # resolved (over many steps), single (in a step), none (particles do not meet one by one)


def rows(page):
    """The methods on a page of `interphase -help methods`, {name: Method} in its order."""
    found = {}
    for line in page.splitlines():
        if not line.startswith("| `"):
            continue
        name, of, tracks, with_parcels, contacts = (re.sub("`", "", cell).strip() for cell in line.split("|")[1:6])
        plugin = of if of not in ("LIGGGHTS", ANY_PLUGIN) else ""
        found[name] = Method(name, plugin, of != "LIGGGHTS", tracks == "particles", with_parcels, contacts)
    return found


@functools.lru_cache(maxsize=None)
def of_tree():
    """{name: Method} of LIGGGHTS and of this tree's plug-ins."""
    return rows(program_page.text(PAGE, "methods"))


def plugins_of_tree():
    """The names of this tree's plug-ins that bring a method."""
    return {each.plugin for each in of_tree().values() if each.plugin}


@functools.lru_cache(maxsize=None)
def of_plugins(plugins, folder):
    """{name: Method} of LIGGGHTS and of `plugins` (names and paths, a tuple), paths from `folder` on, as the program tells. InputError, with its words, where one
    cannot be had."""
    from interphase import launch  # which wants the tree

    told = ""
    for program in dict.fromkeys((launch.program("interphase"), os.path.join(launch.build_folder(), "interphase"))):
        if not os.access(program, os.X_OK):
            continue
        done = subprocess.run([program, "-help", "methods", *plugins], cwd=folder, env={**os.environ, **launch.additions(os.environ)},
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)  # fmt: skip
        if found := rows(done.stdout):  # INTERPHASE_BIN may be what only prepares a case: true
            return found
        told = done.stderr.strip() or told
    raise InputError(f"the methods of the plug-ins {', '.join(plugins)} are not known" + (f":\n{told}" if told else ""))


def all_with(plugins=(), folder="."):
    """{name: Method} of this tree and of `plugins`, see of_plugins(), where these are others."""
    others = tuple(each for each in plugins if each not in plugins_of_tree())
    return {**of_tree(), **of_plugins(others, folder)} if others else of_tree()


def method(name, plugins=(), folder="."):
    """The Method that a user calls `name` (`dem`, `mp-pic`), one of this tree or of `plugins`, see all_with(). InputError for one that there is not."""
    known = _found(name, of_tree())
    if known is None:
        there = all_with(plugins, folder)
        known = _found(name, there)
        if known is None:
            raise InputError(f"method '{name}' is unknown: {nearest(name.upper(), list(there))}; a plug-in that brings one has to stand in the case's `plugins`")
    return known


def _found(name, methods):
    def plain(text):
        return text.upper().replace("-", "").replace("_", "")

    return next((method for method in methods.values() if plain(method.name) == plain(name)), None)
