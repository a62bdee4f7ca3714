# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets of runs as a page in a file, with pictures of the runs that are still there; what tools/report and tools/study end with."""

import dataclasses
import os

from interphase import page_html, page_pictures, run_sheet, whole_file
from interphase.foam_file import nearest
from interphase.input_error import InputError
from interphase.report_page import Page

FIRST_OF = ("DEM", "TDHS")  # the reference of stored runs where none is named: what tracks every particle


def is_stored(path):
    """Whether `path` is a sheet, or a folder of sheets that is no run."""
    if os.path.isdir(path):
        return bool(run_sheet.stored_in(path)) and not os.path.isfile(os.path.join(path, "results.h5"))
    return path.endswith(run_sheet.END)


def _measured(scene):
    """What of a `Scene` has to be alike: rows know the voidage without its mesh, and a report keeps the two kinds of voidage apart."""
    return scene if scene.voidage is None else dataclasses.replace(scene, voidage=dataclasses.replace(scene.voidage, mesh=None))


def stored(paths):
    """[`Sheet`] of the sheets, or the folders of sheets, at `paths`; of a folder, what may be a reference comes first."""
    sheets = []
    for path in paths:
        some = [run_sheet.read(file) for file in (run_sheet.stored_in(path) if os.path.isdir(path) else [path])]
        sheets += sorted(some, key=lambda sheet: FIRST_OF.index(sheet.account.method) if sheet.account.method in FIRST_OF else len(FIRST_OF))
    first = sheets[0]
    for sheet in sheets[1:]:
        if _measured(sheet.scene) != _measured(first.scene):
            raise InputError(f"{first.name} and {sheet.name} do not measure the same: windows, overlaps or voidage differ; give them apart")
    names = [sheet.name for sheet in sheets]
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise InputError(f"two of the sheets are of a run {twice}: give one of them, or rename a file and its `name`")
    return sheets


def with_reference(sheets, name):
    """The sheets, that of `name` first (None: as they are); InputError with the nearest where there is none."""
    if name is None:
        return sheets
    names = [sheet.name for sheet in sheets]
    if name not in names:
        raise InputError(f"--reference {name}: is none of the runs: {nearest(name, names)}")
    return sorted(sheets, key=lambda sheet: sheet.name != name)


def depth_of(sheets):
    """The windows to show: of the front where all runs track real particles."""
    return "front_slice" if all(sheet.account.weight == 1 for sheet in sheets) else "full_depth"


def write(path, title, sheets, depth, notes=(), folders=None, confidence=0.95, counted=None):
    """The page at `path`; `folders` {name: path} of the runs that pictures are made of."""
    notes, pictures = list(notes), ""
    shown = [(sheet.name, folders[sheet.name]) for sheet in sheets if folders and sheet.name in folders]
    if shown:
        start, end = sheets[0].start, sheets[0].end
        runs = [page_pictures.Pictured(folder, start, end) for _, folder in shown]
        names = [name for name, _ in shown]
        pictures = page_pictures.side_by_side(runs, names, start, end)
        if pictures:
            moving, why = page_pictures.moving(runs, names)
            pictures += moving + (page_html.paragraph(page_html.text(why[0].upper() + why[1:] + ".")) if why else "")
    whole_file.write(path, Page(title, sheets, depth, notes, pictures, confidence, counted).html())


def check_name(path, option):
    """InputError where no page can be written at `path`."""
    if not path.lower().endswith((".html", ".htm")):
        raise InputError(f"{option} {path}: give a name that ends with .html")
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise InputError(f"{option} {path}: there is no folder {folder}")


def title_of(sheets):
    """What the page is of."""
    cases = " and ".join(dict.fromkeys(sheet.account.case or sheet.name for sheet in sheets))
    return f"{cases}: {len(sheets)} run{'s' * (len(sheets) > 1)}"
