# SPDX-License-Identifier: GPL-3.0-or-later
"""What the `prepare` of a case needs: the numbers of its file `parameters`, checked, and tools/bed.

Every function ends the program with a message that says what is wrong where a number is missing or cannot be.
"""

import math
import sys

from interphase import data_file, methods, parameters
from interphase.commands import bed
from interphase.input_error import InputError



def values():
    """{name: text} of the file `parameters` in the current folder."""
    try:
        return parameters.read(parameters.PARAMETERS)
    except InputError as error:
        sys.exit(f"prepare: {error}")


def number(value, key, holds=math.isfinite, demand="a finite number"):
    """The number that `value` has at `key`, which must satisfy `holds`; `demand` says so in words."""
    try:
        found = float(value[key])
    except KeyError:
        sys.exit(f"prepare: '{key}' is missing in parameters")
    except ValueError:
        sys.exit(f"prepare: '{key}' in parameters is no number: '{value[key]}'")
    if not holds(found):
        sys.exit(f"prepare: '{key}' in parameters must be {demand}, is {value[key]}")
    return found


def positive(value, key):
    """The number at `key`, which must be above 0."""
    return number(value, key, lambda x: 0 < x < math.inf, "positive")


def tracked_weight(value):
    """Real particles per tracked one, which must go with the method."""
    weight = number(value, "weight", lambda w: 1 <= w < math.inf, "1 or more: it counts real particles per tracked one")
    method = methods.of_tree().get(value.get("method"))  # of others the program will tell
    if method is not None and method.of_particles and weight != 1:
        sys.exit(
            f"prepare: weight {weight:g} in parameters, but method {method.name} tracks every particle; "
            f"set weight 1 or method {method.with_parcels}"
        )
    return weight


def tracked_count(value, weight):
    """How many are tracked of `particleCount` real particles."""
    real = number(value, "particleCount", lambda n: 1 <= n < math.inf, "1 or more")
    count = round(real / weight)
    if count < 1 or abs(count * weight - real) > 1e-3 * real:
        sys.exit(
            f"prepare: {count} parcels of weight {weight:g} stand for {count * weight:g} particles, "
            f"not for {real:g} within 0.1 %; change weight or particleCount in parameters"
        )
    return count


def write_bed(*arguments):
    """dem/bed.data by tools/bed, whose refusals end the program. Numbers are handed over with all their digits."""
    words = [repr(word) if isinstance(word, float) else str(word) for word in arguments]
    bed.main([*words, "--out", "dem/bed.data"])


def write_parcels(count, diameter, density, box, region, seed):
    """dem/bed.data of MP-PIC's parcels in the LIGGGHTS domain `box`, evenly and without order in `region` (both low and high along x, y,
    z): on a lattice they would stay in planes, as they do not collide.

    Their solids fill the region to its faces, yet no centre is nearer than a radius: those of the outermost diameter stand in the inner
    half of it.
    """
    from interphase.even_bed import even_bed  # numpy and scipy

    low, high = region[0::2], region[1::2]
    if any(not (box[2 * a] <= low[a] < high[a] <= box[2 * a + 1]) for a in range(3)):
        sys.exit(f"prepare: the parcels would fill {region} m, which is not within the box {box} m")
    try:
        centres = even_bed(count, diameter, low, high, seed, may_overlap=True)
    except InputError as error:
        sys.exit(f"prepare: {error}")
    for axis in range(3):
        for face, inwards in ((low[axis], 1), (high[axis], -1)):
            off = inwards * (centres[:, axis] - face)
            centres[:, axis] += inwards * (off < diameter) * (diameter - off) / 2
    write_spheres(centres, diameter, density, box)
    print(f"prepare: {count} parcels of {diameter:.6g} m up to {high[2]:.4g} m")


def write_spheres(centres, diameter, density, box, types=2, velocities=None):
    """dem/bed.data of equal spheres of type 1 at `centres` [n, 3] in the LIGGGHTS domain `box` (low and high along x, y, z), at rest
    or with `velocities` [n, 3] and no rotation, SI units."""
    data_file.write("dem/bed.data", f"{len(centres)} spheres", box[0::2], box[1::2], centres, diameter, density, velocity=velocities,
                    types=types)  # fmt: skip
