# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/validate runs: a script up to its last `run`, of its own or of a case."""

import os
import re
import subprocess
from dataclasses import dataclass, field

from interphase import case_folder, foam_file, methods
from interphase.input_error import InputError
from interphase.particle_script import commands
from interphase.tree import TOOLS
from interphase.validation_runs import solid_step_of

LARGEST_FOLDER = 5e8  # bytes: copied four times for each number of ranks


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

    @property
    def collides_by_plugin(self):
        """Whether its collisions are those of a fix of a plug-in."""
        return methods.method(self.method, tuple(map(foam_file.unquoted, self.plugins)), self.folder).collisions_of_plugin


def cut_at_last_run(path):
    """(lines before the last `run`, its number of steps as written, notes). InputError where it has none, or jumps."""
    with open(path, encoding="utf-8", errors="replace") as stream:
        text = stream.read()
    found = list(commands(text))
    runs = [each for each in found if each[2][0] == "run"]
    if not runs:
        raise InputError(f"{path}: no `run` in it. Give a script that sets `timestep` and does `run N`, or a case's folder")
    start, end, words = runs[-1]
    behind = [words for first, _, words in found if first > end]
    jumps = [w for w in behind if w[0] in ("jump", "next")]
    if jumps:
        raise InputError(f"{path}, line {start}: `{' '.join(words)}` stands in a loop ({' '.join(jumps[0])} behind it); the coupler "
                         "does the last run itself, so that one must stand alone: write it out")
    if len(words) < 2 or len(words) > 2 and any(w in ("upto", "every", "start", "stop") for w in words[2:]):
        raise InputError(f"{path}, line {start}: `{' '.join(words)}`: `run N` alone is understood for the last run")
    if not re.fullmatch(r"\d+|\$\{\w+\}|\$\w", words[1]):
        raise InputError(f"{path}, line {start}: `run {words[1]}`: a number or a variable, ${{name}}, is expected")
    notes = []
    if len(runs) > 1:
        notes.append(f"the earlier runs of the script ({len(runs) - 1}) are LIGGGHTS's own on both sides; the last one is compared")
    if behind:
        notes.append(f"what follows the last run is left out: {' '.join(behind[0])}" + (" ..." if len(behind) > 1 else ""))
    return text.splitlines()[: start - 1], words[1], notes


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
    method = case_folder.method_of(case).name
    script = os.path.join(folder, foam_file.unquoted(text))
    with open(script, encoding="utf-8") as stream:
        lines = stream.read().splitlines()
    if any(words[0] == "run" for _, _, words in commands("\n".join(lines))):
        raise InputError(f"{script}: it has a `run` of its own; give the script instead of the case")
    scene = Scene(folder, lines, "0", {**given, **variables}, method, float(case.value(case_folder.COUPLING, "weight", "1")),
                  plugins, wrong)
    gas_step = float(case.value(case_folder.CONTROL, "deltaT"))
    keys = {name: case.value(case_folder.COUPLING, f"particles/{name}")
            for name in ("stepsPerCollision", "solidStep", "largestOverlap", "impactSpeed")}
    solid_step = solid_step_of(scene, out, gas_step, {name: text for name, text in keys.items() if text is not None})
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
