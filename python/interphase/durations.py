# SPDX-License-Identifier: GPL-3.0-or-later
"""Times in words."""


def told(seconds):
    """A time as one says it: 41 s, 12 min, 3.4 h, 12 d."""
    for unit, size in (("d", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.3g} s"
