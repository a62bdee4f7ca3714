# SPDX-License-Identifier: GPL-3.0-or-later
"""What scenes of the plug-in `laws` have in common."""

import os

from hard_spheres import BUILD, Scene

LAWS = os.path.join("plugins", "liblaws.so")
AGING = os.path.join(BUILD, "tests", "plugins", "libaging.so")  # a law whose contacts have a state
GRAVITY = 9.81


def law_scene(law, spheres, low, high, **more):
    """A Scene of the style tdhs/`law`, walls of wall/tdhs/`law`; `more`: of Scene."""
    return Scene(spheres, low, high, law=law, plugin=LAWS, **more)


def gravity(x=0.0, y=0.0, z=-1.0, g=GRAVITY):
    return f"fix weight all gravity {g!r} vector {x!r} {y!r} {z!r}\n"
