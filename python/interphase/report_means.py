# SPDX-License-Identifier: GPL-3.0-or-later
"""All means of a run_report.RunReport at once: what start-up takes from them, and what replicates say of them."""

import dataclasses

from interphase import time_statistics as statistics


def distrust(report, reason):
    """Every mean gets `reason` before its own."""
    _changed(report, lambda mean, _: dataclasses.replace(mean, reason="; ".join(filter(None, (reason, mean.reason)))))


def take_scatter_in(report, parts):
    """The means of a `report` of replicates as one record, by the reports of each of them, `parts`: their errors as time_statistics.of_replicates has them."""
    _changed(report, statistics.of_replicates, parts)


def _changed(report, change, parts=()):
    """Each mean of `report` becomes change(mean, those of `parts`), which are None where a part has none; what is None stays so."""
    def each(means, of_parts):
        return [mean and change(mean, [some[at] if some else None for some in of_parts]) for at, mean in enumerate(means)]

    for depth, profile in report.profiles.items():
        there = [part.profiles.get(depth) for part in parts]
        profile.number = each(profile.number, [of and of.number for of in there])
        profile.temperature = each(profile.temperature, [of and of.temperature for of in there])
        for name in ("velocity", "temperature_of"):
            components = getattr(profile, name)
            components.update({axis: each(means, [of and getattr(of, name)[axis] for of in there]) for axis, means in components.items()})
    for name in ("overlaps", "voidages", "series"):
        known = [{quantity.name: quantity.mean for quantity in getattr(part, name)} for part in parts]
        some = getattr(report, name)
        some[:] = [dataclasses.replace(of, mean=of.mean and change(of.mean, [means.get(of.name) for means in known])) for of in some]
