# SPDX-License-Identifier: GPL-3.0-or-later
"""Where interphase's own tree is: its tools, cases and build folder, which an installed package does not hold."""

import os

PYTHON = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))


def _tree():
    above = os.path.dirname(PYTHON)
    named = os.environ.get("INTERPHASE_SOURCE")
    for folder in (above, named):
        if folder and os.path.isfile(os.path.join(folder, "tools", "setup")):
            return os.path.realpath(folder)
    raise ImportError(
        f"this package ({PYTHON}) was installed apart from interphase's tree"
        + (f", and INTERPHASE_SOURCE={named} has no tools/setup" if named else "")
        + ": set INTERPHASE_SOURCE to the folder of the tree, or install by `pip install --editable` from there"
    )


REPOSITORY = _tree()
TOOLS = os.path.join(REPOSITORY, "tools")
CASES = os.path.join(REPOSITORY, "cases")


def with_package(environment):
    """`environment` with PYTHONPATH, by which programs in Python that are started with it find this package: a dict."""
    there = environment.get("PYTHONPATH")
    return {**environment, "PYTHONPATH": PYTHON + (os.pathsep + there if there else "")}
