# SPDX-License-Identifier: GPL-3.0-or-later
"""Words of a command line as the numbers they are for argparse, with one message where they are none."""

import argparse
import math

from interphase.input_error import InputError


class Parser(argparse.ArgumentParser):
    """One whose mistakes are InputErrors, so that a command says everything in one way; `brief`: what stands behind `prog` without options."""

    def __init__(self, prog, brief, **more):
        super().__init__(prog=prog, formatter_class=argparse.RawDescriptionHelpFormatter, **more)
        self._brief = brief

    def error(self, message):
        raise InputError(f"{message}. Usage: {self.prog} {self._brief} [options]; see --help")


def _reader(kind, holds, what):
    def read(text):
        try:
            value = kind(text)
        except ValueError:
            value = None
        if value is None or not math.isfinite(value) or not holds(value):
            raise argparse.ArgumentTypeError(f"{text!r} is not {what}")
        return value

    return read


number = _reader(float, lambda value: True, "a number")
positive = _reader(float, lambda value: value > 0, "a number above 0")
time = _reader(float, lambda value: value >= 0, "a time in s, 0 or above")
end_time = _reader(float, lambda value: value > 0, "a time in s, above 0")
share = _reader(float, lambda value: 0 < value < 1, "a number between 0 and 1, such as 0.95")
count = _reader(int, lambda value: value >= 1, "a whole number above 0")


def check_order(start, end):
    """InputError where --from is after --until [s]; None: not given."""
    if start is not None and end is not None and start > end:
        raise InputError(f"--from {start:g} is after --until {end:g}: nothing is left in between")
