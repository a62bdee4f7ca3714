# SPDX-License-Identifier: GPL-3.0-or-later
"""One LIGGGHTS script in the packaged `liggghts` and in the coupler without gas, compared and judged: tools/validate."""

import math
import os
import re
import shutil
import subprocess
from dataclasses import dataclass, field

import numpy

from interphase import case_folder, comparison, foam_file, launch
from interphase.difference import Difference, Tolerances, compare_particles
from interphase.input_error import InputError
from interphase.liggghts_dump import Dump
from interphase.matching_times import Matching
from interphase.run_records import find_run
from interphase.tree import REPOSITORY, TOOLS

BUILD = os.path.join(REPOSITORY, "build", "release")
PROGRAMS = ("liggghts", "interphase-liggghts", "interphase")
DUMP, SCRIPT = "interphase_validate.dump", "interphase_validate.liggghts"
COLUMNS = "id type x y z vx vy vz omegax omegay omegaz fx fy fz radius"
SOLID_STEPS_IN_GAS_STEP = 200  # at most: so often the coupler stops and goes on
STEPS_OF_A_DUMP = 400          # a dump every ten times (run / this) steps: some forty
# Round-off of another origin may start a thousand times larger than the twin's, and not be seen to grow faster.
ROUND_OFF_FACTOR = 1e3
# Where a twin is this far off, of the quantity's root mean square, growth has ended and says nothing.
SATURATED = 1e-2
LARGEST_FOLDER = 5e8  # bytes: copied four times for each number of ranks
EQUAL, DIFFERS, CANNOT, UNJUDGED = comparison.EQUAL, comparison.DIFFERS, comparison.CANNOT, comparison.UNJUDGED


@dataclass
class Scene:
    """What is run: `script` in `folder`, from which it finds its files; `variables` for both sides, `wrong` for the coupler alone.

    `lines` of the script up to its last run, `steps` of that run as it is written (a number or ${name}).
    """

    folder: str
    lines: list
    steps: str
    variables: dict
    method: str = "DEM"
    weight: float = 1.0
    plugins: tuple = ()
    wrong: dict = field(default_factory=dict)
    notes: list = field(default_factory=list)


def commands(text):
    """(first line, line behind the last, command) of a script, lines that end in & joined, comments taken off."""
    found, start, whole = [], 0, ""
    lines = text.splitlines()
    for at, line in enumerate(lines):
        if not whole:
            start = at
        bare = line.split("#")[0].rstrip()
        whole += " " + bare.rstrip("&")
        if not bare.endswith("&"):
            found.append((start, at + 1, whole.split()))
            whole = ""
    return found


def cut_at_last_run(path):
    """(lines before the last `run`, its number of steps as written, notes). InputError where it has none, or jumps."""
    with open(path, encoding="utf-8", errors="replace") as stream:
        text = stream.read()
    found = commands(text)
    runs = [(start, end, words) for start, end, words in found if words[:1] == ["run"]]
    if not runs:
        raise InputError(f"{path}: no `run` in it. Give a script that sets `timestep` and does `run N`, or a case's folder")
    start, end, words = runs[-1]
    behind = [w for s, _, w in found if s >= end and w]
    jumps = [w for w in behind if w[0] in ("jump", "next")]
    if jumps:
        raise InputError(f"{path}, line {start + 1}: `{' '.join(words)}` stands in a loop ({' '.join(jumps[0])} behind it); the coupler "
                         "does the last run itself, so that one must stand alone: write it out")
    if len(words) < 2 or len(words) > 2 and any(w in ("upto", "every", "start", "stop") for w in words[2:]):
        raise InputError(f"{path}, line {start + 1}: `{' '.join(words)}`: `run N` alone is understood for the last run")
    if not re.fullmatch(r"\d+|\$\{\w+\}|\$\w", words[1]):
        raise InputError(f"{path}, line {start + 1}: `run {words[1]}`: a number or a variable, ${{name}}, is expected")
    notes = []
    if len(runs) > 1:
        notes.append(f"the earlier runs of the script ({len(runs) - 1}) are LIGGGHTS's own on both sides; the last one is compared")
    if behind:
        notes.append(f"what follows the last run is left out: {' '.join(behind[0])}" + (" ..." if len(behind) > 1 else ""))
    return text.splitlines()[:start], words[1], notes


