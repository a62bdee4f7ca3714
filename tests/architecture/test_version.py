# SPDX-License-Identifier: GPL-3.0-or-later
"""What a build records of its source (cmake/RecordVersion.cmake): the commit and whether files are changed, in a checkout; that
it does not know, elsewhere; and nothing is written where nothing has changed, so that nothing is compiled for it."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("INTERPHASE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))


class RecordVersion(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="interphase-")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.tree = self.root / "tree"
        self.tree.mkdir()
        self.output = self.root / "version.cpp"

    def git(self, *arguments):
        done = subprocess.run(
            ["git", "-c", "user.name=test", "-c", "user.email=test@localhost", *arguments], cwd=self.tree, check=True, capture_output=True,
            text=True, env={"PATH": os.environ["PATH"], "HOME": str(self.root)},
        )  # fmt: skip
        return done.stdout.strip()

    def recorded(self, tree=None):
        """Commit and uncommitted changes."""
        definitions = dict(TEMPLATE=SOURCE / "cmake/version.cpp.in", OUTPUT=self.output, SOURCE=tree or self.tree, VERSION="1.2.3",
                           COMPILER="GNU 12", FLAGS=" -O3 ", BUILD_TYPE="Release")  # fmt: skip
        subprocess.run(
            ["cmake", *[f"-D{name}={value}" for name, value in definitions.items()], "-P", SOURCE / "cmake/RecordVersion.cmake"],
            check=True, capture_output=True, timeout=60,
        )  # fmt: skip
        texts = re.findall(r'R"\((.*?)\)"', self.output.read_text())
        self.assertEqual((texts[0], *texts[3:]), ("1.2.3", "GNU 12", "-O3", "Release"))
        return tuple(texts[1:3])

    @unittest.skipUnless(shutil.which("git"), "git is not installed")
    def test_of_a_checkout(self):
        self.git("init", "--quiet")
        (self.tree / "file").write_text("one\n")
        self.git("add", "file")
        self.git("commit", "--quiet", "--message", "one")
        first = self.git("rev-parse", "HEAD")
        self.assertEqual(self.recorded(), (first, "no"))
        (self.tree / "build.log").write_text("a file that git does not know\n")
        self.assertEqual(self.recorded(), (first, "no"))
        (self.tree / "file").write_text("two\n")
        self.assertEqual(self.recorded(), (first, "yes"))
        self.git("commit", "--quiet", "--all", "--message", "two")
        second = self.git("rev-parse", "HEAD")
        self.assertNotEqual(first, second)
        self.assertEqual(self.recorded(), (second, "no"))

        os.utime(self.output, (1, 1))
        self.recorded()
        self.assertEqual(self.output.stat().st_mtime, 1, "written though nothing has changed")

        # an archive unpacked inside of somebody's repository is not that repository
        inner = self.tree / "unpacked"
        inner.mkdir()
        self.assertEqual(self.recorded(inner), ("unknown", "unknown"))

    def test_of_a_tree_without_git(self):
        self.assertEqual(self.recorded(), ("unknown", "unknown"))


class Citation(unittest.TestCase):
    def test_cites_the_version_that_is_built(self):
        built = re.search(r"^    VERSION (\S+)$", (SOURCE / "CMakeLists.txt").read_text(), re.M).group(1)
        cited = re.search(r"^version: (\S+)$", (SOURCE / "CITATION.cff").read_text(), re.M).group(1)
        self.assertEqual(cited, built)
        self.assertIn(f"\n## {built}\n", (SOURCE / "CHANGELOG.md").read_text())
