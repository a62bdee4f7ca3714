# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of tools/, a module each, which runs as a program; and how one is called by name."""

import os
import runpy
import sys

from interphase.missing import words_on


def names():
    """The commands that there are, as they are typed."""
    return sorted(
        file[:-3].replace("_", "-") for file in os.listdir(os.path.dirname(__file__)) if file.endswith(".py") and file[0] != "_"
    )


def main():
    """Run the command that the first word of the command line names, or the script (a path that ends in .py), with the words after it."""
    chosen = sys.argv.pop(1) if len(sys.argv) > 1 else None
    try:
        if chosen in names():
            runpy.run_module(f"interphase.commands.{chosen.replace('-', '_')}", run_name="__main__", alter_sys=True)
        elif chosen and chosen.endswith(".py"):
            sys.argv[0] = chosen
            sys.path.insert(0, os.path.dirname(os.path.realpath(chosen)))  # as `python3 SCRIPT` does
            runpy.run_path(chosen, run_name="__main__")
        else:
            print(f"interphase: {chosen!r} is none of the commands: {', '.join(names())}", file=sys.stderr)
            sys.exit(2)
    except ModuleNotFoundError as missing:
        # Python's own exit code for this, 1, would read as a verdict of tools/compare.
        print(f"{chosen}: {words_on(missing)}", file=sys.stderr)
        sys.exit(2)
