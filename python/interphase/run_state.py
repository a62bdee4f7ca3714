# SPDX-License-Identifier: GPL-3.0-or-later
"""How a run stands, by what tools/run writes into its folder: run.json, with the process that runs it while there is one."""

import datetime
import json
import os
import re
import signal
import socket

from interphase import ending, whole_file
from interphase.input_error import InputError

MARK = "run.json"

RUNNING, ENDED, STOPPED, FAILED, BROKEN_OFF, UNKNOWN = "running", "ended", "stopped", "failed", "broken off", "unknown"


def this_process():
    """What tells this process from a later one of the same number, for run.json, and since when it has run on which machine."""
    return {"pid": os.getpid(), "started": _started(os.getpid()), "host": socket.gethostname(), "machine": machine(),
            "date": datetime.date.today().isoformat()}


def machine():
    """The model of the processor as Linux names it, "" where it does not."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8", errors="replace") as stream:
            found = re.search(r"^model name\s*:\s*(.+)$", stream.read(), re.M)
    except OSError:
        return ""
    return found[1].strip() if found else ""


def _started(pid):
    """When the process began, in ticks since the machine did; None where there is none, or it has ended and waits to be asked."""
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8", errors="replace") as stream:
            fields = stream.read().rpartition(")")[2].split()
    except OSError:
        return None
    return None if fields[0] in "ZX" else int(fields[19])


def checked_folder(path, wanted="a run's folder"):
    """`path`; InputError where it is no folder. `wanted`: what to give, for the message."""
    if not os.path.isdir(path):
        what = "is a file" if os.path.exists(path) else "no such folder"
        raise InputError(f"{path}: {what}; give {wanted}, such as runs/sscp1-CGPM-w8")
    return path


def record(folder):
    """What run.json in `folder` holds, {} where there is none; InputError where it cannot be read."""
    path = os.path.join(folder, MARK)
    try:
        with open(path, encoding="utf-8") as stream:
            return json.load(stream)
    except FileNotFoundError:
        return {}
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None


def write(folder, what):
    """run.json of the run in `folder`, whole at any moment."""
    whole_file.write(os.path.join(folder, MARK), json.dumps(what, indent=2) + "\n")


def process_of(found):
    """Number of the process on this machine that runs what the record `found` tells of, None where there is none any more."""
    process = found.get("process")
    if not process or process["host"] != socket.gethostname() or process["started"] is None:
        return None
    return process["pid"] if _started(process["pid"]) == process["started"] else None


def state_of(found):
    """One of
      running      its process is there
      ended        it reached its end
      stopped      by a signal, or by --wall-limit: whole, it can go on
      failed       it ended with an error
      broken off   no end is recorded, and its process is gone: killed, or a step before the program failed
      unknown      it runs, or ran, on another machine, or without tools/run
    """
    if process_of(found) is not None:
        return RUNNING
    code = found.get("exit_code")
    if code is not None:
        if code == 0:
            return ENDED
        by_signal = code in (128 + number for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM))
        return STOPPED if by_signal or code == ending.WALL_LIMIT else FAILED
    process = found.get("process")
    return BROKEN_OFF if process and process["host"] == socket.gethostname() else UNKNOWN
