# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare two records of particles: runs of interphase and native LIGGGHTS dumps, in any pairing."""

import json
import math
import os
import sys

from interphase import comparison, comparison_report, exits
from interphase.command_line import Parser, check_order, number, positive, share
from interphase.comparison import CANNOT
from interphase.difference import Tolerances
from interphase.input_error import InputError

DETAILS = """A and B are each one of
  a run of ours      its folder (particles.h5, results.h5), or one of these two files
  a LIGGGHTS dump    text of `dump custom` with a column id: one file with many steps, a folder of files, or a
                     pattern in quotes ('post/dump*.liggghts'); each may be gzip's. VTK is not read.

Particles are matched by id. Moments are matched by time step between two dumps; by time otherwise, a dump's time
being its step times the solid step, from the attribute solid_step of /meta in the run's results.h5 or --timestep.
Compared are all quantities that both have: position, velocity, spin (omegax..z), force, torque, diameter
(= 2 radius) and other columns of the same name; of two runs also /series/* of results.h5. What only one side has is
listed. Times that only one side has are no difference unless --same-times is given; particles that only one side
has at a common time are one.

Bit-equal means: all these numbers are the same doubles (0 and -0 are not, NaN and NaN are). A dump shows no more
than the digits its format gives; for all of them: dump_modify ID format "%d ... %.17g ...".

The size of a difference of vectors is its length. `relative` is to the quantity's root mean square over both
sides and all that was compared. Where a dump says BOX BOUNDS pp, positions are compared by their nearest image, and
the number of those that needed it is shown: images that agree exactly are equal.

--statistics is for chaotic flows, where two runs part ways whatever one does. Means over time of each series of
results.h5 and of measures of the particle snapshots are compared, z upwards: mean height, kinetic energy per mass, vertical
velocity (mean and quantiles), spin; of five layers the solids in them and how these move up and down; where diameters are
known, too, voidage about the solids (cells of four diameters) and overlaps. The error of a mean takes the autocorrelation in,
by an autoregressive fit (Berk 1974; Thompson, arXiv:1011.0175); the difference is tested by Welch's t with half the degrees of
freedom and half the significance (what the fit adds, measured). --confidence holds for all quantities together (Holm 1979):
one and the same flow is called different with a chance of 1 - confidence at most. `indistinguishable` says no more than that a
difference above `seen from` would have shown.
Quantities whose record is too short, or still drifts, or where no difference below three standard deviations in time would
show, are not judged: run longer, or skip the start-up with --from. If the
ranges of two such records lie wholly apart, the chance of that in one flow is given, 2 in all orders of as many independent
samples as the records are worth; below 5 % they `differ grossly`. Only where the chance is small enough for all quantities
together are the runs called different for it; else the verdict is open. What is constant and the same on both sides
does not count.

exit code:
  0  bit-equal, equal within --tolerance, or statistically indistinguishable
  1  different
  2  cannot be compared: bad input, or nothing in common
  3  --statistics cannot judge: most of what varies is not judged, or ranges lie apart of records too short to be sure; how long about would do is told

examples:
  tools/compare runs/bed post/native.dump --same-times && echo same
  tools/compare 'a/dump*.liggghts' 'b/dump*.liggghts' --tolerance 1e-12 --tolerance force=1e-9
  tools/compare runs/one runs/two --statistics --from 10 --json > difference.json"""


def arguments(given):
    parser = Parser("tools/compare", "A B", description=__doc__, epilog=DETAILS)
    parser.add_argument("a", metavar="A", help="a run or a dump")
    parser.add_argument("b", metavar="B", help="another")
    parser.add_argument(
        "--from", metavar="T", dest="start", type=number,
        help="leave out what is before T [s]; between two dumps without --timestep: a time step",
    )
    parser.add_argument("--until", metavar="T", dest="end", type=number, help="leave out what is after T")
    parser.add_argument("--timestep", metavar="DT", type=positive, help="solid step of the dumps [s]")
    parser.add_argument(
        "--tolerance", metavar="[QUANTITY=]X", action="append", default=[],
        help="allow differences up to X times the quantity's root mean square; may be given again",
    )
    parser.add_argument(
        "--absolute", metavar="[QUANTITY=]X", action="append", default=[],
        help="allow differences up to X in the quantity's unit; with --tolerance, either is enough",
    )
    parser.add_argument(
        "--only", metavar="QUANTITY,...", action="append", default=[],
        help="compare these only, such as position,velocity or series/pressure_drop (`series`: all of them)",
    )
    parser.add_argument("--same-times", action="store_true", help="times that only one side has are a difference")
    parser.add_argument("--statistics", action="store_true", help="compare means over time, for chaotic flows")
    parser.add_argument("--confidence", metavar="C", type=share, help="of --statistics' verdict, between 0 and 1 (default: 0.99)")
    parser.add_argument("--json", action="store_true", help="print everything as JSON, with the largest difference at each time")
    options = parser.parse_args(given)
    check_order(options.start, options.end)
    options.only = [name.strip() for names in options.only for name in names.split(",") if name.strip()]
    options.tolerances = Tolerances(
        absolute=tolerance("--absolute", options.absolute), relative=tolerance("--tolerance", options.tolerance)
    )
    if options.statistics:
        for name in ("tolerance", "absolute", "same_times"):
            if getattr(options, name):
                raise InputError(f"--{name.replace('_', '-')} says nothing to --statistics; leave one of them out")
    elif options.confidence is not None:
        raise InputError("--confidence belongs to --statistics; leave it out, or add --statistics")
    options.confidence = options.confidence or 0.99
    return options


def tolerance(option, texts):
    """{quantity, or "" for all: tolerance}."""
    found = {}
    for text in texts:
        name, _, value = text.rpartition("=")
        try:
            size = float(value)
        except ValueError:
            size = math.nan
        if not 0 <= size < math.inf:
            raise InputError(f"{option} {text}: give X or QUANTITY=X, X a number not below 0")
        found[name.strip()] = size
    return found


def compare(options):
    """(exit code, the report as text or JSON)."""
    a, b = comparison.opened(options.a, "A"), comparison.opened(options.b, "B")
    if options.statistics:
        code, verdict, comparisons, notes, matching = comparison.means(a, b, options)
        report = comparison_report.of_statistics(verdict, a, b, comparisons, notes, options.confidence)
    else:
        code, verdict, difference, matching = comparison.numbers(a, b, options)
        report = comparison_report.of_difference(verdict, a, b, difference, options.tolerances)
    report = {"exit_code": code, **report, "matched_by": matching.by, "solid_step": matching.solid_step}
    if options.json:
        return code, json.dumps(comparison_report.plain(report), indent=2)
    return code, comparison_report.text(report)


def main(given):
    try:
        code, report = compare(arguments(given))
    except InputError as error:
        print(f"tools/compare: {error}", file=sys.stderr)
        if "--json" in given:
            print(json.dumps({"exit_code": CANNOT, "verdict": "cannot be compared", "message": str(error)}, indent=2))
        return CANNOT
    try:
        print(report, flush=True)
    except BrokenPipeError:
        # `tools/compare ... | head`: the exit code still stands.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code


if __name__ == "__main__":
    exits.with_verdict(main, "tools/compare", CANNOT)