def scene_of_script(path, out, variables, wrong, weight, method, plugins):
    """The `Scene` of a plain script: its folder is copied to `out`."""
    lines, steps, notes = cut_at_last_run(path)
    defined = [w for _, _, w in commands("\n".join(lines)) if w[:2] == ["variable", "weight"]]
    if defined and weight is None:
        raise InputError(f"{path}: it has a variable `weight`, which the coupler hands over: say which by --weight W")
    folder, source = os.path.join(out, "scene"), os.path.dirname(os.path.realpath(path))
    if os.path.commonpath([source, os.path.realpath(out)]) == source:
        raise InputError(f"{path}: its folder {source}, which is copied, holds {out}: put the script and its files into a folder of their "
                         "own, or give another --out")
    size = sum(os.path.getsize(os.path.join(base, name)) for base, _, names in os.walk(source) for name in names
               if os.path.isfile(os.path.join(base, name)))
    if size > LARGEST_FOLDER:
        raise InputError(f"{path}: its folder {source}, which is copied, holds {size / 1e9:.2g} GB, {LARGEST_FOLDER / 1e9:g} at most are taken: put "
                         "the script and the files that it reads into a folder of their own")
    case_folder.copy(source, folder)
    weight = 1.0 if weight is None else weight
    method = method or ("DEM" if weight == 1 else "CGPM")
    return Scene(folder, lines, steps, variables, method, weight, tuple(plugins), wrong, notes)


def scene_of_case(path, out, settings, until, variables, wrong):
    """The `Scene` of a case: made ready by tools/run, its solid step taken from a first gas step without gas."""
    folder = os.path.join(out, "scene")
    command = [os.path.join(TOOLS, "run"), path, "--out", folder, "--no-picture", "--quiet"]
    for setting in settings:
        command += ["--set", setting]
    environment = {**os.environ, "INTERPHASE_BIN": "/bin/true"}
    done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise InputError(f"{path} cannot be made ready: {(done.stderr or done.stdout).strip()}")
    case = case_folder.Dictionaries(folder)
    particles = foam_file.find(case.text(case_folder.COUPLING), "particles")
    given = _values(case, particles, "particles/variables")
    text = case.value(case_folder.COUPLING, "particles/script")
    plugins = tuple(re.findall(r"[^\s()\"]+|\"[^\"]*\"", case.value(case_folder.COUPLING, "plugins", "()")))
    method = case.value(case_folder.COUPLING, "method", "DEM")
    script = os.path.join(folder, foam_file.unquoted(text))
    with open(script, encoding="utf-8") as stream:
        lines = stream.read().splitlines()
    if any(words[:1] == ["run"] for _, _, words in commands("\n".join(lines))):
        raise InputError(f"{script}: it has a `run` of its own; give the script instead of the case")
    scene = Scene(folder, lines, "0", {**given, **variables}, method, float(case.value(case_folder.COUPLING, "weight", "1")),
                  plugins, wrong)
    gas_step = float(case.value(case_folder.CONTROL, "deltaT"))
    keys = {name: case.value(case_folder.COUPLING, f"particles/{name}")
            for name in ("stepsPerCollision", "solidStep", "largestOverlap", "impactSpeed")}
    solid_step = _solid_step(scene, out, gas_step, {name: text for name, text in keys.items() if text is not None})
    end = float(until if until is not None else case.value(case_folder.CONTROL, "endTime"))
    scene.steps = str(max(10, round(end / solid_step)))
    scene.lines = [*lines, f"timestep {solid_step!r}"]
    return scene


def _values(case, particles, path):
    """{name: value} of the variables that the case hands to its script."""
    names = next((e.names() for e in particles.entries if getattr(e, "entries", None) is not None and e.key == "variables"), ())
    found = {name: foam_file.unquoted(case.value(case_folder.COUPLING, f"{path}/{name}")) for name in names}
    for name, value in found.items():
        if "$" in value or "#" in value:
            raise InputError(f"{case_folder.COUPLING}: {path}/{name} {value}: only OpenFOAM knows what that is; write the number there")
    return found


