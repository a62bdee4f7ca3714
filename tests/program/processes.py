# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes of a run."""


def children(parent):
    """Ids of the programs that `parent` has started."""
    with open(f"/proc/{parent}/task/{parent}/children", encoding="ascii") as file:
        return [int(word) for word in file.read().split()]


def alive(process):
    """Whether it runs; one that is dead and not yet asked for by its parent does not."""
    try:
        with open(f"/proc/{process}/stat", encoding="ascii", errors="replace") as file:
            return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False
