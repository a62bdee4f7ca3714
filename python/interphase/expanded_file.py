# SPDX-License-Identifier: GPL-3.0-or-later
"""A file in OpenFOAM syntax with its macros expanded: `$name` is looked up in the file itself, then in the case's `parameters`."""

import math
import os

from interphase import foam_file
from interphase.case_folder import PARAMETERS
from interphase.foam_file import Dictionary, FoamFileError
from interphase.input_error import InputError


class File:
    """A dictionary with its macros expanded; complaints name the file."""

    def __init__(self, path, parameters=None, block=None):
        """`parameters`: the `File` to look macros up in that this file does not define. No file at all is an empty one.

        `block`: only what that block has, an empty one where there is none. `given`: whether there is a file, with the block.
        """
        self.path, self.parameters = path, parameters
        self.given = os.path.isfile(path)
        if not self.given:
            self.text, self.root = "", foam_file.parse("")
            return
        try:
            with open(path, encoding="utf-8") as stream:
                self.text = stream.read()
            self.root = foam_file.parse(self.text)
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
        except FoamFileError as error:
            raise InputError(f"{path}: {error}") from None
        if block is not None:
            found = [entry for entry in self.root.all_named(block) if isinstance(entry, Dictionary)]
            self.given = bool(found)
            self.root = found[0] if found else foam_file.parse("")

    def complaint(self, name, message):
        """The InputError that names file, line and entry."""
        entry = self.entry(name)
        known = entry is not None and not isinstance(entry, Dictionary)
        line = f", line {foam_file.line_of(self.text, entry.start)}" if known else ""
        return InputError(f"{self.path}{line}: {name} {message}")

    def entry(self, name):
        """The Entry or Dictionary at `name`, nested by `/`; None where there is none."""
        level = self.root
        for part in name.split("/"):
            found = level.all_named(part) if isinstance(level, Dictionary) else []
            if not found:
                return None
            level = found[0]
        return level

    def words(self, name, depth=0):
        """The words of the value at `name`, macros expanded; None where there is none."""
        entry = self.entry(name)
        if entry is None or isinstance(entry, Dictionary):
            return None
        found = []
        for token in foam_file.tokens(entry.value):
            if not token.text.startswith("$"):
                found.append(token.text)
                continue
            macro = token.text.lstrip("$:.").strip("{}")
            words = None
            if depth < 10:
                words = self.words(macro, depth + 1)
                if words is None and self.parameters is not None:
                    words = self.parameters.words(macro, depth + 1)
            if words is None:
                where = f" or {self.parameters.path}" if self.parameters is not None else ""
                raise self.complaint(name, f"= {entry.value}: {token.text} is not in this file{where}")
            found += words
        return found

    def number(self, name, default=None):
        """The number at `name`, else `default`; InputError where there is neither."""
        words = self.words(name)
        if words is None:
            if default is None:
                raise InputError(f"{self.path}: no entry {name}: add one")
            return default
        try:
            value = float(words[0]) if len(words) == 1 else math.nan
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise self.complaint(name, f"= {' '.join(words)}: one number is expected")
        return value

    def whole(self, name, default=None):
        """The same, a whole number above 0."""
        value = self.number(name, default)
        if value != int(value) or value < 1:
            raise self.complaint(name, f"= {value:g}: a whole number above 0 is expected")
        return int(value)

    def numbers(self, name, count=None, default=None):
        """A list `(a b ...)` of numbers, `count` of them if given."""
        words = self.words(name)
        if words is None and default is not None:
            return default
        if words is None:
            raise InputError(f"{self.path}: no entry {name}: add one")
        try:
            if words[:1] != ["("] or words[-1:] != [")"]:
                raise ValueError
            values = tuple(float(word) for word in words[1:-1])
        except ValueError:
            values = (math.nan,)
        if not all(map(math.isfinite, values)) or (count is not None and len(values) != count):
            many = f"{count} numbers" if count else "numbers"
            raise self.complaint(name, f"= {' '.join(words)}: a list of {many} in parentheses is expected")
        return values

    def ascending(self, name, default):
        """The list at `name`, else `default`; InputError where it does not ascend."""
        values = self.numbers(name, default=default)
        if any(later <= earlier for earlier, later in zip(values, values[1:])):
            raise self.complaint(name, f"= {values}: values must ascend")
        return values

    def refuse_unknown(self, known):
        """InputError for an entry that is not among `known` {block: {key: ...}}, block "" the file itself, or is a block where it should be none."""
        for block, keys in known.items():
            level = self.entry(block) if block else self.root
            for key in level.names() if isinstance(level, Dictionary) else ():
                name = f"{block}/{key}" if block else key
                if name == "FoamFile":
                    continue
                if key not in keys:
                    raise self.complaint(name, f"is unknown: {foam_file.nearest(key, keys)}")
                if name in known and self.words(name) == ["none"]:
                    continue
                if isinstance(self.entry(name), Dictionary) != (name in known):
                    wanted = "a block { ... } or `none`" if name in known else "a value, not a block"
                    raise self.complaint(name, f"must be {wanted}")


def parameters_of(folder):
    """The case's `parameters`, None where there are none."""
    path = os.path.join(folder, PARAMETERS)
    return File(path) if os.path.isfile(path) else None