def _solid_step(scene, out, gas_step, keys):
    folder = os.path.join(out, "first-step")
    shutil.copytree(scene.folder, folder)
    _write(os.path.join(folder, SCRIPT), "\n".join(scene.lines) + "\n")
    _write_case(scene, folder, 1, gas_step, gas_step, " ".join(f"{name} {text};" for name, text in keys.items()))
    _coupler(folder, 1)
    step = find_run(folder).solid_step()
    if step is None:
        raise InputError(f"{folder}: no solid_step in its results.h5")
    return step


def validate(scene, out, ranks):
    """(exit code, verdict, lines of a report) of the scene on so many ranks."""
    native = os.path.join(out, f"liggghts-{ranks}")
    heading = [f"variable interphase_every equal 10*ceil({scene.steps}/{STEPS_OF_A_DUMP})",
               f'print "interphase_steps {scene.steps} every ${{interphase_every}}"', *_dump_lines()]
    words = _native(scene, native, ranks, [*scene.lines, *heading, f"run {scene.steps}"])
    plan = re.findall(r"^interphase_steps (\d+) every (\d+)", words, re.M)
    times = re.findall(r"^\s*timestep\s+([-+.\deE]+)", words, re.M)
    if not plan or not times:
        raise InputError(f"{native}/log.screen: " + ("no `timestep`: the script must set one" if plan else "its end was not reached"))
    steps, every, solid_step = int(plan[-1][0]), int(plan[-1][1]), float(times[-1])
    inner = max(n for n in range(1, SOLID_STEPS_IN_GAS_STEP + 1) if every % n == 0)
    gas_steps = math.ceil(steps / inner)
    coupled = os.path.join(out, f"interphase-{ranks}")
    shutil.copytree(scene.folder, coupled)
    _write(os.path.join(coupled, SCRIPT), "\n".join([*scene.lines, f"variable interphase_every equal {every}", *_dump_lines()]) + "\n")
    _write_case(scene, coupled, ranks, gas_steps * inner * solid_step, inner * solid_step, f"solidStep {solid_step!r};")
    _coupler(coupled, ranks)
    report = list(scene.notes)
    if scene.method in case_folder.OF_PLUGINS:
        report.append(f"{scene.method} comes from a plug-in: the reference is interphase-liggghts, the packaged library with it")
    taken = find_run(coupled).solid_step()
    if taken is not None and taken != solid_step:
        report.append(f"the coupler's solid step is {taken!r} s, LIGGGHTS's {solid_step!r} s: rounding")
    code, verdict, lines = _judged(scene, out, native, coupled, ranks, solid_step, every, heading)
    return code, verdict, report + lines


def _dump_lines():
    form = " ".join("%d" if name in ("id", "type") else "%.17g" for name in COLUMNS.split())
    return [f"dump interphase_validate all custom ${{interphase_every}} {DUMP} {COLUMNS}",
            f'dump_modify interphase_validate sort id format "{form}"']


def _native(scene, folder, ranks, lines):
    shutil.copytree(scene.folder, folder)
    _write(os.path.join(folder, SCRIPT), "\n".join(lines) + "\n")
    # No `-screen none`: LIGGGHTS dies of it where a script inserts particles or has meshes.
    if scene.method in case_folder.OF_PLUGINS:
        program = [_program("interphase-liggghts")]
        for name in scene.plugins:
            program += ["-plugin", foam_file.unquoted(name)]
    else:
        program = ["liggghts"]
    # Line by line: an abort of MPI loses what LIGGGHTS said last, the reason.
    command = ["stdbuf", "-oL", *program, "-in", SCRIPT, "-echo", "both"]
    for name, value in {"weight": f"{scene.weight:.17g}", **scene.variables}.items():
        command += ["-var", name, value]  # one word, as the coupler hands it over
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks), "--oversubscribe", *command]
    return _run(command, folder, "log.screen")


