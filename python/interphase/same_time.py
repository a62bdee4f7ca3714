# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether two times are meant to be one: they are typed, and folders named, with few digits."""

SAME_TIME = 1e-6  # relative


def same_time(one, other):
    """Of two times [s]."""
    return abs(one - other) <= SAME_TIME * max(abs(one), abs(other))
