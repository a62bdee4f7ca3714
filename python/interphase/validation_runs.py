# SPDX-License-Identifier: GPL-3.0-or-later
"""The runs of tools/validate: a scene (validation_scene.py) in LIGGGHTS and in the coupler, each in a folder of its own."""

import os
import re
import shutil
import subprocess

from interphase import case_folder, foam_file, launch
from interphase.input_error import InputError
from interphase.run_records import find_run

PROGRAMS = ("liggghts", "interphase-liggghts", "interphase")
DUMP, SCRIPT = "interphase_validate.dump", "interphase_validate.liggghts"
COLUMNS = "id type x y z vx vy vz omegax omegay omegaz fx fy fz radius"


def dump_lines():
    """Commands that write all particles of both sides, each number to the last bit."""
    form = " ".join("%d" if name in ("id", "type") else "%.17g" for name in COLUMNS.split())
    return [f"dump interphase_validate all custom ${{interphase_every}} {DUMP} {COLUMNS}",
            f'dump_modify interphase_validate sort id format "{form}"']


def native_run(scene, folder, ranks, lines):
    """The `lines` of a script in LIGGGHTS, in a copy `folder` of the scene's; what it said. InputError where it fails."""
    shutil.copytree(scene.folder, folder)
    write(os.path.join(folder, SCRIPT), "\n".join(lines) + "\n")
    # No `-screen none`: LIGGGHTS dies of it where a script inserts particles or has meshes.
    if scene.collides_by_plugin:
        program = [launch.program("interphase-liggghts")]
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


def coupler(folder, ranks):
    """interphase on the case in `folder`; InputError where it fails."""
    _run(launch.command(launch.program("interphase"), folder, ranks), folder, "log.interphase")


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


def write(path, text):
    """The file at `path`, its folder made."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def write_case(scene, folder, ranks, end, gas_step, solid_step):
    """The dictionaries of a case without gas, to `end` [s] by steps of `gas_step` [s]; `solid_step`: what `particles` says of it."""
    head = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
    write(os.path.join(folder, "system/controlDict"), head.format("controlDict") + (
        f"application interphase; startFrom startTime; startTime 0; stopAt endTime; endTime {end!r}; deltaT {gas_step!r};\n"
        f"writeControl adjustableRunTime; writeInterval {end!r}; timePrecision 12;\n"))
    listed = " ".join(f'{name} "{value}";' if " " in value else f"{name} {value};"
                      for name, value in {**scene.variables, **scene.wrong}.items())
    plugins = f"plugins ({' '.join(scene.plugins)});\n" if scene.plugins else ""
    write(os.path.join(folder, "system/couplingDict"), head.format("couplingDict") + (
        f"method {scene.method};\nweight {scene.weight:.17g};\n{plugins}"
        f'particles {{ script "{SCRIPT}"; {solid_step} variables {{ {listed} }} }}\ngas {{ model none; }}\n'))
    write(os.path.join(folder, "system/decomposeParDict"),
           head.format("decomposeParDict") + f"numberOfSubdomains {ranks}; method simple;\n")
    for rank in range(ranks if ranks > 1 else 0):
        os.makedirs(os.path.join(folder, f"processor{rank}"), exist_ok=True)


def solid_step_of(scene, out, gas_step, keys):
    """The solid step of a case [s], from a first gas step of `gas_step` [s]; `keys` {name: text}: of `particles` in couplingDict."""
    folder = os.path.join(out, "first-step")
    shutil.copytree(scene.folder, folder)
    write(os.path.join(folder, SCRIPT), "\n".join(scene.lines) + "\n")
    write_case(scene, folder, 1, gas_step, gas_step, " ".join(f"{name} {text};" for name, text in keys.items()))
    coupler(folder, 1)
    step = find_run(folder).solid_step()
    if step is None:
        raise InputError(f"{folder}: no solid_step in its results.h5")
    return step
