# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may include whom, checked on every source file.

Engine headers appear only under coupler/engines/<that engine>/, in the plug-ins, and in the one header that makes a plug-in of
LIGGGHTS's classes, FOR_PLUGINS, which nothing but LIGGGHTS's engine and the plug-ins include. Inside coupler/, includes point one way
along ORDER, whose last folder, the run, knows engines by its interfaces only; the engines come after it and do not know each other; the
main program chooses them. Plug-ins of this tree see of the coupler what is installed for those outside it, no more.
"""

import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ.get("INTERPHASE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
COUPLER = SOURCE / "coupler"

# A folder may include itself and the folders before it.
ORDER = ["base", "exchange", "mapping", "forces", "momentum", "settings", "plugin", "records", "step", "statistics", "run"]
ENGINES = ["openfoam", "liggghts"]
FOR_PLUGINS = "plugin/plugin.hpp"

# The folders of plugins/ that plug-ins share: all but the last are none themselves, and that is what laws stand on.
SHARED = ("script", "walls", "contacts", "hard_sphere")

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
    elif folder is not None:
        return [f"coupler/{path}: folder '{folder}' has no place in ORDER of {pathlib.Path(__file__).name}; give it one"]

    for quoted, header in includes_in(text):
        # Ours are written from coupler/ on; a name without a folder is an engine's, a system's, or a mistake.
        if quoted and (COUPLER / header).exists():
            target = folder_of(header)
            if header == FOR_PLUGINS and folder != "engines/liggghts":
                found.append(f'coupler/{path}: includes "{header}", which brings LIGGGHTS; only engines/liggghts may')
                continue
            if allowed is not None and target not in allowed:
                found.append(f'coupler/{path}: includes "{header}", but {folder} may include only '
                             + ", ".join(sorted(allowed)))
            continue
        engine = engine_of_header(header)
        if engine and folder != f"engines/{engine}" and not (engine == "liggghts" and path == FOR_PLUGINS):
            found.append(f"coupler/{path}: includes {engine}'s header {header}; those belong under "
                         f"coupler/engines/{engine}/")
        elif quoted and not engine:
            found.append(f'coupler/{path}: includes "{header}", which is no file below coupler/')
    return found


def installed_headers(name="_headers"):
    """What cmake/Package.cmake lays out for plug-ins, from coupler/ on; `_shared_headers`: from plugins/ on."""
    package = (SOURCE / "cmake" / "Package.cmake").read_text()
    return set(re.search(rf"set\({name} ([^)]*)\)", package).group(1).split())


def violations_of_plugin(path, text, installed):
    """The same of a file of plugins/ (path relative to it)."""
    own = pathlib.PurePosixPath(path).parts[0]
    found = []
    for quoted, header in includes_in(text):
        if header in installed:
            continue
        folder = header.split("/")[0]
        if engine_of_header(header) == "openfoam":
            found.append(f"plugins/{path}: includes OpenFOAM's header {header}")
        elif (SOURCE / "plugins" / header).exists() and "/" in header:
            if folder not in (own, *SHARED):
                found.append(f'plugins/{path}: includes "{header}" of another plug-in')
        elif (COUPLER / header).exists() or folder in ORDER + ["engines", "interphase"]:
            found.append(f'plugins/{path}: includes "{header}", which plug-ins outside this tree do not have; they have '
                         + ", ".join(sorted(installed)))
        elif quoted and not engine_of_header(header):
            found.append(f'plugins/{path}: includes "{header}", which is neither its own nor LIGGGHTS\'s')
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

    def test_finds_an_engine_in_the_run(self):
        header = "engines/openfoam/foam_case.hpp"
        self.assertTrue((COUPLER / header).exists())
        self.assertTrue(violations("run/x.cpp", f'#include "{header}"'))
        self.assertTrue(violations("step/x.cpp", '#include "run/gas_case.hpp"'))
        self.assertFalse(violations("engines/openfoam/x.cpp", '#include "run/gas_case.hpp"'))
        self.assertFalse(violations("interphase.cpp", f'#include "{header}"'))

    def test_finds_what_brings_liggghts_in_the_middle(self):
        for path in ("step/x.hpp", "run/x.cpp", "plugin/solid_stress.hpp", "engines/openfoam/x.cpp", "interphase.cpp"):
            self.assertTrue(violations(path, f'#include "{FOR_PLUGINS}"'), path)
        self.assertFalse(violations("engines/liggghts/x.cpp", f'#include "{FOR_PLUGINS}"'))
        self.assertTrue(violations("plugin/solid_stress.hpp", '#include "fix.h"'))
        self.assertFalse(violations(FOR_PLUGINS, '#include "fix.h"'))
        self.assertFalse(violations("step/x.hpp", '#include "plugin/solid_stress.hpp"'))

    def test_finds_a_privilege_of_a_plug_in(self):
        installed = installed_headers()
        self.assertIn(FOR_PLUGINS, installed)
        for text in ('"step/gas.hpp"', '"base/communicator.hpp"', '<engines/liggghts/liggghts_solids.hpp>', '"mp_pic/stress_law.hpp"',
                     '"fvCFD.H"', '"nowhere.hpp"'):  # fmt: skip
            self.assertTrue(violations_of_plugin("hard_sphere/x.cpp", f"#include {text}", installed), text)
        for text in (f'"{FOR_PLUGINS}"', '"base/vector.hpp"', '"walls/wall.hpp"', '"hard_sphere/sweep.hpp"', '"fix.h"', "<Eigen/Core>",
                     "<vector>"):  # fmt: skip
            self.assertFalse(violations_of_plugin("hard_sphere/x.cpp", f"#include {text}", installed), text)

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

    def test_of_plugins_are_what_those_outside_this_tree_have(self):
        installed, plugins = installed_headers(), SOURCE / "plugins"
        found = [message for file in sources(plugins)
                 for message in violations_of_plugin(file.relative_to(plugins).as_posix(), file.read_text(), installed)]  # fmt: skip
        self.assertFalse(found, "\n" + "\n".join(found))

    def test_of_installed_headers_are_installed(self):
        installed = installed_headers()
        missing = [f"{header}: {other}" for header in installed for quoted, other in includes_in((COUPLER / header).read_text())
                   if quoted and (COUPLER / other).exists() and other not in installed]
        shared, plugins = installed_headers("_shared_headers"), SOURCE / "plugins"
        missing += [f"{header}: {other}" for header in shared for quoted, other in includes_in((plugins / header).read_text())
                    if quoted and not engine_of_header(other) and other not in installed | shared]
        self.assertFalse(missing)
