# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages that the program prints by `interphase -help ABOUT` and that stand in the tree, so that nothing has to be built to read them."""

import os

from interphase.input_error import InputError


def text(path, about):
    """What the page at `path` in the tree says; InputError, with the command that writes it, where it cannot be read."""
    from interphase.tree import REPOSITORY  # a package that was installed apart has none, and reads none
    try:
        with open(os.path.join(REPOSITORY, path), encoding="utf-8") as stream:
            return stream.read()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}; `interphase -help {about} > {path}` writes it") from None
