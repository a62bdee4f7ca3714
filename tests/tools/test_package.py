# SPDX-License-Identifier: GPL-3.0-or-later
"""python/interphase is found in one way: by every tool from any folder, by `prepare` through tools/run, installed by pip; and a Python
without the modules that it needs is told which, and how to get them."""

import os
import re
import shutil
import subprocess
import sys

from interphase import commands, launch
from interphase.tree import REPOSITORY
from scratch import InFolder

PACKAGE = os.path.join(REPOSITORY, "python", "interphase")


def modules():
    """Names of the files of the package, its commands apart."""
    return {file[:-3] for file in os.listdir(PACKAGE) if file.endswith(".py")}


def programs_in_python():
    """(path from the tree on, text) of every file in Python of tools/, cases/ and tests/."""
    for top in ("tools", "cases", "tests"):
        for folder, _, files in os.walk(os.path.join(REPOSITORY, top)):
            for file in files:
                path = os.path.join(folder, file)
                with open(path, "rb") as stream:
                    text = stream.read()
                if file.endswith(".py") or text.startswith(b"#!/usr/bin/python3"):
                    yield os.path.relpath(path, REPOSITORY), text.decode("utf-8")


class Bench(InFolder):
    def setUp(self):
        super().setUp()
        # No PYTHONPATH: what is called must find the package by itself.
        self.environment = {name: text for name, text in os.environ.items() if name != "PYTHONPATH"}

    def execute(self, *command, **changes):
        return subprocess.run(
            command, cwd=self.root, env={**self.environment, **changes}, stdin=subprocess.DEVNULL, capture_output=True, text=True,
            timeout=120,
        )


class OneWay(Bench):
    def test_no_program_edits_the_search_path_of_python(self):
        edit = re.compile(r"^\s*sys\.path\b(?!_)", re.M)
        self.assertTrue(edit.search("    sys.path.insert(0, TOOLS)"))
        self.assertEqual([path for path, text in programs_in_python() if edit.search(text)], [])

    def test_no_module_is_named_as_one_of_python_itself(self):
        self.assertEqual(modules() & set(sys.stdlib_module_names) - {"__init__", "__main__"}, set())

    def test_every_command_is_a_tool(self):
        self.assertIn("gas-study", commands.names())
        for name in commands.names():
            with self.subTest(name):
                done = self.execute(os.path.join(REPOSITORY, "tools", name), "--help")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(f"{name} [-h]", done.stdout)

    def test_files_of_the_folder_where_one_stands_are_left_alone(self):
        for name in ("statistics.py", "numpy.py", "interphase.py"):
            with open(os.path.join(self.root, name), "w", encoding="utf-8") as stream:
                stream.write("raise SystemExit('taken from the current folder')\n")
        done = self.execute(os.path.join(REPOSITORY, "tools", "compare"), "nothing", "nowhere")
        self.assertIn("nothing", done.stderr)
        self.assertNotIn("taken from", done.stderr)

    def test_by_a_link_of_another_name(self):
        os.symlink(os.path.join(REPOSITORY, "tools", "bed"), os.path.join(self.root, "make-bed"))
        done = self.execute(os.path.join(self.root, "make-bed"), "--help")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_command_that_there_is_not(self):
        done = self.execute(os.path.join(REPOSITORY, "python", "tool"), "compares")
        self.assertEqual(done.returncode, 2)
        self.assertIn("'compares' is none of the commands: bed, bench, compare", done.stderr)


