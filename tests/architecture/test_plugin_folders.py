# SPDX-License-Identifier: GPL-3.0-or-later
"""A plug-in gets into the tree only with a README and a test: plugins/CMakeLists.txt, configured in a project of its own, with a
library of nothing for interphase_add_plugin.
"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("INTERPHASE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(check LANGUAGES CXX)
add_custom_target(programs)
add_library(interphase_options INTERFACE)
function(interphase_add_plugin name)
    add_library(${name} MODULE plugin.cpp)
endfunction()
add_subdirectory(plugins)
"""


class PluginFolders(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="interphase-")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("CMakeLists.txt", PROJECT)
        self.write("plugins/README.md", "")
        shutil.copy(SOURCE / "plugins" / "CMakeLists.txt", self.root / "plugins")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def whole_plugin(self, test="test_physics.py"):
        self.write("plugins/springy/CMakeLists.txt", "interphase_add_plugin(springy SOURCES plugin.cpp)\n")
        self.write("plugins/springy/plugin.cpp", "")
        self.write("plugins/springy/README.md", "# springy\n")
        self.write(f"tests/plugins/springy/{test}", "")

    def configure(self):
        done = subprocess.run(["cmake", "-S", self.root, "-B", self.root / "build"], capture_output=True, text=True, timeout=60)
        return done.returncode, " ".join((done.stdout + done.stderr).split())

    def refused(self, *expected):
        code, words = self.configure()
        self.assertNotEqual(code, 0, words)
        for text in expected:
            self.assertIn(text, words)

    def test_none(self):
        self.assertEqual(self.configure()[0], 0)

    def test_a_whole_one(self):
        for test in ("test_physics.py", "impulse_test.cpp"):
            with self.subTest(test):
                self.whole_plugin(test)
                self.assertEqual(self.configure()[0], 0)
                shutil.rmtree(self.root / "tests")

    def test_without_readme(self):
        self.whole_plugin()
        (self.root / "plugins/springy/README.md").unlink()
        self.refused("plugins/springy has no README.md")

    def test_without_test(self):
        self.whole_plugin("notes.md")
        self.refused("plugins/springy has no test", "tests/plugins/springy")

    def test_without_build_file(self):
        self.whole_plugin()
        (self.root / "plugins/springy/CMakeLists.txt").unlink()
        self.refused("plugins/springy has no CMakeLists.txt")

    def test_with_a_library_of_another_name(self):
        self.whole_plugin()
        self.write("plugins/springy/CMakeLists.txt", "interphase_add_plugin(spring SOURCES plugin.cpp)\n")
        self.refused("makes no plug-in of the folder's name", "interphase_add_plugin(springy SOURCES ...)")
