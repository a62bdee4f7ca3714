# SPDX-License-Identifier: GPL-3.0-or-later
"""Read text files of LIGGGHTS's `dump custom`, one time step after the other."""

import glob
import gzip
import io
import os
import re
import warnings
import zlib
from itertools import islice

import numpy

from interphase.input_error import InputError
from interphase.particle_states import Box, Frame, by_id

VECTORS = {
    "velocity": ("vx", "vy", "vz"),
    "spin": ("omegax", "omegay", "omegaz"),
    "force": ("fx", "fy", "fz"),
    "torque": ("tqx", "tqy", "tqz"),
    "angular_momentum": ("angmomx", "angmomy", "angmomz"),
}
# Wrapped, unwrapped, and both in fractions of the box.
POSITIONS = (("x", "y", "z"), ("xu", "yu", "zu"), ("xs", "ys", "zs"), ("xsu", "ysu", "zsu"))
GZIP = b"\x1f\x8b"
DAMAGE = (OSError, EOFError, zlib.error)


def open_text(path):
    """A binary stream of a dump's text, unpacked where it is gzip's."""
    try:
        with open(path, "rb") as stream:
            packed = stream.read(2) == GZIP
        return io.BufferedReader(gzip.open(path), 1 << 20) if packed else open(path, "rb", buffering=1 << 20)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None


def looks_like_dump(path):
    """True if the text begins as a dump's; it may be damaged further on."""
    try:
        with open(path, "rb") as stream:
            start = stream.read(4096)
        if start[:2] == GZIP:
            start = zlib.decompressobj(zlib.MAX_WBITS | 16).decompress(start, 5)
        return start[:5] == b"ITEM:"
    except (OSError, zlib.error):
        return False


class Dump:
    """Dump files as one series of frames with ascending time step.

    `digits` is the most significant digits seen in a number so far, None before the first frame was loaded;
    `text_columns` are the columns that hold no numbers.
    """

    kind = "LIGGGHTS dump"

    def __init__(self, path, files):
        self.path = path
        self.digits = None
        self.text_columns = set()
        self.files = list(files)
        if len(self.files) > 1:
            self.files.sort(key=lambda file: (self._first_step(file), file))

    def describe(self):
        """Path, kind and number of files, for a report."""
        many = "1 file" if len(self.files) == 1 else f"{len(self.files)} files"
        return f"{self.path} ({self.kind}, {many})"

    def _first_step(self, file):
        for frame in self._frames_of(file):
            return frame.step
        raise InputError(f"{file}: holds no time step; take it out of {self.path}")

    def frames(self):
        """`Frame`s in the order of time; only one is in memory."""
        last = None
        for file in self.files:
            for frame in self._frames_of(file):
                if last and frame.step <= last.step:
                    raise InputError(
                        f"{frame.where}: follows {last.where}; time steps must ascend. Several dumps, or the pieces "
                        "of a restarted run, in one? Give the files of one dump, each step once."
                    )
                yield frame
                last = frame

    def _frames_of(self, file):
        with open_text(file) as stream:
            yield from _Reader(file, stream, self).frames()


