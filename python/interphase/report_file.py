# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a run's statistics into its results.h5, below /profiles and /histograms; only where the run has ended."""

import glob
import math
import os

import h5py
import numpy

from interphase import spectrum
from interphase.input_error import InputError
from interphase.stored import attributes, below


def open_elsewhere(path):
    """Id of another process of this machine that has the file at `path` open, None if none is seen.

    The HDF5 library that goes with MPI takes no lock on its files, so that a lock would not tell.
    """
    file = os.stat(path)
    for descriptor in glob.iglob("/proc/[0-9]*/fd/*"):
        process = int(descriptor.split("/")[2])
        try:
            other = os.stat(descriptor)
        except OSError:  # closed in the meantime, or another user's
            continue
        if process != os.getpid() and (other.st_dev, other.st_ino) == (file.st_dev, file.st_ino):
            return process
    return None


def has_ended(run):
    """Whether `Records` hold the run's end: wall_time in /meta (the program), or an exit code in run.json (tools/run)."""
    return "wall_time" in run.meta or "exit_code" in run.record


def check_writable(run):
    """InputError unless the results.h5 of `Records` can be written to."""
    if run.results is None:
        raise InputError(f"{run.path}: there is no results.h5 in it to write to; --no-write reports without writing")
    process = open_elsewhere(run.results)
    if process is not None:
        raise InputError(
            f"{run.results}: process {process} has it open: the run is still going, and nothing is written into its file; "
            "wait for its end, or see what is there so far by --no-write"
        )
    if not has_ended(run):
        raise InputError(
            f"{run.results}: the run has not recorded its end: it is still going, or was killed; --no-write reports "
            "without writing"
        )
    _open(run.results).close()


def _open(path):
    try:
        return h5py.File(path, "r+")
    except OSError as error:
        raise InputError(
            f"{path}: cannot be opened for writing: {error}; was the run killed, or may you not write there? --no-write "
            "leaves it alone"
        ) from None


GROUPS = ("profiles", "histograms")


def write(run, scene, report):
    """Add or replace the groups of this report; everything else in the file stays."""
    with _open(run.results) as file:
        fill(file, scene, report)


def kept(run):
    """{path: Stored} of what `write` has put into the results.h5 of `Records`; {} where it has not, or the run has gone on since."""
    if run.results is None or attributes(run.results, GROUPS[0]).get("recorded_until") != run.last_time():
        return {}
    return below(run.results, GROUPS)


def fill(file, scene, report):
    """The same of an open file."""
    profiles, histograms = map(file.require_group, GROUPS)
    for group in (profiles, histograms):
        group.attrs["from"], group.attrs["until"] = report.first, report.last
        group.attrs["snapshots"], group.attrs["recorded_until"] = report.snapshots, report.recorded
    _fresh(profiles, "front_slice", "full_depth", "window_centre", "pressure_spectrum", "means")
    _fresh(histograms, "overlap", "voidage")
    if report.windows is not None:
        _data(profiles, "window_centre", report.windows, "m")
        for depth, profile in report.profiles.items():
            _profile(profiles.create_group(depth), profile)
    if report.series:
        group = profiles.create_group("means")
        for quantity in report.series:
            name = quantity.name.replace(",", "").replace(" ", "_")
            attributes = _data(group, name, quantity.mean.value, quantity.unit).attrs
            attributes["error"], attributes["trusted"] = quantity.mean.error, int(not quantity.mean.reason)
    if report.spectrum is not None:
        group = profiles.create_group("pressure_spectrum")
        _data(group, "frequency", report.spectrum.frequency, "Hz")
        for name, values in (("power_density", report.spectrum.power), ("low", report.spectrum.low), ("high", report.spectrum.high)):
            _data(group, name, values, "Pa2/Hz")
        group.attrs["resolution"], group.attrs["coverage"] = report.spectrum.resolution, spectrum.COVERAGE
    if report.overlaps:
        _overlaps(histograms.create_group("overlap"), scene.overlaps, report)
    if report.voidages:
        group = histograms.create_group("voidage")
        _histogram(group, report.voidage)
        _data(group, "limits", scene.voidage.limits, "1")
        _means(group, "share_between_limits", [quantity.mean for quantity in report.voidages], "1")


def _fresh(group, *names):
    for name in names:
        if name in group:
            del group[name]


def _data(group, name, values, unit):
    group[name] = numpy.asarray(values, dtype=float)
    group[name].attrs["unit"] = unit
    return group[name]


def _means(group, name, means, unit):
    """Values and, under the name with `_error`, their standard errors; NaN: there is none.

    The attribute `trusted` of the errors is 0 where the record is too short, or drifts.
    """
    _data(group, name, [math.nan if mean is None else mean.value for mean in means], unit)
    errors = _data(group, f"{name}_error", [math.nan if mean is None else mean.error for mean in means], unit)
    errors.attrs["trusted"] = [int(mean is not None and not mean.reason) for mean in means]


def _profile(group, profile):
    _means(group, "number", profile.number, "1")
    for component, means in profile.velocity.items():
        _means(group, f"{component}_velocity", means, "m/s")
    _means(group, "granular_temperature", profile.temperature, "m2/s2")
    for component, means in profile.temperature_of.items():
        _means(group, f"granular_temperature_{component}", means, "m2/s2")


def _histogram(group, histogram):
    _data(group, "edges", histogram.edges, "1")
    _data(group, "share", histogram.share, "1")
    if not numpy.isnan(histogram.error).all():
        _data(group, "share_error", histogram.error, "1")
    group.attrs["share_below_edges"], group.attrs["share_above_edges"] = histogram.below, histogram.above


def _overlaps(group, wanted, report):
    means = [quantity.mean for quantity in report.overlaps]
    shares, percentiles, pairs = means[:len(wanted.shares)], means[len(wanted.shares):-1], means[-1:]
    group.attrs["normalised_by"] = "diameter of the smaller sphere of a pair"
    if report.overlap is not None:
        _histogram(group, report.overlap)
        _data(group, "cumulative", report.overlap.share.cumsum(), "1")
    _data(group, "limits", wanted.shares, "1")
    _means(group, "share_below_limits", shares, "1")
    _data(group, "percentile_levels", wanted.percentiles, "%")
    _means(group, "percentiles", percentiles, "1")
    _means(group, "pairs_per_sphere", pairs, "1")
    _data(group, "largest", report.largest_overlap, "1")
