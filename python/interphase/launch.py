# SPDX-License-Identifier: GPL-3.0-or-later
"""Start programs: with the environment they need, their output kept in a log, signals passed on."""

import os
import shlex
import shutil
import signal
import subprocess
import sys

from interphase import missing
from interphase.input_error import InputError
from interphase.tree import REPOSITORY


class StepFailed(Exception):
    """A program did not do its part; `code` is the exit code to leave with."""

    def __init__(self, message, code=1):
        super().__init__(message)
        self.code = code


def additions(environment):
    """Variables that the engines need and `environment` lacks (PATH apart): a dict."""
    wanted = {"OMP_NUM_THREADS": "1"}
    if "WM_PROJECT_DIR" not in environment:
        wanted["WM_PROJECT_DIR"] = "/usr/share/openfoam"
    if os.geteuid() == 0:
        # Open MPI refuses root otherwise; in containers and CI one is.
        wanted["OMPI_ALLOW_RUN_AS_ROOT"] = "1"
        wanted["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1"
    return {name: text for name, text in wanted.items() if environment.get(name) != text}


def cores():
    """Cores that this process may use, hardware threads of one core counted once, as Open MPI does."""
    seen = set()
    for cpu in os.sched_getaffinity(0):
        topology = f"/sys/devices/system/cpu/cpu{cpu}/topology"
        try:
            with open(f"{topology}/physical_package_id") as package, open(f"{topology}/core_id") as core:
                seen.add((package.read(), core.read()))
        except OSError:
            seen.add(cpu)
    return len(seen)


def cpu_of_children():
    """Seconds of a core, user's and system's, of all programs that this process has started and that have ended."""
    spent = os.times()
    return spent.children_user + spent.children_system


def command(binary, run_folder, ranks):
    """The command line of a prepared case, a list."""
    if ranks == 1:
        return [binary, "-case", run_folder]
    oversubscribe = ["--oversubscribe"] if ranks > cores() else []
    return ["mpirun", "-np", str(ranks), *oversubscribe, binary, "-parallel", "-case", run_folder]


def as_typed(arguments, variables):
    """The command line as one would type it, with the variables set for it."""
    return " ".join([f"{name}={shlex.quote(text)}" for name, text in variables.items()] + [shlex.join(arguments)])


def last_lines(path, count=15):
    """The last `count` lines of a file, each marked, for a message."""
    with open(path, "rb") as stream:
        stream.seek(0, os.SEEK_END)
        stream.seek(max(0, stream.tell() - 20000))
        lines = stream.read().decode("utf-8", "replace").splitlines()
    return "\n".join("  | " + line for line in lines[-count:])


def step(arguments, log, environment, folder):
    """Run one preparing or closing program in `folder`, its output in the file `log`.

    StepFailed with the end of the log where it fails.
    """
    name = os.path.basename(arguments[0])
    program = shutil.which(arguments[0], path=environment.get("PATH"))
    if program is None:
        raise StepFailed(f"{name}: no such program on PATH; tools/setup installs it")
    with open(log, "wb") as stream:
        try:
            done = subprocess.run(
                [program, *arguments[1:]], stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT,
                env=environment, cwd=folder,
            )
        except OSError as error:
            raise StepFailed(f"{name} cannot be started: {error}") from None
    if done.returncode != 0:
        said = last_lines(log)
        hint = missing.hint(said.replace("  | ", ""))
        raise StepFailed(f"{name} failed {how_it_ended(done.returncode)}. The end of {log}:\n{said}{hint}")


def build_folder():
    """Where our programs are built."""
    return os.environ.get("INTERPHASE_BUILD") or os.path.join(REPOSITORY, "build", "release")


def program(name, environment=os.environ):
    """The path of one of our programs: INTERPHASE_BIN, or what stands beside it, or the build's; InputError where it is not there."""
    chosen = environment.get("INTERPHASE_BIN") or os.path.join(build_folder(), "interphase")
    path = chosen if name == "interphase" else os.path.join(os.path.dirname(os.path.realpath(chosen)), name)
    if not os.access(path, os.X_OK):
        raise InputError(f"{path}: the program is not there; `tools/setup` builds it, INTERPHASE_BIN names another interphase")
    return path


def liggghts(script, folder, variables=None, plugins=None, ranks=1, timeout=None, environment=None):
    """Run a LIGGGHTS script in `folder` with `variables` {name: value}: by the packaged `liggghts`, or by ours with the `plugins` [name, ...];
    `timeout` [s] of wall time; `environment`: variables beside those there are.

    Returns what it said. StepFailed with the end of that where it fails. A screen is left to it: some scripts crash with `-screen none`.
    """
    environment = {**os.environ, **additions(os.environ), **(environment or {})}
    words = ["liggghts"] if plugins is None else [program("interphase-liggghts", environment), *(word for name in plugins for word in ("-plugin", name))]
    words = [*(["mpirun", "-np", str(ranks), "--oversubscribe"] if ranks > 1 else []), *words, "-in", script]
    for name, value in (variables or {}).items():
        words += ["-var", name, f"{value}"]
    done = subprocess.run(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=timeout)  # fmt: skip
    if done.returncode != 0:
        raise StepFailed(f"{' '.join(words)} in {folder} failed {how_it_ended(done.returncode)}:\n{(done.stdout + done.stderr)[-2000:]}")
    return done.stdout


def how_it_ended(returncode):
    """What a return code of subprocess says, in brackets."""
    if returncode >= 0:
        return f"(exit code {returncode})"
    try:
        return f"(killed by {signal.Signals(-returncode).name})"
    except ValueError:
        return f"(killed by signal {-returncode})"


def run(arguments, log, environment, folder, quiet=False, passed_on=None, watch=None):
    """Run the program, its output shown as it comes and kept in `log`; returns the exit code.

    SIGINT, SIGTERM and SIGHUP (as SIGTERM) go on to the program and are added to the list `passed_on`: it ends after the
    step in progress, by a second one at once. mpirun ends its ranks for each of them, with an exit code of its own: the
    first goes through it as SIGUSR2. The program gets its own session, so that a Ctrl-C reaches it once.
    A program killed by signal n gives 128 + n, as in a shell, and so does one that has stopped for it.
    `watch` (until_error.Watch) may end it, too, by SIGUSR2.
    """
    passed_on = [] if passed_on is None else passed_on
    by_mpirun = os.path.basename(arguments[0]) == "mpirun"
    with open(log, "wb") as copy:
        try:
            program = subprocess.Popen(
                arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                env=environment, cwd=folder, start_new_session=True,
            )
        except OSError as error:
            raise StepFailed(f"{arguments[0]} cannot be started: {error}", 127) from None

        def forward(number, _frame):
            passed_on.append(signal.SIGTERM if number == signal.SIGHUP else signal.Signals(number))
            program.send_signal(signal.SIGUSR2 if by_mpirun and len(passed_on) == 1 else passed_on[-1])

        before = {}
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            if signal.getsignal(number) != signal.SIG_IGN:  # nohup stays nohup
                before[number] = signal.signal(number, forward)
        if watch is not None:
            watch.start(lambda: program.send_signal(signal.SIGUSR2))
        try:
            shown = not quiet
            while chunk := os.read(program.stdout.fileno(), 65536):
                copy.write(chunk)
                copy.flush()
                if shown:
                    shown = _show(chunk)
            code = program.wait()
        finally:
            if watch is not None:
                watch.end()
            for number, handler in before.items():
                signal.signal(number, handler)
    code = code if code >= 0 else 128 - code
    if by_mpirun and code == 128 + signal.SIGUSR2 and passed_on:
        return 128 + passed_on[0]
    return 128 + passed_on[-1] if by_mpirun and code != 0 and len(passed_on) > 1 else code


def _show(chunk):
    """Pass `chunk` to our own output; False once nobody reads it any more (`tools/run ... | head`)."""
    try:
        sys.stdout.buffer.write(chunk)
        sys.stdout.buffer.flush()
        return True
    except BrokenPipeError:
        # The run goes on and its log stays whole; later prints go nowhere.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return False
