# SPDX-License-Identifier: GPL-3.0-or-later
"""Which moments of two sources are the same one: by time step between dumps, by time [s] otherwise."""

import math
from dataclasses import dataclass
from typing import Optional

from interphase.input_error import InputError


@dataclass(frozen=True)
class Matching:
    """How the moments of two sources are named and matched.

    `by` is "step" or "time". `solid_step` [s] turns the steps of a dump into time; None where unknown.
    `solid_step_from` says where it comes from.
    """

    by: str
    solid_step: Optional[float]
    solid_step_from: str = ""

    def time(self, frame):
        """Time of a frame [s]; None for a dump of unknown solid step."""
        if frame.time is not None:
            return frame.time
        return None if self.solid_step is None else frame.step * self.solid_step

    def key(self, frame):
        """By what frames are matched: a step, or a time [s]."""
        return frame.step if self.by == "step" else self.time(frame)

    def within(self, frame, start, end):
        """True if the frame lies in [start, end], given in s, or in steps where the solid step is unknown."""
        at = self.time(frame)
        return self.inside(frame.step if at is None else at, start, end)

    def inside(self, at, start, end):
        """True if the moment `at`, in s or steps as `start` and `end`, lies between them; None: open end."""
        slack = self.slack(at)
        return (start is None or at >= start - slack) and (end is None or at <= end + slack)

    def slack(self, key):
        """Largest difference of the keys of one moment: sums of round-off, far below a solid step."""
        if self.by == "step":
            return 0
        return 1e-9 * abs(key) + (0.01 * self.solid_step if self.solid_step else 1e-12)

    def label(self, frame):
        """Names the moment of a frame in messages."""
        at = self.time(frame)
        parts = ([] if at is None else [f"t = {at:.9g} s"]) + ([] if frame.step is None else [f"timestep {frame.step}"])
        return ", ".join(parts)


def matching_of(a, b, given):
    """The `Matching` of two sources; `given` is the solid step of the command line [s] or None."""
    dumps = [source for source in (a, b) if source.kind != "run"]
    runs = [source for source in (a, b) if source.kind == "run"]
    recorded = [(step, run) for run in runs if (step := run.solid_step()) is not None]
    if given is not None:
        return Matching("step" if len(dumps) == 2 else "time", given, "--timestep")
    if len(dumps) == 2:
        return Matching("step", None)
    if dumps and not recorded:
        raise InputError(
            f"{runs[0].path}: no attribute solid_step in /meta of its results.h5, so the time steps of {dumps[0].path} "
            "cannot be turned into times. Give the script's time step in s: --timestep DT"
        )
    if not recorded:
        return Matching("time", None)
    step, run = min(recorded, key=lambda pair: pair[0])
    return Matching("time", step, f"/meta of {run.path}")


def merged(a, b, key, slack):
    """Walk two ascending iterables together: yields (item of a or None, item of b or None).

    A generator is asked for its next item only when its last one has been yielded.
    """
    a, b = iter(a), iter(b)
    left, right = next(a, None), next(b, None)
    while left is not None or right is not None:
        before = math.inf if left is None else key(left)
        after = math.inf if right is None else key(right)
        if abs(before - after) <= slack(min(before, after)):
            yield left, right
            left, right = next(a, None), next(b, None)
        elif before < after:
            yield left, None
            left = next(a, None)
        else:
            yield None, right
            right = next(b, None)
