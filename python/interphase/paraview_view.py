# SPDX-License-Identifier: GPL-3.0-or-later
"""A run in ParaView: spheres at true size by their velocity, the gas in the middle plane beside them, the walls, seen from the front.

    pvpython show-in-paraview.py [--screenshot FILE] [--time T]     a picture, without a window
    paraview --script=show-in-paraview.py                           ParaView with the run; there also Tools > Python Shell > Run Script

Written by tools/paraview, whose other numbers follow; the rest may be changed at will.
"""

import argparse
import os

from paraview.simple import *  # noqa: F403  (as ParaView's own traces have it)

RUN = {}  # what tools/paraview knows of the run

try:
    FOLDER = os.path.dirname(os.path.abspath(__file__))  # moves with the run
except NameError:  # in ParaView's Python shell
    FOLDER = RUN["folder"]
MANY = 30000  # spheres, from which on they are drawn by the graphics card as points: glyphs have a hundred triangles each


def place(name):
    return os.path.join(FOLDER, name)


def coloured(shown, where, array, component, ends, title, beside):
    """By `array` over the range `ends`, with a bar at the right."""
    ColorBy(shown, (where, array, component) if component else (where, array))  # noqa: F405
    table = GetColorTransferFunction(array)  # noqa: F405
    table.ApplyPreset("Cool to Warm" if array == "velocity" else "Viridis (matplotlib)", True)
    if component:
        table.VectorMode, table.VectorComponent = "Component", "XYZ".index(component)
    table.RescaleTransferFunction(*ends)
    shown.SetScalarBarVisibility(VIEW, True)
    bar = GetScalarBar(table, VIEW)  # noqa: F405
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.87, 0.55 if beside == 0 else 0.12], 0.33
    bar.TitleFontSize = bar.LabelFontSize = 14


def particles():
    source = XDMFReader(registrationName="particles", FileNames=[place("particles.xdmf")])  # noqa: F405
    source.UpdatePipeline(source.TimestepValues[-1] if len(source.TimestepValues) else 0)
    if source.GetDataInformation().GetNumberOfPoints() > MANY:
        shown = Show(source, VIEW)  # noqa: F405
        shown.SetRepresentationType("Point Gaussian")
        shown.ShaderPreset, shown.GaussianRadius = "Sphere", 0.5
        shown.ScaleByArray, shown.SetScaleArray, shown.UseScaleFunction = 1, ["POINTS", "diameter"], 0
    else:
        spheres = Glyph(registrationName="spheres", Input=source, GlyphType="Sphere", GlyphMode="All Points",  # noqa: F405
                        OrientationArray=["POINTS", "No orientation array"], ScaleArray=["POINTS", "diameter"])  # fmt: skip
        spheres.ScaleFactor = 1.0  # set with the others it would be guessed anew
        spheres.GlyphType.Radius, spheres.GlyphType.ThetaResolution, spheres.GlyphType.PhiResolution = 0.5, 12, 9
        shown = Show(spheres, VIEW)  # noqa: F405
    coloured(shown, "POINTS", "velocity", "Z", RUN["range"], "vertical velocity [m/s]", 0)
    return source


def gas():
    """The middle plane's, moved beside the particles; and the outline of the mesh where it is."""
    if RUN["gas"] is None:
        return
    source = OpenFOAMReader(registrationName="gas", FileName=place(RUN["foam"]),  # noqa: F405
                            CaseType="Decomposed Case" if RUN["decomposed"] else "Reconstructed Case")  # fmt: skip
    source.MeshRegions, source.CellArrays = ["internalMesh"], [RUN["gas"]]
    plane = Slice(registrationName="middle plane", Input=source, SliceType="Plane")  # noqa: F405
    plane.SliceType.Origin, plane.SliceType.Normal = [0.5 * (RUN["low"][0] + RUN["high"][0]), RUN["y"], RUN["low"][2]], [0, 1, 0]
    plane.Triangulatetheslice = 0
    beside = Transform(registrationName="beside the particles", Input=plane)  # noqa: F405
    beside.Transform.Translate = [1.15 * (RUN["high"][0] - RUN["low"][0]), 0, 0]
    shown = Show(beside, VIEW)  # noqa: F405
    shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0  # its colours as the bar has them, without light and shade
    coloured(shown, "CELLS", RUN["gas"], None, RUN["gas range"], RUN["gas"], 1)
    whole = MergeBlocks(registrationName="gas, whole", Input=source, MergePoints=1)  # noqa: F405  (faces between the ranks' pieces are none)
    lines(ExtractSurface(registrationName="surface of the gas", Input=whole), "edges of the gas")  # noqa: F405


