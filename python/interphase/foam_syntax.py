# SPDX-License-Identifier: GPL-3.0-or-later
"""The tokens and entries of a file in OpenFOAM syntax, each with its place in the text. Macros are not expanded and included files not followed."""

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
    """The number of the line, from 1 on, that holds text[offset]."""
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
