# SPDX-License-Identifier: GPL-3.0-or-later
"""What a test measures: held within its limit and, where tools/test --record asks for it, written down for tests/VALIDATION.md.

Each function asserts, and records the number and the limit that it asserts by. `quantity` says what was measured, in which scene;
`source` where the right value is from (a paper, a closed solution, another program); `error` is a standard error of the value; a unit
of "" is a pure number. tests/support/measured.hpp is the same for C++.
"""

import csv
import os

COLUMNS = ("quantity", "value", "error", "unit", "reference", "source", "limit")


def within(test, quantity, value, reference, limit, unit="", source="", error=None):
    """|value - reference| is at most `limit`, all in `unit`."""
    _record(quantity, value, error, unit, reference, source, f"+-{float(limit)!r}")
    test.assertLessEqual(abs(value - reference), limit, f"{quantity}: {value:.6g} {unit}, {reference:.6g} by {source}")


def below(test, quantity, value, limit, unit="", source="", error=None):
    _record(quantity, value, error, unit, None, source, f"<{float(limit)!r}")
    test.assertLess(value, limit, f"{quantity} [{unit}]")


def above(test, quantity, value, limit, unit="", source="", error=None):
    _record(quantity, value, error, unit, None, source, f">{float(limit)!r}")
    test.assertGreater(value, limit, f"{quantity} [{unit}]")


def _record(quantity, value, error, unit, reference, source, limit):
    """A row in the file of the test that is running, in the folder that tools/test --record made."""
    folder, name = os.environ.get("INTERPHASE_MEASURED"), os.environ.get("INTERPHASE_TEST")
    if not folder or not name:
        return
    numbers = ["" if x is None else repr(float(x)) for x in (value, error, reference)]
    with open(os.path.join(folder, name.replace("/", ".") + ".csv"), "a", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerow([quantity, numbers[0], numbers[1], unit, numbers[2], source, limit])
