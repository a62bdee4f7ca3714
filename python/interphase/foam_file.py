# SPDX-License-Identifier: GPL-3.0-or-later
"""Read, replace and add single entries of a file in OpenFOAM syntax, leaving every other byte as it is.

OpenFOAM's own `foamDictionary` rewrites the whole file: comments and layout go, `$macros` and
`#include` are expanded. A run's copy of a case should still look like the case, so entries are
replaced here by their place in the text.

An entry is named by its path, nested by `/`: `drag/law`, `solvers/"(U|k)"/tolerance`. The quotes of a
pattern may be left out. Where a dictionary holds a key twice, the later one counts, as in OpenFOAM.
Macros are not expanded and included files are not followed.
"""

import difflib
import re
from dataclasses import dataclass, field
from typing import Optional

from interphase.input_error import InputError


class FoamFileError(InputError):
    """Something in the file, or asked of it, is wrong; the message is meant for the user."""


@dataclass(frozen=True)
class Token:
    """A piece of text: kind is word, string, verbatim or punctuation; text[start:end] is it."""

    kind: str
    text: str
    start: int
    end: int


@dataclass
class Entry:
    """A `key value;` entry: text[start:end] of the file is the value, without the semicolon."""

    key: str
    start: int
    end: int
    value: str


@dataclass
class Dictionary:
    """A `key { ... }` entry, or the file itself (key empty). `close` is the place of its closing brace; None of the file."""

    key: str
    entries: list = field(default_factory=list)
    close: Optional[int] = None

    def names(self):
        """Keys in the order of the file, each once."""
        return list(dict.fromkeys(entry.key for entry in self.entries))

    def all_named(self, key):
        """Entries called `key`, the one that counts first."""
        return [e for e in reversed(self.entries) if unquoted(e.key) == unquoted(key)]


PUNCTUATION = "{}()[];"


def unquoted(text):
    """`"p.*"` -> `p.*`; anything else as it is."""
    return text[1:-1] if len(text) >= 2 and text[0] == text[-1] == '"' else text


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def _macro_end(text, start):
    """The place of the brace that closes the `${` at `start`; names may be made of others: `${${mode}Inlet}`."""
    depth = 0
    for brace in re.finditer(r"[{}]", text[start:]):
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            return start + brace.start()
    raise FoamFileError(f"line {line_of(text, start)}: '${{' without '}}'")


def _word_end(text, start):
    """Where the word that starts at `start` ends.

    A word may hold balanced parentheses, `div(phi,U)`, and braces after a dollar, `${name}`; in a number
    a parenthesis starts a list, `3(1 2 3)`.
    """
    starts_number = text[start].isdigit() or text[start] in "+-."
    open_at = []
    at = start
    while at < len(text):
        char = text[at]
        if char == "$" and text[at + 1 : at + 2] == "{":
            at = _macro_end(text, at)
        elif char == "(" and not starts_number:
            open_at.append(at)
        elif char == ")" and open_at:
            open_at.pop()
        elif char.isspace() or char in '{}[];"()' or text.startswith(("//", "/*"), at):
            break
        at += 1
    return open_at[0] if open_at else at


def tokens(text):
    """Split `text`, yielding Tokens; comments and white space are passed over."""
    at = 0
    while at < len(text):
        char = text[at]
        if char.isspace():
            at += 1
            continue
        if text.startswith("//", at):
            newline = text.find("\n", at)
            at = len(text) if newline < 0 else newline
            continue
        if text.startswith("/*", at):
            close = text.find("*/", at + 2)
            if close < 0:
                raise FoamFileError(f"line {line_of(text, at)}: comment /* without */")
            at = close + 2
            continue
        start = at
        if char == '"':
            at += 1
            while at < len(text) and text[at] != '"':
                at += 2 if text[at] == "\\" else 1
            if at >= len(text):
                raise FoamFileError(f"line {line_of(text, start)}: string without closing quote")
            at += 1
            kind = "string"
        elif text.startswith("#{", at):
            close = text.find("#}", at)
            if close < 0:
                raise FoamFileError(f"line {line_of(text, start)}: #{{ without #}}")
            at = close + 2
            kind = "verbatim"
        elif char in PUNCTUATION:
            at += 1
            kind = "punctuation"
        else:
            # `#eval{ ... }`: the word ends at the brace, whose contents are read as tokens.
            at = max(_word_end(text, at), at + 1)
            kind = "word"
        yield Token(kind, text[start:at], start, at)


