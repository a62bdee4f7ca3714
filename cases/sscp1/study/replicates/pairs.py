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

from interphase import InputError, replicates, run_sheet
from interphase.time_statistics import error_by_scatter

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


def main(folder):
    pairs = pairs_in(folder)
    print(f"{'':34s} {'TDHS':>10s}  {'DEM - TDHS':>10s}    error")
    for name, _, means in replicates.means_of_parts([sheet for pair in pairs for sheet in pair], DEPTH):
        tdhs, dem = numpy.array([mean.value for mean in means]).reshape(-1, 2).T
        mean, apart, error = tdhs.mean(), (dem - tdhs).mean(), error_by_scatter(dem - tdhs)
        told = "  told apart" if abs(apart) > error * student.isf(0.025, len(pairs) - 1) else ""
        print(f"{name:34s} {mean:10.4g}  {apart:+10.2g} +- {error:.2g}  ({100 * apart / abs(mean):+.1f} +- {100 * error / abs(mean):.1f} %){told}")


if __name__ == "__main__":
    try:
        main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
    except InputError as error:
        sys.exit(f"pairs: error: {error}")
