# SPDX-License-Identifier: GPL-3.0-or-later
"""How a run ended: what its exit code means, and the cause that its log tells."""

import os
import re

from interphase import launch

# coupler/base/exit_code.hpp; tools/CLUSTERS.md has the table for users.
KINDS = {
    1: "the case was refused",
    3: "a step came out wrong",
    4: "LIGGGHTS ended with an error of its own",
    5: "OpenFOAM ended with an error of its own",
    6: "the disk is full",
    7: "an error of the program itself, or no memory left",
    8: "its limit of wall time was near",
}
WALL_LIMIT = 8

MOST_LINES = 30
RULE = re.compile(r"-{20,}$")  # about what mpirun says
OF_MPIRUN = re.compile(r"mpirun noticed that process rank|exited on signal \d+|mpirun was unable|There are not enough slots")


def _end_of(log):
    with open(log, "rb") as stream:
        stream.seek(0, os.SEEK_END)
        stream.seek(max(0, stream.tell() - 60000))
        return stream.read().decode("utf-8", "replace").splitlines()


def cause(log):
    """Lines of the program's own error message; without one, what mpirun says of a rank that died; else none."""
    lines = _end_of(log)
    begins = [number for number, line in enumerate(lines) if line.startswith("interphase: error:")]
    if begins:
        message = lines[begins[-1]:][:MOST_LINES]
        ends = [number for number, line in enumerate(message) if RULE.match(line)]
        message = message[: ends[0]] if ends else message
        while message and not message[-1].strip():
            message.pop()
        return message
    return [line for line in lines if OF_MPIRUN.search(line)][:3]


def kind(code):
    """What exit code `code` says, for a sentence."""
    if code in KINDS:
        return f"(exit code {code}: {KINDS[code]})"
    return launch.how_it_ended(code if code < 128 else 128 - code)


def stopped_by(code, signals):
    """What ended a run in good order before its end, by its exit code and the signals that were passed on to it; or nothing."""
    if len(signals) == 1 and code == 128 + signals[0]:
        return signals[0].name
    return "--wall-limit" if code == WALL_LIMIT else None


def has_checkpoint(folder):
    """Whether the run in `folder` can be gone on with."""
    checkpoints = os.path.join(folder, "checkpoints")
    return os.path.isdir(checkpoints) and any(not name.startswith(".") for name in os.listdir(checkpoints))


def way_to_go_on(case, folder):
    """The command line that goes on from a run's newest checkpoint, as the end of a sentence; empty where there is none."""
    if not has_checkpoint(folder):
        return ""
    return f".\nIt goes on from its last checkpoint by `tools/run {case} --out {folder} --resume`"


def closing_words(code, log, folder, quiet, go_on):
    """What tools/run says last of a run that did not reach its end: the cause behind everything else."""
    words = f"interphase stopped before its end {kind(code)}. What it recorded is kept in {folder}, its output in {log}{go_on}"
    why = cause(log)
    if code == 128 + 9:
        why.append("SIGKILL from elsewhere is often the system's, for want of memory: see `dmesg`; take more machines or a smaller bed")
    if why:
        return words + "\n\n" + "\n".join(why)
    # Without --quiet the end of the log is on the screen already.
    return words + (f". The end of it:\n{launch.last_lines(log)}" if quiet else "")