class MissingModules(Bench):
    """A Python without h5py, numpy and the rest: -S leaves Debian's folder of modules out."""

    def setUp(self):
        super().setUp()
        self.python = os.path.join(self.root, "bare")
        with open(self.python, "w", encoding="utf-8") as stream:
            stream.write('#!/bin/sh\nexec /usr/bin/python3 -S "$@"\n')
        os.chmod(self.python, 0o755)

    def tool(self, name, *words):
        return self.execute(os.path.join(REPOSITORY, "tools", name), *words, INTERPHASE_PYTHON=self.python)

    def test_are_named_with_how_to_get_them(self):
        """All of them at once, whichever a command meets first."""
        wanted = (r"/usr/bin/python3\S* has no modules numpy, scipy, h5py, matplotlib\. On Debian: apt-get install python3-numpy python3-scipy "
                  "python3-h5py python3-matplotlib ")  # fmt: skip
        for name in ("compare", "report", "picture", "validate", "envelope"):
            with self.subTest(name):
                done = self.tool(name, "a")
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, rf"^{name}: {wanted}")
                self.assertNotIn("Traceback", done.stderr)

    def test_of_a_script_and_of_prepare(self):
        """A program that tools/run starts is helped with the same words."""
        script = os.path.join(self.root, "look.py")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write("import interphase, os\nos.mkdir('run')\nopen('run/results.h5', 'w')\ninterphase.Run('run').series\n")
        done = self.execute(self.python, script, PYTHONPATH=os.path.join(REPOSITORY, "python"))
        self.assertRegex(done.stderr, r"ModuleNotFoundError: \S+ has no modules numpy, .*On Debian: apt-get install python3-numpy ")
        program = os.path.join(self.root, "prepare")
        with open(program, "w", encoding="utf-8") as stream:
            stream.write("#!/usr/bin/python3 -S\nimport numpy.linalg\n")
        os.chmod(program, 0o755)
        with self.assertRaisesRegex(launch.StepFailed, "prepare failed(.*\n)*On Debian: apt-get install python3-numpy"):
            launch.step([program], os.path.join(self.root, "log.prepare"), dict(os.environ), self.root)

    def test_are_not_wanted_to_start_a_run(self):
        """tools/run installs them; a bed of one size needs none."""
        self.assertEqual(self.tool("run", "--help").returncode, 0)
        self.assertIn("no such folder", self.tool("run", "nowhere").stderr)
        done = self.tool("bed", "--count", "10", "--diameter", "1e-3", "--density", "2500", "--box", "0", ".01", "0", ".01", "0", ".01",
                         "--fill", "0.005", "--out", "bed.data")  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)


class Installed(Bench):
    """By pip, from a copy: setuptools writes beside what it builds."""

    def test_a_script_elsewhere_finds_the_package(self):
        source, target = os.path.join(self.root, "python"), os.path.join(self.root, "site")
        shutil.copytree(os.path.join(REPOSITORY, "python"), source, ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
        installed = self.execute("/usr/bin/python3", "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation", "--no-deps",
                                 "--target", target, source)  # fmt: skip
        if "No module named pip" in installed.stderr:
            self.skipTest("pip is not installed (tools/setup --with-tests does)")
        self.assertEqual(installed.returncode, 0, installed.stderr)
        done = self.execute("/usr/bin/python3", "-m", "interphase", "bed", "--help", PYTHONPATH=target)
        self.assertEqual(done.returncode, 0, done.stderr)
        tree = ("/usr/bin/python3", "-c", "from interphase import tree; print(tree.CASES)")
        self.assertIn("set INTERPHASE_SOURCE to the folder of the tree", self.execute(*tree, PYTHONPATH=target, INTERPHASE_SOURCE="").stderr)
        done = self.execute(*tree, PYTHONPATH=target, INTERPHASE_SOURCE=REPOSITORY)
        self.assertEqual(done.stdout.strip(), os.path.join(REPOSITORY, "cases"), done.stderr)

    def test_says_the_version_that_is_built(self):
        with open(os.path.join(REPOSITORY, "CMakeLists.txt"), encoding="utf-8") as stream:
            built = re.search(r"^    VERSION (\S+)$", stream.read(), re.M)[1]
        with open(os.path.join(REPOSITORY, "python", "pyproject.toml"), encoding="utf-8") as stream:
            self.assertIn(f'\nversion = "{built}"\n', stream.read())
