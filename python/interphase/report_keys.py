# SPDX-License-Identifier: GPL-3.0-or-later
"""The keys of `statistics` in system/couplingDict that say what tools/report measures of snapshots: one table, for reading, for
complaints and for the help."""

# {block: {key: (unit, what, default)}}; block "" is the file itself.
KEYS = {
    "": {
        "from": ("s", "what is before is start-up and left out", "found by MSER-5 from /series"),
        "interval": ("s", "between two rows of /statistics, which the run takes", "0: none"),
        "tapInterval": ("s", "between two rows of /taps", "0: none"),
        "windows": ("", "block, or `none`: no profiles", "all of its defaults"),
        "overlaps": ("", "block, or `none`", "all of its defaults"),
        "voidage": ("", "block, or `none`", "all of its defaults"),
        "surface": ("", "block, or `none`; only in rows", "all of its defaults"),
        "bubbles": ("", "block, or `none`; only in rows", "all of its defaults"),
    },
    "windows": {
        "count": ("", "windows side by side across x", "5, fewer where they would be below 4 largest diameters"),
        "left": ("m", "x of the left end of the first", "the vessel's"),
        "right": ("m", "x of the right end of the last", "the vessel's"),
        "centre": ("m", "z of their middle", "the mean height of all solids"),
        "height": ("m", "their height", "a window's width, 4 largest diameters at least, the vessel's height at most"),
        "front": ("m", "y of the front wall", "the vessel's"),
        "frontDepth": ("m", "depth of the slice behind it", "the largest diameter"),
    },
    "overlaps": {
        "shares": ("d", "list: the share of overlaps below each", "(0.001 0.01 0.05)"),
        "percentiles": ("%", "list", "(50 90 99)"),
    },
    "voidage": {
        "lowest": ("", "the histogram's low end", "0.3"),
        "highest": ("", "its high end", "1"),
        "bins": ("", "bins between them", "70"),
        "limits": ("", "list: the share of cells between these", "(0.4 0.5 0.8 0.95)"),
        "low": ("m", "(x y z), low corner of a mesh of one's own; with high and cells",
                "blockMeshDict's box and cells where it is one uniform box, else the vessel's"),
        "high": ("m", "(x y z), its high corner", "the same"),
        "cells": ("", "(nx ny nz)", "the same; 4 mean diameters wide in the vessel's"),
    },
    "surface": {
        "columns": ("", "columns across x", "as wide as a gas cell, 4 mean diameters at least"),
        "share": ("", "of a column's solids below its surface", "0.99"),
    },
    "bubbles": {"voidage": ("", "above which a cell belongs to a bubble", "0.8")},
}


def described():
    """Lines of the help: every key with its unit, meaning and default."""
    lines = []
    for block, keys in KEYS.items():
        indent = "  "
        if block:
            lines.append(f"  {block}")
            indent = "    "
        for key, (unit, what, default) in keys.items():
            name = indent + key + (f" [{unit}]" if unit else "")
            lines.append(f"{name:<22} {what}")
            lines.append(f"{'':<22}   default: {default}")
    return lines
