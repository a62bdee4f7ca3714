# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/run started from Python."""

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import time

from interphase import run_state
from interphase.input_error import InputError
from interphase.launch import StepFailed
from interphase.tree import TOOLS

REFUSED = 2  # exit code of tools/run for a command line or a case
PREFIX = "tools/run: error: "


class Launched:
    """A run that tools/run makes in `folder`, of the words of its command line.

    It has a session of its own: Ctrl-C is passed on, so that the run ends after the gas step in progress.
    """

    def __init__(self, words, folder, quiet):
        self.folder = folder
        self._errors = tempfile.TemporaryFile()
        environment = {"INTERPHASE_PYTHON": sys.executable, **os.environ}
        self._child = subprocess.Popen(
            [os.path.join(TOOLS, "run"), *words, "--out", folder, *(["--quiet"] if quiet else [])], stdin=subprocess.DEVNULL,
            stderr=self._errors, env=environment, start_new_session=True,
        )

    def accepted(self):
        """Returns when the run has its folder, or has ended; errors as of `wait`."""
        while self._child.poll() is None:
            found = run_state.record(self.folder)
            if found.get("process", {}).get("pid") == self._child.pid:
                return
            time.sleep(0.02)
        self.wait()

    def stop(self):
        """The run ends after the gas step in progress; one that is still prepared, at once with the step that prepares it."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._child.pid, signal.SIGTERM)  # the program itself has another group: tools/run passes it on

    def wait(self):
        """Returns when the run has ended, whichever way: what tools/run said of it is on standard error then. InputError with its words where it
        refused; StepFailed where a step before the program failed."""
        while True:
            try:
                code = self._child.wait()
                break
            except KeyboardInterrupt:
                self._child.send_signal(signal.SIGINT)
                self._child.wait()
                raise
        said = self._said()
        if code == REFUSED:
            raise InputError(said.strip().removeprefix(PREFIX))
        if code != 0 and "exit_code" not in run_state.record(self.folder):
            raise StepFailed(said.strip().removeprefix(PREFIX), code)
        sys.stderr.write(said)

    def _said(self):
        """What came on standard error; the child has ended."""
        if self._errors.closed:
            return ""
        self._errors.seek(0)
        with self._errors:
            return self._errors.read().decode("utf-8", "replace")
