# SPDX-License-Identifier: GPL-3.0-or-later
"""One LIGGGHTS script in the packaged `liggghts` and in the coupler without gas, compared and judged: tools/validate."""

import math
import os
import re
import shutil
from types import SimpleNamespace

import numpy

from interphase import case_folder, comparison
from interphase.difference import Difference, compare_particles
from interphase.input_error import InputError
from interphase.liggghts_dump import Dump
from interphase.matching_times import Matching
from interphase.run_records import find_run
from interphase.validation_runs import DUMP, SCRIPT, coupler, dump_lines, native_run, write, write_case

SOLID_STEPS_IN_GAS_STEP = 200  # at most: so often the coupler stops and goes on
STEPS_OF_A_DUMP = 400          # a dump every ten times (run / this) steps: some forty
# Round-off of another origin may start a thousand times larger than the twin's, and not be seen to grow faster.
ROUND_OFF_FACTOR = 1e3
# Where a twin is this far off, of the quantity's root mean square, growth has ended and says nothing.
SATURATED = 1e-2
EQUAL, DIFFERS, CANNOT, UNJUDGED = comparison.EQUAL, comparison.DIFFERS, comparison.CANNOT, comparison.UNJUDGED


def validate(scene, out, ranks):
    """(exit code, verdict, lines of a report) of the scene on so many ranks."""
    native = os.path.join(out, f"liggghts-{ranks}")
    heading = [f"variable interphase_every equal 10*ceil({scene.steps}/{STEPS_OF_A_DUMP})",
               f'print "interphase_steps {scene.steps} every ${{interphase_every}}"', *dump_lines()]
    words = native_run(scene, native, ranks, [*scene.lines, *heading, f"run {scene.steps}"])
    plan = re.findall(r"^interphase_steps (\d+) every (\d+)", words, re.M)
    times = re.findall(r"^\s*timestep\s+([-+.\deE]+)", words, re.M)
    if not plan or not times:
        raise InputError(f"{native}/log.screen: " + ("no `timestep`: the script must set one" if plan else "its end was not reached"))
    steps, every, solid_step = int(plan[-1][0]), int(plan[-1][1]), float(times[-1])
    inner = max(n for n in range(1, SOLID_STEPS_IN_GAS_STEP + 1) if every % n == 0)
    gas_steps = math.ceil(steps / inner)
    coupled = os.path.join(out, f"interphase-{ranks}")
    shutil.copytree(scene.folder, coupled)
    write(os.path.join(coupled, SCRIPT), "\n".join([*scene.lines, f"variable interphase_every equal {every}", *dump_lines()]) + "\n")
    write_case(scene, coupled, ranks, gas_steps * inner * solid_step, inner * solid_step, f"solidStep {solid_step!r};")
    coupler(coupled, ranks)
    report = list(scene.notes)
    if scene.collides_by_plugin:
        report.append(f"{scene.method} comes from a plug-in: the reference is interphase-liggghts, the packaged library with it")
    taken = find_run(coupled).solid_step()
    if taken is not None and taken != solid_step:
        report.append(f"the coupler's solid step is {taken!r} s, LIGGGHTS's {solid_step!r} s: rounding")
    code, verdict, lines = _judged(scene, out, native, coupled, ranks, solid_step, every, heading)
    return code, verdict, report + lines


def _dump(folder):
    path = os.path.join(folder, DUMP)
    if not os.path.isfile(path):
        raise InputError(f"{path} was not written; the run is shorter than ten steps?")
    return Dump(path, [path])


def _difference(a, b, last=None):
    found = Difference()
    compare_particles(_dump(a), _dump(b), Matching("step", None), found, end=last)
    return found


