# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of /statistics in results.h5, which a run takes itself: what tools/report makes means of without reading a snapshot."""

from dataclasses import dataclass

import h5py
import numpy

from interphase.input_error import InputError
from interphase.report_scene import Overlaps, Scene, Voidage, Windows
from interphase.stored import open_h5, word
from interphase.whole_records import whole_rows

GROUP = "statistics"
DEPTHS = ("front_slice", "full_depth")


@dataclass(frozen=True)
class StatisticsRows:
    """`time` [n, s]; `columns` {name: [n] or [n, k]}; `scene`: the attributes that say what was sampled."""

    path: str
    time: numpy.ndarray
    columns: dict
    scene: dict

    def __getitem__(self, name):
        return self.columns[name]

    def __contains__(self, name):
        return name in self.columns


def statistics_rows(run):
    """The `StatisticsRows` of `Records`, None where the run took none."""
    if run.results is None:
        return None
    with open_h5(run.results) as file:
        if GROUP not in file or "time" not in file[GROUP]:
            return None
        group = file[GROUP]
        count = whole_rows(group)
        columns = {name: data[:count] for name, data in group.items() if isinstance(data, h5py.Dataset)}
        time = columns.pop("time")
        if not len(time):
            return None
        if not numpy.isfinite(time).all() or not (numpy.diff(time) > 0).all():
            raise InputError(f"{run.results}: /{GROUP}/time must be finite and ascend")
        return StatisticsRows(run.results, time, columns, {name: word(value) for name, value in group.attrs.items()})


def scene_of_rows(rows, percentiles):
    """The `Scene` that a run has sampled; `percentiles` of the overlaps [%] are chosen afterwards."""
    of = rows.scene
    windows = overlaps = voidage = None
    if "windows_count" in of:
        windows = Windows(int(of["windows_count"]), *(of[f"windows_{name}"] for name in ("left", "right", "centre", "height", "front", "front_depth")))
    if "overlap_shares" in of:
        overlaps = Overlaps(tuple(of["overlap_shares"].tolist()), tuple(percentiles))
    if "voidage_edges" in of:
        edges = of["voidage_edges"]
        voidage = Voidage(float(edges[0]), float(edges[-1]), len(edges) - 1, tuple(of["voidage_limits"].tolist()), None, int(of["voidage_cells"]))
    return Scene(windows, overlaps, voidage)


def samples(rows, chosen):
    """{name: values [n, ...]} of the rows whose time is `chosen(time)`, named and shaped as tools/report measures them of snapshots."""
    inside = numpy.array([chosen(time) for time in rows.time], dtype=bool)
    found = {"time": rows.time[inside], "spheres": rows["spheres"][inside]}

    def of_depths(*names):
        """[n, depth, window] of one name, [n, depth, window, name] of several."""
        parts = [numpy.stack([rows[f"{depth}_{name}"][inside] for depth in DEPTHS], axis=1) for name in names]
        return parts[0] if len(parts) == 1 else numpy.stack(parts, axis=-1)

    if "full_depth_number" in rows:
        found.update(number=of_depths("number"), real=of_depths("real"), sums=of_depths("horizontal_sum", "vertical_sum"),
                     temperatures=of_depths("horizontal_temperature", "vertical_temperature"))
    if "overlap_counts" in rows:
        found.update(pairs=rows["overlap_pairs"][inside], overlap_counts=rows["overlap_counts"][inside],
                     largest=rows["overlap_largest"][inside], below=rows["overlap_below"][inside])
    if "voidage_counts" in rows:
        found.update(voidage_counts=rows["voidage_counts"][inside], limit_counts=rows["voidage_limit_counts"][inside],
                     outside=numpy.zeros(int(inside.sum())))
    return found
