# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages in Markdown, done as a reader would: their commands, and what they say goes into files."""

import os
import re

FENCE = re.compile(r"^```(\w+)(?: (file|add|in) (\S+))?\n(.*?)^```$", re.M | re.S)

# Not done with a page, as they are, or have, tests of their own: tests/tools/test_setup.py, tests/tools/test_new_plugin.py (which runs what it makes).
ELSEWHERE = r"tools/(test|check|setup)\b|tools/new-plugin|cmake|tools/run ~/bouncy"


def steps(text):
    """[(how, file, words)] of the fenced blocks of a page, in order: `run` commands, `file` whole files, `add` to the end of a file, or `in` a file lines
    that take the place of those that begin with the same word."""
    return [(how or "run", file, words) for language, how, file, words in FENCE.findall(text) if how or language == "sh"]


def put(folder, how, file, words):
    """One such step in the files below `folder`."""
    path = os.path.join(folder, file)
    text = ""
    if how == "in":
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        for line in words.splitlines():
            first = line.split()[0]
            text, found = re.subn(rf"^ *{re.escape(first)}[ ;(].*$", lambda _, line=line: line, text, flags=re.M)
            if found != 1:
                raise ValueError(f"{file} has {found} lines that begin with {first}, and the page changes one")
    with open(path, "a" if how == "add" else "w", encoding="utf-8") as stream:
        stream.write(text if how == "in" else words)


def shortened(line, share):
    """A command with its simulated times, or the second that it runs where none is said, times `share`."""
    def times(found):
        return f"{found[1]}{float(found[2]) * share:.4g}"

    command = re.sub(r" +# .*$", "", line)
    command = re.sub(r"(--until |--time |@)([\d.]+)", times, command)
    if re.match(r"tools/(run|sweep) ", command) and "--until" not in command:
        command += f" --until {share:g}"
    return command
