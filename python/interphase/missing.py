# SPDX-License-Identifier: GPL-3.0-or-later
"""What to say where a module of Python that is not of its standard library is missing."""

import importlib.util
import re
import sys

# Debian's packages, which tools/setup installs
PACKAGES = {"numpy": "python3-numpy", "scipy": "python3-scipy", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib"}


def words_on(error):
    """The text for the user of a ModuleNotFoundError: which of PACKAGES are missing, to which Python, and how to get them. Raises `error`
    where it is of none of them: then a file of our own is missing."""
    first = (error.name or "").partition(".")[0]
    if first not in PACKAGES:
        raise error
    names = [name for name in PACKAGES if importlib.util.find_spec(name) is None] or [first]
    return (f"{sys.executable} has no module{'s' * (len(names) > 1)} {', '.join(names)}. On Debian: apt-get install "
            f"{' '.join(map(PACKAGES.get, names))} (tools/setup does) and start with /usr/bin/python3; for another Python: "
            f"{sys.executable} -m pip install {' '.join(names)}")


def module(name):
    """The module interphase.`name`; ModuleNotFoundError of `words_on` where it needs one that is missing."""
    try:
        return importlib.import_module(f"interphase.{name}")
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(words_on(error), name=error.name) from None


def hint(output):
    """What to add to the message on a program in Python that ended with `output`: how to get the module that it did not find, or nothing."""
    found = re.search(r"^ModuleNotFoundError: No module named '(\w+)", output, re.M)
    if not found or found[1] not in PACKAGES:
        return ""
    return f"\nOn Debian: apt-get install {PACKAGES[found[1]]} (tools/setup does); for another Python: python3 -m pip install {found[1]}"