def lines(surface, name):
    edges = FeatureEdges(registrationName=name, Input=surface, FeatureAngle=35)  # noqa: F405
    edges.NonManifoldEdges = 0
    shown = Show(edges, VIEW)  # noqa: F405
    shown.ColorArrayName = ["POINTS", ""]  # by none
    shown.AmbientColor = shown.DiffuseColor = [0.2, 0.2, 0.2]
    shown.LineWidth = 2


def walls():
    """Surfaces of the particles, at the place where they start."""
    for name, scale, move in RUN["surfaces"]:
        surface = STLReader(registrationName=name, FileNames=[place(name)])  # noqa: F405
        moved = Transform(registrationName=name + " in its place", Input=surface)  # noqa: F405
        moved.Transform.Scale, moved.Transform.Translate = 3 * [scale], move
        shown = Show(moved, VIEW)  # noqa: F405
        shown.ColorArrayName = ["POINTS", ""]  # by none
        shown.DiffuseColor, shown.Opacity = [0.5, 0.55, 0.6], 0.25
        lines(moved, "edges of " + name)


def camera():
    low, high = RUN["low"], RUN["high"]
    right = high[0] + (1.15 * (high[0] - low[0]) if RUN["gas"] else 0)
    middle = [0.5 * (low[0] + right), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])]
    tall, wide = high[2] - low[2], right - low[0]
    VIEW.CameraParallelProjection = 1
    VIEW.CameraFocalPoint, VIEW.CameraViewUp = [middle[0] + 0.08 * wide, middle[1], middle[2]], [0, 0, 1]
    VIEW.CameraPosition = [middle[0] + 0.08 * wide, low[1] - 4 * max(tall, wide), middle[2]]
    VIEW.CameraParallelScale = 0.5 * 1.2 * max(tall, 1.3 * wide * VIEW.ViewSize[1] / VIEW.ViewSize[0])


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--screenshot", metavar="FILE")
parser.add_argument("--time", metavar="T", type=float, help="in s; the last by default")
given, _ = parser.parse_known_args()  # ParaView's own words are none of ours

VIEW = GetActiveViewOrCreate("RenderView")  # noqa: F405
if given.screenshot:
    VIEW.ViewSize = RUN["pixels"]
VIEW.UseColorPaletteForBackground, VIEW.Background = 0, [1, 1, 1]
VIEW.OrientationAxesVisibility = 0
spheres_of = particles()
gas()
walls()
title = Text(registrationName="title", Text=RUN["title"])  # noqa: F405
clock = AnnotateTimeFilter(registrationName="time", Input=spheres_of, Format="t = {time:.4g} s")  # noqa: F405
for words, corner in ((title, "Lower Left Corner"), (clock, "Lower Right Corner")):
    seen = Show(words, VIEW)  # noqa: F405
    seen.WindowLocation, seen.Color, seen.FontSize = corner, [0, 0, 0], 16
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()  # noqa: F405
times = list(spheres_of.TimestepValues) or [0.0]
GetAnimationScene().AnimationTime = VIEW.ViewTime = min(times, key=lambda t: abs(t - (times[-1] if given.time is None else given.time)))  # noqa: F405
Render(VIEW)  # noqa: F405  (the first one places the camera by itself)
camera()
Render(VIEW)  # noqa: F405
if given.screenshot:
    SaveScreenshot(given.screenshot, VIEW)  # noqa: F405
