# SPDX-License-Identifier: GPL-3.0-or-later
"""DEM beside TDHS, pair by pair, over the same time from the same bed: what the slugs of that bed do enters neither difference.

    cases/sscp1/study/replicates/pairs [FOLDER]

FOLDER (this one unless given) holds DEM_from-K.sheet.json and TDHS_at-K.sheet.json, as `tools/report RUN --from T --until T --store DIR` writes them: DEM from TDHS's bed at K s,
and TDHS itself over the time that DEM was measured. Means are over the pairs, errors by their scatter; `told apart`: at 95 %, Student's t, quantity by quantity.
"""

import os
import re
import sys

import numpy
from scipy.stats import t as student

from interphase import InputError, run_sheet, trade

DEPTH = "full_depth"
SHEET = re.compile(r"(DEM_from|TDHS_at)-(.+)\.sheet\.json$")


def pairs_in(folder):
    """[(sheet of TDHS, sheet of DEM)] by their beds; InputError where there are not two."""
    found = {}
    for path in run_sheet.stored_in(folder):
        if match := SHEET.search(path):
            found.setdefault(match[2], {})[match[1]] = run_sheet.read(path)
    pairs = [(both["TDHS_at"], both["DEM_from"]) for _, both in sorted(found.items()) if len(both) == 2]
    if len(pairs) < 2:
        raise InputError(f"{folder}: {len(pairs)} pairs of DEM_from-K.sheet.json and TDHS_at-K.sheet.json, two are needed at least")
    return pairs


def rows(pairs):
    """(name, TDHS's mean, difference of DEM, its error, t over its 95 % value) of each quantity, part by part; a root mean square of parts would hide their signs."""
    known = [tuple(trade.quantities(sheet.report, DEPTH) for sheet in pair) for pair in pairs]
    for name, (_, parts) in known[0][0].items():
        for at in range(len(parts)):
            means = [tuple(of[name][1][at] for of in pair) for pair in known if all(name in of for of in pair)]
            if len(means) < len(pairs) or any(mean is None for pair in means for mean in pair):
                continue
            values = numpy.array([[mean.value for mean in pair] for pair in means])
            apart = values[:, 1] - values[:, 0]
            error = apart.std(ddof=1) / len(apart) ** 0.5
            label = name if len(parts) == 1 else f"{name}, {at + 1} of {len(parts)}"
            yield label, values[:, 0].mean(), apart.mean(), error, abs(apart.mean()) / error / student.isf(0.025, len(apart) - 1)


def main(folder):
    print(f"{'':34s} {'TDHS':>10s}  {'DEM - TDHS':>10s}    error")
    for name, mean, apart, error, ratio in rows(pairs_in(folder)):
        print(f"{name:34s} {mean:10.4g}  {apart:+10.2g} +- {error:.2g}  ({100 * apart / abs(mean):+.1f} +- {100 * error / abs(mean):.1f} %){'  told apart' if ratio > 1 else ''}")


if __name__ == "__main__":
    try:
        main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
    except InputError as error:
        sys.exit(f"pairs: error: {error}")
