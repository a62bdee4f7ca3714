#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may include whom, checked on every source file.

Engine headers appear only under coupler/engines/<that engine>/ and in the plugins. Inside coupler/, includes point
one way along ORDER, the list of the coupling step; the engines come after it and do not know each other; run/ and
the main program put it all together, and nothing includes them.
"""

import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ.get("INTERPHASE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
COUPLER = SOURCE / "coupler"

# A folder may include itself and the folders before it.
ORDER = ["base", "exchange", "mapping", "forces", "momentum", "settings", "records", "step"]
ENGINES = ["openfoam", "liggghts"]
WHOLE = "run"

# LIGGGHTS's headers have plain names (atom.h, fix.h): all that LIGGGHTS installs are known by this folder's listing,
# the ones the coupler would use by name where LIGGGHTS is installed elsewhere.
LIGGGHTS_FOLDER = pathlib.Path("/usr/include/liggghts")
LIGGGHTS_NAMES = {"lammps.h", "library.h", "atom.h", "atom_vec.h", "comm.h", "domain.h", "error.h", "fix.h", "force.h",
                  "group.h", "input.h", "memory.h", "modify.h", "neighbor.h", "pair.h", "update.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def liggghts_headers():
    return LIGGGHTS_NAMES | {file.name for file in LIGGGHTS_FOLDER.glob("*.h")}


def includes_in(text):
    """Pairs (quoted with "", path) of a source text, comments left aside."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r"//[^\n]*", "", text)
    return [(quote == '"', path) for quote, path in INCLUDE.findall(text)]


def engine_of_header(path):
    """The engine that a header belongs to, or None."""
    name = path.rsplit("/", 1)[-1]
    if name.endswith(".H"):
        return "openfoam"
    if path.startswith(("lammps/", "liggghts/")) or path in liggghts_headers():
        return "liggghts"
    return None


def folder_of(path):
    """Name used by the rules for a path relative to coupler/: "mapping", "engines/openfoam", or None for main."""
    parts = pathlib.PurePosixPath(path).parts
    if len(parts) == 1:
        return None
    return "/".join(parts[:2]) if parts[0] == "engines" else parts[0]


def violations(path, text):
    """What a file of coupler/ (path relative to it) includes against the rules, as messages."""
    found = []
    folder = folder_of(path)
    allowed = None
    if folder in ORDER:
        allowed = set(ORDER[:ORDER.index(folder) + 1])
    elif folder in [f"engines/{engine}" for engine in ENGINES]:
        allowed = set(ORDER) | {folder}
    elif folder == WHOLE:
        allowed = None
    elif folder is not None:
        return [f"coupler/{path}: folder '{folder}' has no place in ORDER of {pathlib.Path(__file__).name}; give it one"]

    for quoted, header in includes_in(text):
        # Ours are written from coupler/ on; a name without a folder is an engine's, a system's, or a mistake.
        if quoted and (COUPLER / header).exists():
            target = folder_of(header)
            if allowed is not None and target not in allowed:
                found.append(f'coupler/{path}: includes "{header}", but {folder} may include only '
                             + ", ".join(sorted(allowed)))
            continue
        engine = engine_of_header(header)
        if engine and folder != f"engines/{engine}":
            found.append(f"coupler/{path}: includes {engine}'s header {header}; those belong under "
                         f"coupler/engines/{engine}/")
        elif quoted and not engine:
            found.append(f'coupler/{path}: includes "{header}", which is no file below coupler/')
    return found


def sources(folder):
    return sorted(file for pattern in ("*.cpp", "*.hpp", "*.h", "*.H", "*.C") for file in folder.rglob(pattern))


class TheCheckItself(unittest.TestCase):
    """A check that cannot fail proves nothing."""

    def test_finds_an_engine_header_in_the_middle(self):
        self.assertTrue(violations("mapping/x.cpp", '#include "fvCFD.H"'))
        self.assertTrue(violations("step/x.cpp", "#include <lammps.h>"))
        self.assertTrue(violations("interphase.cpp", "#  include <argList.H>"))

    def test_finds_an_engine_header_under_the_other_engine(self):
        self.assertTrue(violations("engines/liggghts/x.cpp", '#include "fvMesh.H"'))
        self.assertTrue(violations("engines/openfoam/x.cpp", '#include "modify.h"'))
        self.assertFalse(violations("engines/openfoam/x.cpp", '#include "fvMesh.H"'))
        self.assertFalse(violations("engines/liggghts/x.cpp", "#include <modify.h>"))

    def test_finds_an_include_against_the_order(self):
        header = next(file.relative_to(COUPLER).as_posix() for file in sources(COUPLER / "exchange"))
        self.assertTrue(violations("base/x.hpp", f'#include "{header}"'))
        self.assertFalse(violations("mapping/x.hpp", f'#include "{header}"'))
        self.assertFalse(violations("interphase.cpp", f'#include "{header}"'))

    def test_finds_an_include_of_what_puts_it_together(self):
        header = next(file.relative_to(COUPLER).as_posix() for file in sources(COUPLER / WHOLE) if file.suffix == ".hpp")
        self.assertTrue(violations("step/x.cpp", f'#include "{header}"'))
        self.assertTrue(violations("engines/openfoam/x.cpp", f'#include "{header}"'))
        self.assertFalse(violations("run/x.cpp", f'#include "{header}"'))

    def test_finds_an_unknown_folder_and_an_unknown_header(self):
        self.assertTrue(violations("surprise/x.cpp", ""))
        self.assertTrue(violations("base/x.cpp", '#include "vector.hpp"'))

    def test_ignores_comments_and_standard_headers(self):
        self.assertFalse(violations("base/x.cpp", '// #include "fvCFD.H"\n/*\n#include <lammps.h>\n*/\n#include <vector>'))


class Includes(unittest.TestCase):
    def test_point_one_way(self):
        found = []
        for file in sources(COUPLER):
            found += violations(file.relative_to(COUPLER).as_posix(), file.read_text())
        self.assertFalse(found, "\n" + "\n".join(found))

    def test_of_plugins_name_no_gas_engine(self):
        found = [f"{file.relative_to(SOURCE)}: includes {header}"
                 for file in sources(SOURCE / "plugins")
                 for _, header in includes_in(file.read_text()) if engine_of_header(header) == "openfoam"]
        self.assertFalse(found, "\n" + "\n".join(found))


if __name__ == "__main__":
    unittest.main()