class _Reader:
    def __init__(self, file, stream, dump):
        self.file, self.stream, self.dump = file, stream, dump
        self.line = 0

    def next_line(self):
        self.line += 1
        try:
            line = self.stream.readline()
        except DAMAGE as error:
            self.fail(f"cannot be read: {error}; the file is damaged")
        return line.decode("utf-8", "replace").rstrip("\r\n")

    def fail(self, message, line=None):
        raise InputError(f"{self.file}, line {line or self.line}: {message}")

    def number(self, kind, what):
        text = self.next_line()
        try:
            return kind(text)
        except ValueError:
            self.fail(f"{what} expected, found {text!r}")

    def frames(self):
        while True:
            heading = self._heading()
            if heading is None:
                return
            step, count, box, columns = heading
            first_line = self.line + 1
            self.line += count
            where = f"{self.file}, timestep {step}"
            loaded = []

            def load():
                loaded.append(True)
                return self._particles(where, first_line, count, box, columns)

            yield Frame(where, step, None, load)
            if not loaded:
                self._lines(where, first_line, count, keep=False)

    def _heading(self):
        """(step, atoms, box, columns) of the next time step, None at the end of the file."""
        step = count = box = None
        while True:
            line = self.next_line()
            if not line:
                if self.stream.readline():
                    self.fail("empty line; a time step's particles must follow each other")
                if step is not None:
                    self.fail(f"the file ends in the heading of timestep {step}: the run was cut short. Delete it.")
                return None
            if not line.startswith("ITEM:"):
                self.fail(f"'ITEM: ...' expected, found {line[:60]!r}: more particles than NUMBER OF ATOMS says?")
            item = line[5:].strip()
            if item == "TIMESTEP":
                step = self.number(int, "a time step")
            elif item == "NUMBER OF ATOMS":
                count = self.number(int, "a number of particles")
                if count < 0:
                    self.fail(f"{count} particles")
            elif item.startswith("BOX BOUNDS"):
                box = self._box(item.split()[2:])
            elif item == "ATOMS" or item.startswith("ATOMS "):
                columns = item.split()[1:]
                for what, value in (("TIMESTEP", step), ("NUMBER OF ATOMS", count)):
                    if value is None:
                        self.fail(f"'ITEM: ATOMS' before 'ITEM: {what}'")
                if "id" not in columns:
                    self.fail(f"no column `id` among: {' '.join(columns) or '(none)'}; particles are matched by it. "
                              "Add `id` to the dump command.")
                return step, count, box, columns
            elif item in ("LABEL", "TIME", "UNITS"):
                self.next_line()
            else:
                self.fail(f"'ITEM: {item}' is not of a dump of particles; give the file of a `dump custom`")

    def _box(self, words):
        if len(words) > 3 or words[:1] == ["xy"]:
            self.fail("a tilted (triclinic) box is not supported")
        bounds = []
        for _ in range(3):
            text = self.next_line()
            try:
                low, high = map(float, text.split())
            except ValueError:
                self.fail(f"two bounds of the box expected, found {text!r}")
            bounds.append((low, high))
        periodic = tuple(word == "pp" for word in words) if len(words) == 3 else (False,) * 3
        return Box(tuple(low for low, _ in bounds), tuple(high - low for low, high in bounds), periodic)

    def _lines(self, where, first_line, count, keep=True):
        lines = islice(self.stream, count)
        try:
            if keep:
                lines = list(lines)
                found = len(lines)
            else:
                found = sum(1 for _ in lines)
        except DAMAGE as error:
            self.fail(f"{where}: cannot be read: {error}; the file is damaged", first_line)
        if found < count:
            self.fail(f"{where}: {count} particles announced, the file ends after {found}: the run was cut short. "
                      "Delete that step.", first_line + found)
        return lines

    def _particles(self, where, first_line, count, box, columns):
        lines = self._lines(where, first_line, count)
        if lines and (self.dump.digits or 0) < 15:
            self.dump.digits = max(self.dump.digits or 0, _digits(lines[:200]))
        table = _table(b"".join(lines), count, len(columns))
        if table is None:
            values = self._by_word(lines, first_line, columns)
        else:
            values = {name: table[:, i] for i, name in enumerate(columns)}
        return by_id(values.pop("id"), self._quantities(values, box), box, where, self._refuse)

    @staticmethod
    def _refuse(message):
        raise InputError(message)

    def _by_word(self, lines, first_line, columns):
        """Columns of numbers where some are text, such as `element`; finds the line at fault otherwise."""
        rows = []
        for number, line in enumerate(lines, first_line):
            words = line.split()
            if len(words) != len(columns):
                text = line.decode("utf-8", "replace").strip()
                wanted = f"{len(columns)} values expected ({' '.join(columns)})"
                self.fail(f"{wanted}, found {len(words)}: {text[:80]!r}", number)
            rows.append(words)
        values = {}
        for i, name in enumerate(columns):
            try:
                values[name] = numpy.array([float(row[i]) for row in rows])
            except ValueError:
                if name in _NUMERIC:
                    for number, row in enumerate(rows, first_line):
                        try:
                            float(row[i])
                        except ValueError:
                            text = row[i].decode("utf-8", "replace")
                            self.fail(f"column {name}: a number expected, found {text!r}", number)
                self.dump.text_columns.add(name)
        return values

    def _quantities(self, values, box):
        quantities = {}
        for names in POSITIONS:
            if "position" in quantities or not all(name in values for name in names):
                continue
            position = numpy.column_stack([values.pop(name) for name in names])
            if names[0].startswith("xs"):
                if box is None:
                    self.fail(f"columns {' '.join(names)} are fractions of a box, and there is no 'ITEM: BOX BOUNDS'")
                position = numpy.array(box.low) + position * numpy.array(box.edges)
            quantities["position"] = position
        for vector, names in VECTORS.items():
            if all(name in values for name in names):
                quantities[vector] = numpy.column_stack([values.pop(name) for name in names])
        if "radius" in values and "diameter" not in values:
            values["diameter"] = 2 * values.pop("radius")  # exact: a power of two
        return quantities | values


_NUMERIC = {"id"} | {name for names in (*POSITIONS, *VECTORS.values()) for name in names} | {"radius", "diameter"}


def _table(data, count, width):
    """Numbers [count, width], each rounded as C's strtod does; None where the text is not such a table."""
    if count == 0:
        return numpy.zeros((0, width))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            numbers = numpy.fromstring(data, sep=" ")
        except (DeprecationWarning, ValueError):
            return None
    return numbers.reshape(count, width) if numbers.size == count * width else None


def _digits(lines):
    """The most significant digits that any number with a decimal point has in `lines`; 0 without one."""
    fractions = re.findall(rb"[0-9]+\.[0-9]*", b" ".join(lines))
    return max((len(word.replace(b".", b"").lstrip(b"0")) for word in fractions), default=0)


def find_dumps(path):
    """The dump files that `path` means: a file, a folder, or a pattern with * ? [ ]. Empty where there are none."""
    if os.path.isfile(path):
        return [path] if looks_like_dump(path) else []
    if os.path.isdir(path):
        names = (os.path.join(path, name) for name in sorted(os.listdir(path)))
    else:
        names = sorted(glob.glob(path))
    return [name for name in names if os.path.isfile(name) and looks_like_dump(name)]
