# SPDX-License-Identifier: GPL-3.0-or-later
"""The law as it shows: spheres thrown at the floor."""

from scenes import STEP, run, sphere


def restitutions(speeds, diameter, beside_a_wall=False):
    """Speed after over speed before of spheres of less than 0.09 m/len(speeds) thrown at the floor, each at one of `speeds` [m/s]; on the way they
    may touch a wall, which takes nothing from them."""
    script = "".join(
        sphere(k + 1, diameter, 2000, (0.005 + 0.09 * k / len(speeds), diameter / 2, diameter), (0, 0, -speed)) for k, speed in enumerate(speeds))
    if beside_a_wall:
        script += "fix side all @WALL@ primitive type 1 yplane 0.0\n"
    found = [None] * len(speeds)
    for state in run(script + f"run {round(0.5 * diameter / min(speeds) / STEP) + 300}\n"):
        for each in state:
            k = int(each["id"]) - 1
            if each["vz"] > 0 and found[k] is None:
                found[k] = each["vz"] / speeds[k]
    return found
