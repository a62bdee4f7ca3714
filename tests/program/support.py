# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases prepared in folders of their own, and the program run on them."""

import os
import re
import shutil
import signal
import subprocess
import tempfile
import unittest

import h5py

from interphase import foam_file, launch, parameters as scene_numbers, series
from interphase.run import Run

SOURCE = os.environ.get("INTERPHASE_SOURCE") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
BUILD = os.environ.get("INTERPHASE_BUILD") or os.path.join(SOURCE, "build", "release")
PROGRAM = os.path.join(BUILD, "interphase")
TOOLS = os.path.join(SOURCE, "tools")

# A program with sanitizers takes signals itself, and wants to be the first library.
unless_sanitized = unittest.skipIf("INTERPHASE_SANITIZED" in os.environ, "signals and preloaded libraries are the sanitizer's")

# Ranks that wait for one another for ever are ended here [s]; most runs take seconds.
LONGEST = 300


def environment(**changes):
    """The user's, with what Open MPI and OpenFOAM want, and the program that is tested, so that no tool builds one over it while others run; None removes a
    variable."""
    variables = {**os.environ, **launch.additions(os.environ), "INTERPHASE_BIN": PROGRAM, **changes}
    return {name: value for name, value in variables.items() if value is not None}


class Finished:
    """How a program ended: exit code, what it printed, and the folder it worked in."""

    def __init__(self, folder, code=0, out="", err=""):
        self.folder = folder
        self.code = code
        self.out = out
        self.err = err

    @property
    def text(self):
        return self.out + self.err

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    @property
    def run(self):
        return Run(self.folder)

    @property
    def meta(self):
        return self.run.meta

    def results(self):
        """The file itself, where that is what is looked at: `table` leaves out what is torn."""
        return h5py.File(self.path("results.h5"), "r")

    def table(self, group):
        """{name: values [n]} of a table of results.h5, `time` [s] among them."""
        found = series.Table(self.path("results.h5"), group)
        return {name: found[name].values for name in ("time", *found)}

    def column(self, path):
        """[n] of `group/name`."""
        group, _, name = path.partition("/")
        return series.Table(self.path("results.h5"), group)[name].values

    def snapshots(self):
        """Per time a dict of arrays, rows sorted by id: {time: {"position": [n, 3], ...}}."""
        return {each.time: each.arrays() for each in self.run.snapshots}

    def last(self):
        """The arrays of the last snapshot."""
        return self.run.snapshots[-1].arrays()


def execute(folder, ranks=1, timeout=LONGEST, options=("-overwrite",), **changes):
    """The program on a prepared case, in place of an earlier run or with other words on its command line. `changes` of the environment."""
    program = start(folder, ranks, list(options), **changes)
    try:
        out, err = program.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        program.terminate()  # mpirun passes it on, which it could not with a kill
        try:
            out, err = program.communicate(timeout=20)
        except subprocess.TimeoutExpired:
            os.killpg(program.pid, signal.SIGKILL)
            out, err = program.communicate()
        raise AssertionError(f"interphase on {ranks} ranks had no end after {timeout:g} s:\n{(out + err)[-4000:]}") from None
    return Finished(folder, program.returncode, out, err)


def execute_from(here, folder, ranks=1):
    """The program started in the folder `here` on a case that may not be there, in place of an earlier run."""
    command = [*launch.command(PROGRAM, folder, ranks), "-overwrite"]
    done = subprocess.run(
        command, cwd=here, env=environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60
    )
    return Finished(folder, done.returncode, done.stdout, done.stderr)


def start(folder, ranks=1, options=(), **changes):
    """The same as execute(), running, with more options of the program: a Popen in a session of its own."""
    return subprocess.Popen(
        [*launch.command(PROGRAM, folder, ranks), *options], cwd=folder, env=environment(**changes), stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace", start_new_session=True,
    )


def must(folder, *command):
    """What a program said that is run in `folder` and must end well."""
    done = subprocess.run(command, cwd=folder, env=environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=LONGEST)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)} failed:\n{(done.stdout + done.stderr)[-4000:]}")
    return done.stdout


def tool(name, *words, timeout=LONGEST, program=PROGRAM, **changes):
    """tools/`name`, or a program of a case by its path, with the interphase that was built: a CompletedProcess."""
    return subprocess.run(
        [os.path.join(TOOLS, name), *map(str, words)], env=environment(INTERPHASE_BIN=program, **changes), stdin=subprocess.DEVNULL,
        capture_output=True, text=True, timeout=timeout,
    )


