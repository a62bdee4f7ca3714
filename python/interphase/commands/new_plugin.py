# SPDX-License-Identifier: GPL-3.0-or-later
"""Start a plug-in: a project of its own, outside this tree, that builds, tests and runs as it is."""

import argparse
import os
import re

from interphase import exits, methods
from interphase.input_error import InputError
from interphase.tree import REPOSITORY, TOOLS

TEMPLATE = os.path.join(TOOLS, "templates", "plugin")
# Files in place of those of TEMPLATE, or beside them.
WITH_MEMORY = os.path.join(TOOLS, "templates", "plugin_with_memory")
LAW = os.path.join(TOOLS, "templates", "plugin_law")
STRESS = os.path.join(TOOLS, "templates", "plugin_stress")

# What the kinds put into the files that they share.
CONTACTS = {"CASE_TOP": "0.02", "CASE_END": "0.1",
            "CASE_MATERIALS": "fix             k all property/global kn peratomtypepair 1 800.0\n"
            "fix             mu all property/global coefficientFriction peratomtypepair 1 0.3"}  # fmt: skip
FORCE_VALUES = {**CONTACTS, "SOURCE": "fix_@NAME@.cpp", "LIBRARY": "contacts", "WALL": "wall/@NAME@",
                "COLLIDES": "fix             push all @NAME@/spheres\nfix             move all nve/sphere"}  # fmt: skip
LAW_VALUES = {**CONTACTS, "SOURCE": "@NAME@.cpp", "LIBRARY": "hard_sphere", "WALL": "wall/tdhs/@NAME@",
              "COLLIDES": "fix             yields all property/global yieldSpeed peratomtypepair 1 0.5\nfix             move all tdhs/@NAME@"}  # fmt: skip
STRESS_VALUES = {"SOURCE": "@NAME@.cpp", "LIBRARY": "mp_pic", "WALL": "wall/mp_pic/@NAME@", "CASE_TOP": "0.1", "CASE_END": "0.3",
                 "CASE_MATERIALS": "fix             slide all property/global tangentialRestitution peratomtypepair 1 1.0",
                 "COLLIDES": "fix             move all mp_pic/@NAME@ stress @NAME@ 0.05 2 5 0.5 close_packing 0.65"}  # fmt: skip
# Files of TEMPLATE that a law or a stress has no use for.
OF_FORCES = ("fix_@NAME@.cpp", "test/test_collisions.py")
OF_CONTACTS = (*OF_FORCES, "test/scenes.py", "example/in.liggghts")

STRESSES = ("harris_crighton", "lun", "off")  # words that fix mp_pic knows behind `stress`

# CMake keeps these names of targets for itself.
TAKEN = ("all", "clean", "edit_cache", "help", "install", "package", "rebuild_cache", "test")

EXAMPLE = """example:
  tools/new-plugin bouncy ~/bouncy
  cd ~/bouncy && cmake -B build -S . && cmake --build build && ctest --test-dir build

DIR then holds the source of a small collision style, its test, a script for LIGGGHTS alone, a case with gas, and a
README.md with all commands. With --with-memory its contacts remember: a spring along the surfaces holds what friction
can hold. With --law it is a law for the hard-sphere solver, e_n and friction as functions of a contact, with a plot of
it. With --stress it is a stress of the solids for MP-PIC, a function of the solid fraction, with a plot of it.
plugins/README.md tells what a plug-in may do.

exit code: 0 when it is written, 2 where the name or the folder is refused."""