class _Reader:
    """Recursive descent over the tokens of one file."""

    CLOSES = {"{": "}", "(": ")", "[": "]"}

    def __init__(self, text):
        self.text = text
        self.tokens = list(tokens(text))
        self.at = 0

    def where(self, token):
        return f"line {line_of(self.text, token.start)}"

    def dictionary(self, key, opening=None):
        result = Dictionary(key)
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token.text == "}" and token.kind == "punctuation":
                if opening is None:
                    raise FoamFileError(f"{self.where(token)}: '}}' closes nothing")
                self.at += 1
                result.close = token.start
                return result
            if token.text == ";":
                self.at += 1
            elif token.text.startswith("#") and token.kind == "word":
                self.skip_directive(token)
            elif token.text == "(":
                self.skip_brackets()  # a nameless list, as in constant/polyMesh/boundary
            else:
                result.entries.append(self.entry())
        if opening is not None:
            raise FoamFileError(f"{self.where(opening)}: '{{' of '{key}' is never closed")
        return result

    def skip_directive(self, token):
        """`#include "file"` and its kin end with their line."""
        newline = self.text.find("\n", token.start)
        end = len(self.text) if newline < 0 else newline
        while self.at < len(self.tokens) and self.tokens[self.at].start < end:
            self.at += 1

    def skip_brackets(self):
        opening = self.tokens[self.at]
        expected = [self.CLOSES[opening.text]]
        self.at += 1
        while expected:
            if self.at >= len(self.tokens):
                raise FoamFileError(f"{self.where(opening)}: '{opening.text}' is never closed")
            token = self.tokens[self.at]
            if token.kind == "punctuation" and token.text in self.CLOSES:
                expected.append(self.CLOSES[token.text])
            elif token.kind == "punctuation" and token.text in self.CLOSES.values():
                if token.text != expected.pop():
                    raise FoamFileError(f"{self.where(token)}: '{token.text}' does not match")
            self.at += 1

    def entry(self):
        key = self.tokens[self.at]
        if key.kind == "punctuation":
            raise FoamFileError(f"{self.where(key)}: '{key.text}' where a key was expected")
        self.at += 1
        if key.text.startswith("$"):  # takes in a dictionary; OpenFOAM wants no semicolon behind it
            return Entry(key.text, key.end, key.end, "")
        if self.at < len(self.tokens) and self.tokens[self.at].text == "{":
            opening = self.tokens[self.at]
            self.at += 1
            return self.dictionary(key.text, opening)
        first = self.at
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token.kind == "punctuation" and token.text == ";":
                last = self.tokens[self.at - 1]
                self.at += 1
                start = self.tokens[first].start if first < self.at - 1 else key.end
                end = last.end if first < self.at - 1 else key.end
                return Entry(key.text, start, end, self.text[start:end])
            if token.kind == "punctuation" and token.text in self.CLOSES:
                self.skip_brackets()
            elif token.kind == "punctuation":
                break
            else:
                self.at += 1
        raise FoamFileError(f"{self.where(key)}: entry '{key.text}' does not end with ';'")


def parse(text):
    """The entries of `text` as a Dictionary; FoamFileError with the line where it is no OpenFOAM syntax."""
    return _Reader(text).dictionary("")


def split_path(path):
    """`a/"b/c"/d` -> [`a`, `"b/c"`, `d`]."""
    parts, part, quoted = [], "", False
    for char in path:
        quoted ^= char == '"'
        if char == "/" and not quoted:
            parts.append(part)
            part = ""
        else:
            part += char
    parts.append(part)
    if quoted or not all(parts):
        raise FoamFileError(f"'{path}' is no name of an entry (names nested by '/')")
    return parts


def nearest(name, valid):
    """What a user may have meant by `name`: a phrase to append to a message, never empty.

    The near ones when there are any, else all (at most 40).
    """
    valid = list(dict.fromkeys(valid))
    by_lower = {v.lower(): v for v in reversed(valid)}
    close = [by_lower[n] for n in difflib.get_close_matches(name.lower(), by_lower, n=3, cutoff=0.55)]
    if close:
        return "did you mean " + " or ".join(f"'{c}'" for c in close) + "?"
    if not valid:
        return "there are no entries"
    more = f" ... ({len(valid) - 40} more)" if len(valid) > 40 else ""
    return "valid names: " + ", ".join(valid[:40]) + more