def settings_of(entries):
    """The words of tools/run that set `entries` {name: value}; `until` is the end time."""
    return [word for name, value in entries.items() for word in (("--until", str(value)) if name == "until" else ("--set", f"{name}={value}"))]


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read(*parts):
    with open(os.path.join(*parts), encoding="utf-8", errors="replace") as file:
        return file.read()


def parameters(folder):
    """The numbers of a case's `parameters`, and its words as they are."""
    return {name: scene_numbers.numbers(value) for name, value in scene_numbers.read(os.path.join(folder, "parameters")).items()}


def fill_disk(folder, free=0):
    """A file that leaves `free` bytes of the disk, about; returns its path."""
    path = os.path.join(folder, "filler")
    with open(path, "wb", buffering=0) as filler:
        try:
            while True:
                filler.write(bytes(4096))
        except OSError:
            filler.truncate(max(0, filler.tell() - free))
    return path


class ProgramTest(unittest.TestCase):
    """Every test has a folder of its own, gone when it ends."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls._class_folder = tempfile.TemporaryDirectory(prefix="interphase-")
        cls.addClassCleanup(cls._class_folder.cleanup)
        cls.shared = cls._class_folder.name

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="interphase-")
        self.addCleanup(folder.cleanup)
        self.root = folder.name

    def small_disk(self, size):
        """A folder that is a disk of its own, which mount(8) gives to root only."""
        folder = os.path.join(self.root, f"disk{len(os.listdir(self.root))}")
        os.makedirs(folder)
        mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder]
        if os.geteuid() != 0 or subprocess.run(mount, capture_output=True).returncode != 0:
            self.skipTest("no right to mount a small disk")
        self.addCleanup(subprocess.run, ["umount", "-l", folder], check=True)
        return folder

    @staticmethod
    def prepare(case, folder, ranks=1, **settings):
        """A case of cases/ (or a folder) made ready in `folder` by tools/run, with a program that does nothing.

        `settings`: entries of `parameters`; `until` is the end time, other files' entries as {"FILE:ENTRY": value}.
        """
        return ProgramTest.ran(case, folder, ranks, program="true", **settings)

    @staticmethod
    def ran(case, folder, ranks=1, program=PROGRAM, **settings):
        """The same, with the program itself unless told otherwise; it must reach its end."""
        path = case if os.path.isabs(case) else os.path.join(SOURCE, "cases", case)
        done = tool("run", path, "--ranks", ranks, "--out", folder, "--no-picture", "--quiet", *settings_of(settings), program=program)
        if done.returncode != 0:
            raise AssertionError(f"{' '.join(done.args)} failed:\n{done.stdout}{done.stderr}")
        return folder

    def prepared(self, case, name="case", ranks=1, **settings):
        return self.prepare(case, os.path.join(self.root, name), ranks, **settings)

    def copied(self, folder, name="copy"):
        target = os.path.join(self.root, name)
        shutil.copytree(folder, target, symlinks=True)
        return target

    def run_case(self, folder, ranks=1, timeout=LONGEST, options=(), **changes):
        """Runs a prepared case and demands that it reaches its end."""
        done = execute(folder, ranks, timeout, options, **changes)
        self.assertEqual(done.code, 0, f"interphase on {ranks} ranks ended with {done.code}:\n{done.text[-4000:]}")
        return done

    def assert_books_close(self, done, accounts=("momentum", "volume", "gas_volume"), within=1e-12):
        """The residuals of the balances in /ledger are round-off, by default that of sums over some thousand particles and cells."""
        for account in accounts:
            self.assertLess(abs(done.column(f"ledger/{account}_residual")).max(), within, account)

    @staticmethod
    def edit(folder, file, pattern, replacement, count=1):
        """Replaces `pattern` (a regular expression) in a file of the case; it must be there."""
        path = os.path.join(folder, file)
        text, found = re.subn(pattern, lambda _: replacement, read(path), count=count, flags=re.M)
        if not found:
            raise AssertionError(f"{pattern} is not in {path}")
        write(path, text)

    @staticmethod
    def set_entry(folder, file, entry, value):
        """Replaces an entry of an OpenFOAM dictionary, nested by '/'."""
        path = os.path.join(folder, file)
        write(path, foam_file.replaced(read(path), entry, str(value)))
