# SPDX-License-Identifier: GPL-3.0-or-later
"""What to say where a module of Python that is not of its standard library is missing."""

import sys

# Debian's packages, which tools/setup installs
PACKAGES = {"numpy": "python3-numpy", "scipy": "python3-scipy", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib"}


def words_on(error):
    """The text for the user of a ModuleNotFoundError: which module, which Python, and how to get it. Raises `error` where it
    is none of PACKAGES: then a file of our own is missing."""
    module = (error.name or "").partition(".")[0]
    if module not in PACKAGES:
        raise error
    return (f"{sys.executable} has no module {module}. On Debian: apt-get install {PACKAGES[module]} (tools/setup does) and start with "
            f"/usr/bin/python3; for another Python: {sys.executable} -m pip install {module}")