def _program(name):
    """The path of one of our programs: INTERPHASE_BIN, or what stands beside it, or the build's."""
    chosen = os.environ.get("INTERPHASE_BIN") or os.path.join(BUILD, "interphase")
    path = chosen if name == "interphase" else os.path.join(os.path.dirname(os.path.realpath(chosen)), name)
    if not os.access(path, os.X_OK):
        raise InputError(f"{path}: the program is not there; `tools/setup` builds it, INTERPHASE_BIN names another interphase")
    return path


def _coupler(folder, ranks):
    _run(launch.command(_program("interphase"), folder, ranks), folder, "log.interphase")


def _run(command, folder, log):
    for program in (command[0], "liggghts"):
        if shutil.which(program) is None:
            raise InputError(f"{program}: no such program; tools/setup installs it")
    path = os.path.join(folder, log)
    with open(path, "wb") as stream:
        done = subprocess.run(command, cwd=folder, env={**os.environ, **launch.additions(os.environ)}, stdin=subprocess.DEVNULL,
                              stdout=stream, stderr=subprocess.STDOUT)
    with open(path, encoding="utf-8", errors="replace") as stream:
        text = stream.read()
    name = next(os.path.basename(word) for word in command if os.path.basename(word) in PROGRAMS)
    said = re.findall(r"^ERROR.*", text, re.M)
    if done.returncode != 0 or said:  # LIGGGHTS leaves with 0 after some errors on several ranks
        # What MPI says of an end comes after what LIGGGHTS said.
        raise InputError(f"{name} failed {launch.how_it_ended(done.returncode)} in {folder}. "
                         + "".join(f"{line}\n" for line in said[:3]) + f"The end of {log}:\n{launch.last_lines(path)}")
    return text


def _write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def _write_case(scene, folder, ranks, end, gas_step, solid_step):
    head = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
    _write(os.path.join(folder, "system/controlDict"), head.format("controlDict") + (
        f"application interphase; startFrom startTime; startTime 0; stopAt endTime; endTime {end!r}; deltaT {gas_step!r};\n"
        f"writeControl adjustableRunTime; writeInterval {end!r}; timePrecision 12;\n"))
    listed = " ".join(f'{name} "{value}";' if " " in value else f"{name} {value};"
                      for name, value in {**scene.variables, **scene.wrong}.items())
    plugins = f"plugins ({' '.join(scene.plugins)});\n" if scene.plugins else ""
    _write(os.path.join(folder, "system/couplingDict"), head.format("couplingDict") + (
        f"method {scene.method};\nweight {scene.weight:.17g};\n{plugins}"
        f'particles {{ script "{SCRIPT}"; {solid_step} variables {{ {listed} }} }}\ngas {{ model none; }}\n'))
    _write(os.path.join(folder, "system/decomposeParDict"),
           head.format("decomposeParDict") + f"numberOfSubdomains {ranks}; method simple;\n")
    for rank in range(ranks if ranks > 1 else 0):
        os.makedirs(os.path.join(folder, f"processor{rank}"), exist_ok=True)


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
    _native(scene, folder, ranks, [*scene.lines, f"timestep {solid_step * (1 - 2.0**-50)!r}", *heading, f"run {scene.steps}"])
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


@dataclass
class _Options:
    """What comparison.means asks for."""

    start: None = None
    end: None = None
    timestep: None = None
    only: tuple = ()
    confidence: float = 0.99
    tolerances: Tolerances = field(default_factory=Tolerances)


def _by_statistics(native, coupled):
    try:
        code, verdict, comparisons, notes, _ = comparison.means(_dump(native), _dump(coupled), _Options())
    except InputError as error:
        return UNJUDGED, "cannot be judged", [str(error)]
    words = [f"{c.name}: LIGGGHTS {c.a.value:.4g}, coupler {c.b.value:.4g}, {c.verdict}" for c in comparisons if c.certain and c.a]
    counts = [c.verdict for c in comparisons]
    words.append("by statistics: " + ", ".join(f"{counts.count(v)} {v}" for v in dict.fromkeys(counts)))
    return code, verdict, words + [f"note: {note}" for note in notes]