def _find_all(dictionary, parts):
    """Everything at this path, what counts first."""
    found = dictionary.all_named(parts[0])
    if len(parts) == 1:
        return found
    below = [e for e in found if isinstance(e, Dictionary)]
    return [hit for d in below for hit in _find_all(d, parts[1:])]


def _explain_missing(root, parts):
    """Why nothing is at this path, with the nearest names at the level where it breaks off."""
    level = [root]
    for depth, part in enumerate(parts):
        found = [e for d in level for e in d.all_named(part)]
        above = "/".join(parts[:depth])
        if not found:
            names = [unquoted(n) for d in level for n in d.names()]
            inside = f" in '{above}'" if above else ""
            return f"no entry '{part}'{inside}: {nearest(part, names)}"
        level = [e for e in found if isinstance(e, Dictionary)]
        if not level:
            return f"'{'/'.join(parts[: depth + 1])}' is a value, it holds no entry '{'/'.join(parts[depth + 1:])}'"
    raise AssertionError("nothing is missing")


def find(text, path):
    """The Entry or Dictionary at `path`; FoamFileError that names the nearest ones otherwise."""
    root = parse(text)
    parts = split_path(path)
    found = _find_all(root, parts)
    if not found:
        raise FoamFileError(_explain_missing(root, parts))
    return found[0]


def holds(text, path):
    """Whether there is an entry or a dictionary at `path`."""
    return bool(_find_all(parse(text), split_path(path)))


def paths(text):
    """The paths of all values, nested by `/`, in the order of the text; macros and included files apart."""
    def below(dictionary, above):
        for entry in dictionary.entries:
            if isinstance(entry, Dictionary):
                yield from below(entry, f"{above}{entry.key}/")
            elif not entry.key.startswith("$"):
                yield above + entry.key
    return list(dict.fromkeys(below(parse(text), "")))


def value(text, path, default=None):
    """The value at `path` as it is written, or `default` where there is none."""
    found = _find_all(parse(text), split_path(path))
    return found[0].value if found and isinstance(found[0], Entry) else default


def check_value(new_value):
    """FoamFileError unless `new_value` can stand as the one value of an entry."""
    try:
        written = parse(f"key {new_value};").entries
    except FoamFileError:
        raise FoamFileError(f"'{new_value}' is no single value") from None
    one = len(written) == 1 and isinstance(written[0], Entry) and written[0].key == "key"
    if not one or not written[0].value or written[0].value != new_value.strip():
        raise FoamFileError(f"'{new_value}' is no single value")


def replaced(text, path, new_value):
    """`text` with the value at `path` replaced; comments and layout stay."""
    entry = find(text, path)
    if isinstance(entry, Dictionary):
        names = ", ".join(entry.names())
        raise FoamFileError(f"'{path}' is a dictionary; set one of its entries: {names}")
    check_value(new_value)
    gap = " " if entry.start == entry.end else ""
    return text[: entry.start] + gap + new_value.strip() + text[entry.end :]


def added(text, path, new_value):
    """`text` with an entry at `path` that is not there yet, behind those that are, in the dictionaries that are there and new ones
    where there are none; comments and layout stay."""
    check_value(new_value)
    level, parts = parse(text), split_path(path)
    if _find_all(level, parts):
        raise FoamFileError(f"'{path}' is there already")
    depth = 0
    while depth < len(parts) - 1 and (found := level.all_named(parts[depth])):
        if not isinstance(found[0], Dictionary):
            raise FoamFileError(_explain_missing(level, parts[depth:]))
        level, depth = found[0], depth + 1
    new = f"{parts[-1]} {new_value.strip()};"
    for name in reversed(parts[depth:-1]):
        new = f"{name} {{ {new} }}"
    if level.close is None:
        return text + ("" if text.endswith("\n") or not text else "\n") + new + "\n"
    line = text.rfind("\n", 0, level.close) + 1
    if text[line : level.close].strip():  # the dictionary closes on the line of its last entry
        gap = "" if text[level.close - 1].isspace() else " "
        return text[: level.close] + gap + new + " " + text[level.close :]
    return text[:line] + text[line : level.close] + "    " + new + "\n" + text[line:]
