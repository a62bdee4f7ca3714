# SPDX-License-Identifier: GPL-3.0-or-later
"""Text files that are whole at any moment."""

import os


def write(path, text):
    """`text` as the file at `path`, which has what it had before until all of it is on disk under another name."""
    with open(path + ".new", "w", encoding="utf-8") as stream:
        stream.write(text)
    os.replace(path + ".new", path)
