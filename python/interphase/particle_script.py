# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the LIGGGHTS script of a case takes its particles from, as far as its text tells.

Files that it includes are followed; ${names} are looked up in particles/variables of couplingDict and among the script's own
`variable NAME index|string VALUE`.
"""

import os
import re
from dataclasses import dataclass, field
from typing import Optional

from interphase.case_folder import COUPLING
from interphase.input_error import InputError

# What `set` may change of a particle that was read from a file
OF_A_PARTICLE = {"type", "x", "y", "z", "diameter", "density", "mass", "volume", "omegax", "omegay", "omegaz"}


@dataclass
class ParticleSource:
    """`file`: what read_data reads, from the case folder on; None where it reads none. `others`: commands that make particles or
    change them, with their places. `inserts`: whether particles come later. `periodic`: which directions repeat."""

    file: Optional[str] = None
    others: list = field(default_factory=list)
    inserts: bool = False
    periodic: tuple = (False, False, False)


def particle_source(case, missing=None):
    """The `ParticleSource` of the script of `case` (Dictionaries). Names of included files that are not there, or cannot be told,
    are added to the list `missing`; InputError for them where it is None."""
    script = case.value(COUPLING, "particles/script", '"dem/in.liggghts"').strip('"')
    found = ParticleSource()
    variables = {"weight": case.value(COUPLING, "weight", "1")}
    _follow(case, os.path.normpath(script), variables, found, missing, 0)
    return found


def _follow(case, file, variables, found, missing, depth):
    if depth > 20 or not case.has(file):
        if missing is None:
            raise InputError(f"'{file}', which the script of the particles includes, is not in {case.folder}")
        missing.append(file)
        return
    for line, _, words in commands(case.text(file)):
        words = [_filled(word, variables, case) for word in words]
        command, rest = words[0], words[1:]
        told = f"{file}:{line}: {' '.join(words)}"
        if command == "include" and rest:
            _follow(case, os.path.normpath(rest[0]), variables, found, missing, depth + 1)
        elif command == "variable" and len(rest) > 2 and rest[1] in ("index", "string"):
            variables.setdefault(rest[0], rest[2])
        elif command == "boundary" and len(rest) == 3:
            found.periodic = tuple(kind == "p" for kind in rest)
        elif command == "read_data" and rest:
            if found.file is None:
                found.file = os.path.normpath(rest[0])
            else:
                found.others.append(told)
        elif command in ("create_atoms", "read_restart", "read_dump", "velocity", "displace_atoms", "delete_atoms"):
            found.others.append(told)
        elif command == "if" and re.search(r"\b(create_atoms|read_\w+|velocity|displace_atoms|delete_atoms|include|insert)\b", " ".join(rest)):
            found.others.append(told)  # which of them, its text does not tell
        elif command == "set" and OF_A_PARTICLE & set(rest[2:]):
            found.others.append(told)
        elif command == "fix" and len(rest) > 2 and rest[2].startswith("insert/"):
            found.inserts = True
            found.others.append(told)


def commands(text):
    """(number of the first line, of the last one, words) of each command of a script; `&` at the end of a line goes on in the next."""
    start, before = None, ""
    for number, line in enumerate(text.splitlines(), 1):
        line = before + re.sub(r"#.*", "", line).rstrip()
        start = start or number
        if line.endswith("&"):
            before = line[:-1] + " "
            continue
        if words := line.split():
            yield start, number, [word.strip("\"'") for word in words]
        start, before = None, ""


def _filled(word, variables, case):
    def value(match):
        name = match[1] or match[2]
        written = variables.get(name)
        if written is None:
            written = case.value(COUPLING, f"particles/variables/{name}")
        return match[0] if written is None else written.strip('"')

    return re.sub(r"\$(?:\{(\w+)\}|([A-Za-z]))", value, word)
