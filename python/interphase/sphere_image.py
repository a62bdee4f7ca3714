# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres from the front as an image, painted pixel by pixel: for pages and films of many panels, where tools/picture would take minutes."""

import numpy

from interphase.picture_panels import faded

RIM = 0.75  # of the radius, from which on a sphere is darker, so that neighbours of one colour are told apart
DARKER = 0.72


def painted(position, diameter, colours, box, depth, width):
    """[rows, width, 3] bytes of spheres at position [n, 3], of diameter [n], in m, in `colours` [n, 4]; `box`: (left, right, bottom, top), `depth`:
    (front, back) in m. Of two at one pixel the nearer to the front is seen; what lies behind is paler."""
    left, right, bottom, top = box
    scale = width / (right - left)  # pixels per m
    rows = max(int(round((top - bottom) * scale)), 1)
    image = numpy.full((rows * width, 3), 255, numpy.uint8)
    if not len(diameter):
        return image.reshape(rows, width, 3)
    order = numpy.argsort(-position[:, 1], kind="stable")
    position, radius = position[order], diameter[order] * scale / 2
    behind = (position[:, 1] - depth[0]) / max(depth[1] - depth[0], 1e-300)
    paint = (255 * faded(colours[order], behind)[:, :3]).astype(numpy.uint8)
    x, y = (position[:, 0] - left) * scale, (top - position[:, 2]) * scale
    reach = int(numpy.ceil(radius.max()))
    across, down = (each.ravel() for each in numpy.meshgrid(numpy.arange(-reach, reach + 1), numpy.arange(-reach, reach + 1)))
    column, row = numpy.floor(x)[:, None] + across, numpy.floor(y)[:, None] + down
    far = numpy.hypot(column + 0.5 - x[:, None], row + 0.5 - y[:, None])
    # A sphere below a pixel still has its own one.
    inside = (far <= numpy.maximum(radius, 0.5)[:, None]) & (column >= 0) & (column < width) & (row >= 0) & (row < rows)
    sphere, at = numpy.nonzero(inside)
    pixel = (row[sphere, at] * width + column[sphere, at]).astype(numpy.int64)
    rim = (far[sphere, at] > RIM * radius[sphere]) & (radius[sphere] > 2)
    shade = paint[sphere].astype(float)
    shade[rim] *= DARKER
    image[pixel] = shade.astype(numpy.uint8)  # of several at one pixel the last counts: the nearest
    return image.reshape(rows, width, 3)
