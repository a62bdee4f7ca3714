# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 1500
"""What the pages for users tell to do, done: in a copy of the tree, in the order of the page, over shorter times. tests/tools/test_pages.py looks
that commands and files on all pages exist."""

import glob
import os
import re
import shutil
import subprocess

import support
from pages import ELSEWHERE, put, shortened, steps

PLAYED = ("README.md", "tools/README.md", "cases/OWN_BED.md")
SHARE = 0.02  # of a page's simulated times
GAS_STEPS_OF_CASES = 3


class Reader(support.ProgramTest):
    def setUp(self):
        super().setUp()
        self.tree, self.home = os.path.join(self.root, "tree"), os.path.join(self.root, "home")
        os.mkdir(self.home)
        for room in ("cases", "python", "tools"):
            shutil.copytree(os.path.join(support.SOURCE, room), os.path.join(self.tree, room), ignore=shutil.ignore_patterns("__pycache__"))
        for page in ("README.md", "coupler/settings/KEYS.md", "coupler/settings/METHODS.md"):
            os.makedirs(os.path.dirname(os.path.join(self.tree, page)), exist_ok=True)
            shutil.copy(os.path.join(support.SOURCE, page), os.path.join(self.tree, page))
        os.makedirs(os.path.join(self.tree, "build"))
        os.symlink(support.BUILD, os.path.join(self.tree, "build/release"))

    def do(self, command):
        done = subprocess.run(
            ["bash", "-c", command], cwd=self.tree, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=400,
            env=support.environment(HOME=self.home, OMPI_MCA_rmaps_base_oversubscribe="1", CMAKE_PREFIX_PATH=support.BUILD),
        )  # fmt: skip
        return done


class Pages(Reader):
    def test_pages_are_done_as_they_say(self):
        for page in PLAYED:
            played = 0
            for how, file, words in steps(support.read(support.SOURCE, page)):
                if how != "run":
                    put(self.home, how, file, words)
                    continue
                for line in words.splitlines():
                    if re.match(ELSEWHERE, line):
                        continue
                    command = shortened(line, SHARE)
                    done = self.do(command)
                    played += 1
                    # 3: statistics of runs so short cannot be judged; 8: ended by its wall limit, as asked
                    allowed = {"tools/compare": (0, 1, 3), "tools/run": (0, 8) if "--wall-limit" in line else (0,)}.get(line.split()[0], (0,))
                    self.assertIn(done.returncode, allowed, f"{page}: {command}\n{done.stdout[-2000:]}\n{done.stderr[-3000:]}")
            self.assertGreater(played, 0, page)

    def test_python_of_the_first_page(self):
        script = re.search(r"```py\n(import interphase.*?)```", support.read(support.SOURCE, "README.md"), re.S)[1]
        script = script.replace("until=5", "until=0.2").replace("after=3", "after=0.05").replace("time=0.5", "time=0.1")
        done = self.do(f"PYTHONPATH=python /usr/bin/python3 - <<'END'\n{script}\nEND\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"Pa")


class Cases(Reader):
    def test_commands_of_the_cases_pages(self):
        """Each `tools/run cases/...` of a case's page starts, and gets through some gas steps."""
        played = 0
        for page in sorted(glob.glob(os.path.join(support.SOURCE, "cases/*/README.md"))):
            text = re.sub(r"\\\n\s*", " ", support.read(page))
            for line in dict.fromkeys(re.findall(r"^    (tools/run cases/[^#\n]*?) *(?:#.*)?$", text, re.M)):
                case = re.search(r"cases/[\w-]+", line)[0]
                step = re.search(r"gasStep=([\d.e-]+)", line) or re.search(r"^gasStep +([\d.e-]+);", support.read(support.SOURCE, case, "parameters"), re.M)
                until = GAS_STEPS_OF_CASES * float(step[1] if step else 1e-3)
                command = f"{re.sub(r' --(until|out) [^ ]+', '', line)} --until {until:g} --no-picture --overwrite --out {self.root}/run"
                with self.subTest(command=line):
                    done = self.do(command)
                    played += 1
                    self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
        self.assertGreater(played, 25)
