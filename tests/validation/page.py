#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tests/VALIDATION.md, made of page.md and the tables beside this file. tools/test --record renews the tables.

A table is what one test measured (<test's name, . for />.csv, columns as in tests/program/measured.py and `command`), or what was measured
once by a command that takes too long for a test (earlier.<name>.csv). Its first lines say when, by which program, where. A line of page.md
{{ NAME ... }} is the place of tables; what no line names is not kept.
"""

import argparse
import csv
import datetime
import os
import platform
import re
import subprocess

from interphase import tables

HERE = os.path.dirname(os.path.realpath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
BUILD = os.environ.get("INTERPHASE_BUILD") or os.path.join(SOURCE, "build", "release")
PAGE = os.path.join(SOURCE, "tests", "VALIDATION.md")
COLUMNS = ("quantity", "value", "error", "unit", "reference", "source", "limit", "command")
PLACE = re.compile(r"^\{\{(.*)\}\}$", re.M)


def template():
    with open(os.path.join(HERE, "page.md"), encoding="utf-8") as file:
        return file.read()


def names():
    """Tables in the order of the page."""
    return [name for place in PLACE.findall(template()) for name in place.split()]


def tests():
    """Names of the tests that the page shows, as ctest has them."""
    return [name for name in names() if not name.startswith("earlier.")]


def path(name):
    return os.path.join(HERE, name.replace("/", ".") + ".csv")


def read(name):
    """(lines of its head, rows as dicts of texts); none of a test that is not recorded yet."""
    if not os.path.exists(path(name)):
        return [], []
    with open(path(name), encoding="utf-8", newline="") as file:
        lines = file.readlines()
    head = [line[2:].strip() for line in lines if line.startswith("# ")]
    return head, list(csv.DictReader(line for line in lines if not line.startswith("# ")))


def within(row):
    """Whether the value lies within the limit; True where there is none."""
    value, limit = float(row["value"]), row["limit"]
    if limit.startswith("+-"):
        return abs(value - float(row["reference"])) <= float(limit[2:])
    return not limit or (value < float(limit[1:]) if limit[0] == "<" else value > float(limit[1:]))


def _shown(row):
    unit = f" {row['unit']}" if row["unit"] else ""
    digits = ".5g" if row["reference"] else ".3g"
    value = f"{float(row['value']):{digits}}" + (f" +- {float(row['error']):.2g}" if row["error"] else "") + unit
    reference = f"{float(row['reference']):{digits}}{unit}" if row["reference"] else ""
    limit = re.sub(r"^(\+-|[<>])(.*)$", lambda found: f"{found[1]} {float(found[2]):.3g}{unit}", row["limit"])
    return [row["quantity"], value, reference, limit, row["source"], f"`{row['command']}`"]


def _tables(place):
    found = [read(name) for name in place[1].split()]
    rows = [tables.markdown_row(cell.replace("<", "\\<") for cell in _shown(row)) for _, rows in found for row in rows]
    heads = dict.fromkeys("; ".join(head) for head, _ in found if head)
    return "\n".join([tables.markdown_head(["what", "measured", "reference", "the test allows", "source", "command"]), *rows, "",
                      *(f"*{head}.*  " for head in heads)])  # fmt: skip


def text():
    return PLACE.sub(_tables, template())


def _command(name):
    """That runs the test; its folder, ranks and the ending of its file are left away."""
    source = os.path.join(SOURCE, "tests", name + ".py")
    slow = ""
    if os.path.exists(source):
        with open(source, encoding="utf-8") as file:
            slow = "--slow " if re.search(r"^# label: slow$", file.read(), re.M) else ""
    return f"tools/test {slow}--filter {re.sub(r'(_mpi)?_test([.]np[0-9]+)?$', '', name.split('/')[-1])}"


def _head():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        flags = file.read().split()
    sets = [f" with {name}" for name, flag in (("AVX-512", "avx512f"), ("AVX2", "avx2"), ("AVX", "avx"), ("SSE2", "sse2")) if flag in flags]
    program = subprocess.run([os.path.join(BUILD, "interphase"), "-version"], capture_output=True, text=True, check=True).stdout
    program = re.sub(r"\b([0-9a-f]{10})[0-9a-f]{30}\b", r"\1", program.splitlines()[0])
    return [datetime.date.today().isoformat(), program, f"{platform.machine()}{''.join(sets[:1])}, {os.cpu_count()} cores"]


def store(folder):
    """Keep what tests of the page have left in `folder`, and write the page."""
    head = _head()
    for name in tests():
        source = os.path.join(folder, name.replace("/", ".") + ".csv")
        if not os.path.exists(source):
            continue
        with open(source, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        with open(path(name), "w", encoding="utf-8", newline="") as file:
            file.writelines(f"# {line}\n" for line in head)
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *(row + [_command(name)] for row in rows)])
        print(f"{len(rows):4d} rows of {name}")
    write()


def write():
    whole = text()
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(whole)


def main():
    parser = argparse.ArgumentParser(prog="page.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tests", action="store_true", help="print a regular expression of the tests that the page shows")
    parser.add_argument("--store", metavar="DIR", help="keep what tests have left in DIR (INTERPHASE_MEASURED)")
    parser.add_argument("--write", action="store_true", help="the page from the tables as they are")
    given = parser.parse_args()
    if given.tests:
        print("^(" + "|".join(re.escape(name) for name in tests()) + ")$")
    if given.store:
        store(given.store)
    if given.write:
        write()


if __name__ == "__main__":
    main()
