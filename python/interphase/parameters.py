# SPDX-License-Identifier: GPL-3.0-or-later
"""The values of a file in OpenFOAM syntax as texts and numbers, such as a case's `parameters`. Comments are no part of them."""

import re

from interphase import foam_file
from interphase.input_error import InputError

PARAMETERS = "parameters"


def plain(value):
    """The text of a value on one line, without comments: `(15 /* across */ 1 45)` -> `(15 1 45)`."""
    text, end = "", None
    for token in foam_file.tokens(value):
        text += (" " if end is not None and token.start > end and text[-1] not in "([" and token.text not in ")]" else "") + token.text
        end = token.end
    return text


def values_of(text):
    """{name: text of the value, or the same of a dictionary} of all entries; of a name that is there twice the last one counts, as
    in OpenFOAM. FoamFileError with the line where it is no OpenFOAM syntax."""
    return _entries(foam_file.parse(text))


def _entries(dictionary):
    return {foam_file.unquoted(entry.key): _entries(entry) if isinstance(entry, foam_file.Dictionary) else plain(entry.value)
            for entry in dictionary.entries}  # fmt: skip


def read(path):
    """`values_of` the file at `path`; InputError where it cannot be read."""
    try:
        with open(path, encoding="utf-8") as stream:
            return values_of(stream.read())
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    except foam_file.FoamFileError as error:
        raise InputError(f"{path}: {error}") from None


def numbers(text):
    """A value as a number, or a list as a tuple of what is in it, lists in lists too: `(15 1 45)` -> (15.0, 1.0, 45.0). What is no
    number stays text."""
    stack = [[]]
    for word in re.findall(r"[()]|[^()\s]+", text):
        if word == "(":
            stack.append([])
        elif word == ")" and len(stack) > 1:
            done = tuple(stack.pop())
            stack[-1].append(done)
        else:
            stack[-1].append(_number(word))
    found = stack[0]
    return found[0] if len(stack) == 1 and len(found) == 1 else text


def _number(word):
    try:
        return float(word)
    except ValueError:
        return word