def _judged(scene, out, native, coupled, ranks, solid_step, every, heading):
    last = max(frame.step for frame in _dump(native).frames())
    found = _difference(native, coupled, last)
    count = sum(q.compared for q in found.quantities.values())
    if not count:
        raise InputError(f"no particle is in both dumps at any time: {native}, {coupled}")
    seen = [f"{found.times} dumps, every {every} steps: {found.first_time} to {found.last_time}"]
    if not _moves(native):
        seen.append("no particle moves in any of these dumps: little is shown by them")
    lone = [side.count for side in found.only_times]
    if any(lone):
        return DIFFERS, "different", [*seen, f"dumps of one side only: {lone[0]} of LIGGGHTS, {lone[1]} of the coupler"]
    if found.bit_equal():
        return EQUAL, "bit-equal", seen
    seen += _largest(found)
    twin = _twin(scene, out, ranks, heading, solid_step)
    same = min(_first_lone(native, coupled), _first_lone(native, twin)) - 1
    code, verdict, words = _by_growth(found, _difference(native, twin, last), _dumps_until(native, same))
    if code is None:
        code, verdict, more = _by_statistics(native, coupled)
        words += more
    return code, verdict, seen + words


def _moves(folder):
    return any((numpy.abs(frame.load().quantities["velocity"]) > 0).any() for frame in _dump(folder).frames())


def _largest(found):
    lines = [f"{q.name}: off by up to {q.size:.3g} ({q.relative:.2g} of its root mean square), first at {q.first}"
             for q in found.quantities.values() if q.differing]
    for side, one in zip(("LIGGGHTS", "the coupler"), found.only_ids):
        if one.count:
            lines.append(f"only in {side}: {one.count} particles, summed over the dumps: {'; '.join(one.examples[:2])}")
    return lines


def _twin(scene, out, ranks, heading, solid_step):
    """LIGGGHTS once more, the solid step of the last run shorter by four units in the last place.

    Other than a displacement, it reaches what is inserted later and walls that move.
    """
    folder = os.path.join(out, f"liggghts-{ranks}-twin")
    native_run(scene, folder, ranks, [*scene.lines, f"timestep {solid_step * (1 - 2.0**-50)!r}", *heading, f"run {scene.steps}"])
    return folder


def _first_lone(a, b):
    """The step of the first dump in which not the same particles are, infinity where there is none."""
    for left, right in zip(_dump(a).frames(), _dump(b).frames()):
        if not numpy.array_equal(left.load().ids, right.load().ids):
            return left.step
    return math.inf


def _dumps_until(folder, step):
    return sum(frame.step <= step for frame in _dump(folder).frames())


def _by_growth(found, twin, dumps):
    """Is the difference what round-off grows to? (None, "", words) where the twin cannot tell.

    Position and velocity are looked at in the first `dumps`, which show the same particles, where the twin is off, but by
    less than SATURATED: there the coupler may be no more than ROUND_OFF_FACTOR times off.
    """
    judged, worst, where = 0, 0.0, ""
    for own, other in zip(found.history[:dumps], twin.history[:dumps]):
        for name in ("position", "velocity"):
            scale = twin.quantities[name].rms
            if not other[name] < SATURATED * scale or own[name] == other[name] == 0:
                continue
            judged += 1
            # A twin that is not off yet may be by the last place.
            ratio = own[name] / max(other[name], 2.0**-52 * scale)
            if ratio > worst:
                worst, where = ratio, f"{name} at {own['at']}"
    if not judged:
        return None, "", ["round-off has grown to the size of the flow in every dump of LIGGGHTS's own twin"]
    words = [f"beside LIGGGHTS with another solid step in the last places: {worst:.2g} times as far off at most ({where}), "
             f"{judged} numbers looked at; {ROUND_OFF_FACTOR:g} is allowed"]
    return (EQUAL, "equal up to the growth of round-off", words) if worst <= ROUND_OFF_FACTOR else (DIFFERS, "different", words)


def _by_statistics(native, coupled):
    try:
        code, verdict, comparisons, notes, _ = comparison.means(_dump(native), _dump(coupled), SimpleNamespace(start=None, end=None, timestep=None, only=(), confidence=0.99))
    except InputError as error:
        return UNJUDGED, "cannot be judged", [str(error)]
    words = [f"{c.name}: LIGGGHTS {c.a.value:.4g}, coupler {c.b.value:.4g}, {c.verdict}" for c in comparisons if c.certain and c.a]
    counts = [c.verdict for c in comparisons]
    words.append("by statistics: " + ", ".join(f"{counts.count(v)} {v}" for v in dict.fromkeys(counts)))
    return code, verdict, words + [f"note: {note}" for note in notes]