def arguments():
    parser = argparse.ArgumentParser(
        prog="tools/new-plugin", description=__doc__, epilog=EXAMPLE, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("name", metavar="NAME", help="of the plug-in: lower-case letters, digits and '_'")
    parser.add_argument("folder", metavar="DIR", nargs="?", help="where to write it (default: ./NAME)")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--law", action="store_true", help="a law of impacts for hard spheres instead of a force")
    kind.add_argument("--stress", action="store_true", help="a stress of the solids for MP-PIC instead of a force")
    kind.add_argument("--with-memory", action="store_true", help="a law whose contacts keep a state of their own while they last")
    return parser.parse_args()


def checked_name(name, stress):
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name):
        raise InputError(f"the name '{name}' will not do: give lower-case letters, digits and '_', a letter first, "
                      "since the library, the class and the style are called after it")  # fmt: skip
    if name in TAKEN:
        raise InputError(f"the name '{name}' is one that CMake keeps for itself: give another one, such as my_{name}")
    if stress and name in STRESSES:
        raise InputError(f"the name '{name}' will not do: fix mp_pic knows `stress {name}` already; give another one, such as my_{name}")
    if name in methods.plugins_of_tree():
        raise InputError(f"the name '{name}' will not do: interphase has a plug-in of that name; give another one, such as my_{name}")
    if not stress and name.upper() in methods.of_tree():
        raise InputError(f"the name '{name}' will not do: the plug-in's method would be {name.upper()}, which there is already; give another one")
    return name


def checked_folder(given):
    folder = os.path.realpath(given)
    if os.path.commonpath([folder, REPOSITORY]) == REPOSITORY:
        raise InputError(f"{given} is inside the tree of interphase ({REPOSITORY}): give a folder elsewhere as DIR. "
                      "Plug-ins that belong to interphase are described in plugins/README.md")  # fmt: skip
    unfit = re.search(r"[\s\"';{}$\\]", folder)
    if unfit:
        raise InputError(f"'{folder}': OpenFOAM bears no '{unfit[0]}' in a path; give another folder as DIR")
    if os.path.lexists(given) and not os.path.isdir(folder):
        raise InputError(f"{given} is a file: give a folder as DIR")
    if os.path.isdir(folder) and os.listdir(folder):
        raise InputError(f"{given} is not empty, and what is there stays: give an empty or a new folder as DIR")
    return folder


def write(template, folder, values, without=()):
    """A template with @KEY@ replaced, in names and in texts; values may hold keys that come after them. `without` these files of it."""

    def filled(text):
        for key, value in values.items():
            text = text.replace(f"@{key}@", value)
        return text

    for base, folders, files in os.walk(template):
        folders[:] = [name for name in folders if name != "__pycache__"]
        target = os.path.join(folder, os.path.relpath(base, template))
        for file in files:
            if os.path.relpath(os.path.join(base, file), template) in without:
                continue
            os.makedirs(target, exist_ok=True)
            with open(os.path.join(base, file), encoding="utf-8") as stream:
                text = stream.read()
            with open(os.path.join(target, filled(file)), "w", encoding="utf-8") as stream:
                stream.write(filled(text))


def main():
    given = arguments()
    name = checked_name(given.name, given.stress)
    folder = checked_folder(given.folder or name)
    build = os.path.join(REPOSITORY, "build", "release")
    kind, own, without = FORCE_VALUES, WITH_MEMORY if given.with_memory else None, ()
    if given.law:
        kind, own, without = LAW_VALUES, LAW, OF_FORCES
    if given.stress:
        kind, own, without = STRESS_VALUES, STRESS, OF_CONTACTS
    try:
        values = {**kind, "NAME": name, "METHOD": name.upper(), "CLASS": "".join(part.capitalize() for part in name.split("_")),
                  "INTERPHASE_BUILD": build, "INTERPHASE_TOOLS": TOOLS}  # fmt: skip
        write(TEMPLATE, folder, values, without)
        if own:
            write(own, folder, values)
    except OSError as error:
        raise InputError(f"{folder} cannot be written: {error}") from None
    print(f"{name} is in {folder}. Next:\n")
    if not os.path.exists(os.path.join(build, "interphaseConfig.cmake")):
        print(f"  {os.path.join(TOOLS, 'setup')}      (builds interphase)")
    print(f"  cd {folder}\n  cmake -B build -S . && cmake --build build && ctest --test-dir build\n"
          f"  {os.path.join(TOOLS, 'run')} case\n\nREADME.md there tells the rest.")  # fmt: skip
    return 0


if __name__ == "__main__":
    exits.after(main, "tools/new-plugin", "plug-in's folder")
