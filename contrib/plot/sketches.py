#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw sketches of the benchmarks and of the first own case: fluid, walls, solids, lengths in m.

    sketches.py doc/figures
"""

import argparse
import pathlib

import numpy as np

from figure_style import INK, WIDTH, plt, save, use_style
from lahar_output import run_script

FLUID, SOLID, WALL = "#9ecae1", "#f4a582", "0.25"


def fluid(axes, corners):
    axes.fill(*np.transpose(corners), facecolor=FLUID, edgecolor="#3182bd", linewidth=0.8)


def solid(axes, corners):
    axes.fill(*np.transpose(corners), facecolor=SOLID, edgecolor="#b2182b", linewidth=0.8)


def wall(axes, points, slip=False):
    """A line of walls, dashed with slip."""
    axes.plot(*np.transpose(points), color=WALL, linewidth=1.8, linestyle=(0, (3, 1.2)) if slip else "-",
              solid_capstyle="butt", solid_joinstyle="miter")


def length(axes, start, end, text, shift=(0., 0.)):
    """An arrow with two heads from @p start to @p end; @p shift moves its text, in points."""
    axes.annotate("", start, end, annotation_clip=False,
                  arrowprops={"arrowstyle": "<->", "color": INK, "linewidth": 0.7, "shrinkA": 0, "shrinkB": 0})
    note(axes, [0.5 * (a + b) for a, b in zip(start, end)], text, shift)


def note(axes, place, text, shift=(0., 0.), **options):
    axes.annotate(text, place, xytext=shift, textcoords="offset points", ha="center", va="center", color=INK, fontsize=8,
                  annotation_clip=False, **options)


def pointer(axes, place, text, shift):
    """Text beside a place, with a line to it."""
    note(axes, place, text, shift, arrowprops={"arrowstyle": "-", "color": INK, "linewidth": 0.6})


def gravity(axes, place, size, direction=(0., -1.)):
    end = (place[0] + size * direction[0], place[1] + size * direction[1])
    axes.annotate("", end, place, arrowprops={"arrowstyle": "->", "color": INK, "linewidth": 1.})
    note(axes, end, "g", (7, 2))


def start(width=0.7, height=0.35, panels=1):
    figure, axes = plt.subplots(1, panels, figsize=(width * WIDTH, height * WIDTH), squeeze=False)
    for one in axes[0]:
        one.set_aspect("equal")
        one.axis("off")
    return figure, list(axes[0])


def box(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def dam_break(axes, elastic):
    fluid(axes, box(0, 0, 0.146, 0.292))
    barrier = box(0.292, 0, 0.304, 0.08)
    if elastic:
        wall(axes, [(0, 0.36), (0, 0), (0.8, 0)])
        solid(axes, barrier)
        axes.plot([0.292], [0.08], "o", color=INK, markersize=3)
        pointer(axes, (0.292, 0.08), "tip", (-18, -3))
        pointer(axes, (0.298, 0.), "clamped", (22, -12))
    else:
        wall(axes, [(0, 0.36), (0, 0), (0.292, 0), (0.292, 0.08), (0.304, 0.08), (0.304, 0), (0.8, 0)])
    length(axes, (0, 0.31), (0.146, 0.31), "0.146", (0, 8))
    length(axes, (0.17, 0), (0.17, 0.292), "0.292", (14, 0))
    length(axes, (0, -0.035), (0.292, -0.035), "0.292", (0, -8))
    length(axes, (0.335, 0), (0.335, 0.08), "0.08", (12, 0))
    pointer(axes, (0.298, 0.07), "0.012 thick", (26, 34))
    note(axes, (0.073, 0.14), "fluid")
    gravity(axes, (0.6, 0.3), 0.08)


def draw_dam_breaks():
    for name, elastic in (("rigid", False), ("elastic", True)):
        figure, (axes,) = start()
        dam_break(axes, elastic)
        yield f"sketch_dam_break_{name}", figure
    figure, (side, above) = start(1., 0.3, 2)
    fluid(side, box(0, 0, 0.146, 0.292))
    wall(side, [(0, 0.36), (0, 0), (0.8, 0)])
    solid(side, box(0.292, 0, 0.304, 0.08))
    length(side, (0, 0.31), (0.146, 0.31), "0.146", (0, 8))
    length(side, (0, -0.04), (0.292, -0.04), "0.292", (0, -8))
    length(side, (0.335, 0), (0.335, 0.08), "0.08", (12, 0))
    note(side, (0.5, 0.3), "from the side")
    fluid(above, box(0, 0, 0.146, 0.08))
    for y in (0, 0.08):
        wall(above, [(0, y), (0.5, y)])
    wall(above, [(0, 0), (0, 0.08)])
    solid(above, box(0.292, 0.001, 0.304, 0.079))
    length(above, (0.4, 0), (0.4, 0.08), "0.08", (12, 0))
    pointer(above, (0.298, 0.078), "gap of 0.001", (0, 18))
    note(above, (0.25, -0.045), "from above, to x = 0.5")
    yield "sketch_dam_break_channel", figure


def draw_slumps():
    figure, axes = start(0.9, 0.3, 2)
    for panel, name, base, top, height in zip(axes, ("mini cone", "Abrams cone"), (0.05, 0.1), (0.035, 0.05), (0.05, 0.3)):
        fluid(panel, [(-base, 0), (base, 0), (top, height), (-top, height)])
        reach = 2.4 * max(base, 0.4 * height)
        wall(panel, [(-reach, 0), (reach, 0)])
        panel.plot([0, 0], [-0.12 * height, 1.15 * height], color=INK, linewidth=0.6, linestyle="-.")
        length(panel, (-base, -0.16 * height), (base, -0.16 * height), f"{2 * base:g}", (0, -8))
        length(panel, (-top, 1.12 * height), (top, 1.12 * height), f"{2 * top:g}", (0, 8))
        length(panel, (1.15 * base, 0), (1.15 * base, height), f"{height:g}", (14, 0))
        panel.set_title(f"{name}, section", fontsize=8, color=INK, pad=16)
    yield "sketch_slump", figure


def draw_slope():
    angle = np.deg2rad(15.)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])

    def turned(points):
        return [tuple(turn @ point) for point in points]

    figure, (axes,) = start(0.75, 0.36)
    fluid(axes, turned(box(-0.3024, 0, 0, 0.0756)))
    wedge = turned([(-0.3024, 0), (0, 0.0756)])
    axes.plot(*np.transpose(wedge), color="#3182bd", linewidth=0.9, linestyle="--")
    wall(axes, turned([(-0.3024, 0.12), (-0.3024, 0), (0.55, 0)]))
    length(axes, *turned([(-0.3024, -0.03), (0, -0.03)]), "L0", (-4, -9))
    length(axes, *turned([(0.03, 0), (0.03, 0.0756)]), "H0", (12, 2))
    for end, text, shift in (((0.14, 0), "x", (4, -6)), ((0, 0.14), "y", (8, 2))):
        begin, tip = turned([(0, 0), end])
        axes.annotate("", tip, begin, arrowprops={"arrowstyle": "->", "color": INK, "linewidth": 0.8})
        note(axes, tip, text, shift)
    note(axes, turned([(-0.15, 0.055)])[0], "block")
    note(axes, turned([(-0.1, 0.022)])[0], "wedge")
    foot = turned([(0.55, 0)])[0]
    axes.plot([foot[0] - 0.2, foot[0]], [foot[1], foot[1]], color=INK, linewidth=0.6)
    note(axes, (foot[0] - 0.13, foot[1] + 0.015), "15°")
    gravity(axes, (0.35, 0.12), 0.07)
    yield "sketch_bentonite_slope", figure


def draw_first_case():
    figure, (axes,) = start(0.9, 0.36)
    fluid(axes, [(-0.96, 0.36), (-0.56, 0.21), (-0.56, 0.37), (-0.96, 0.52)])
    wall(axes, [(-1.2, 0.45), (0, 0), (0.3, 0), (0.3, 0.1), (0.34, 0.1), (0.34, 0), (0.8, 0)])
    note(axes, (-0.76, 0.365), "mud")
    length(axes, (-0.52, 0.195), (-0.52, 0.355), "0.16", (13, 2))
    length(axes, (-0.96, 0.56), (-0.56, 0.56), "0.4", (0, 8))
    length(axes, (0, -0.05), (0.3, -0.05), "0.3", (0, -8))
    length(axes, (-0.56, -0.05), (0, -0.05), "0.56", (0, -8))
    length(axes, (0.39, 0), (0.39, 0.1), "0.1", (11, 0))
    pointer(axes, (0.32, 0.1), "barrier, 0.04 thick", (10, 26))
    pointer(axes, (-0.3, 0.1125), "bed, 3 on 8", (34, 24))
    gravity(axes, (0.6, 0.5), 0.12)
    yield "sketch_first_case", figure


def draw_verification():
    figure, axes = plt.subplots(2, 4, figsize=(WIDTH, 0.62 * WIDTH))
    for panel, title in zip(axes.flat, ("V1 column at rest", "V4 sloshing", "V5 elliptic drop", "V6 column collapse",
                                        "V7 arrested dam break", "V8 rod, load at its tip", "V8 barrier vibrates",
                                        "V9 spinning drop")):
        panel.set_aspect("equal")
        panel.axis("off")
        panel.set_title(title, fontsize=8, color=INK)
    column, tank, drop, collapse, arrest, rod, barrier, spin = axes.flat
    fluid(column, box(0, 0, 0.1, 0.2))
    wall(column, [(0, 0.25), (0, 0), (0.1, 0), (0.1, 0.25)])
    length(column, (0, -0.02), (0.1, -0.02), "0.1", (0, -8))
    length(column, (0.12, 0), (0.12, 0.2), "0.2", (10, 0))

    x = np.linspace(0., 1., 50)
    fluid(tank, [(0, 0), *zip(x, 1 + 0.04 * np.cos(np.pi * x)), (1, 0)])
    wall(tank, [(0, 1.25), (0, 0), (1, 0), (1, 1.25)], slip=True)
    length(tank, (0, -0.1), (1, -0.1), "1", (0, -8))
    note(tank, (0.5, 0.5), "slip walls")

    angle = np.linspace(0., 2. * np.pi, 80)
    for panel, radius in ((drop, 1.), (spin, 0.1)):
        fluid(panel, np.transpose([radius * np.cos(angle), radius * np.sin(angle)]))
        length(panel, (0, 0), (radius * np.cos(0.8), radius * np.sin(0.8)), f"{radius:g}", (-10, 4))
    for sign in (-1., 1.):
        drop.annotate("", (0, 1.5 * sign), (0, 1.05 * sign), arrowprops={"arrowstyle": "->", "color": INK})
        drop.annotate("", (1.05 * sign, 0), (1.5 * sign, 0), arrowprops={"arrowstyle": "->", "color": INK})
    drop.set(xlim=(-1.6, 1.6), ylim=(-1.6, 1.6))
    spin.annotate("", (-0.06, 0.12), (0.06, 0.12), arrowprops={"arrowstyle": "->", "color": INK,
                                                                "connectionstyle": "arc3,rad=0.35"})
    spin.set(xlim=(-0.13, 0.13), ylim=(-0.13, 0.16))

    fluid(collapse, box(0, 0, 0.05715, 0.1143))
    wall(collapse, [(0, 0.15), (0, 0), (0.22, 0)], slip=True)
    length(collapse, (0, -0.015), (0.05715, -0.015), "0.05715", (0, -8))
    length(collapse, (0.07, 0), (0.07, 0.1143), "0.1143", (18, 0))

    fluid(arrest, box(0, 0, 1, 0.1))
    wall(arrest, [(0, 0), (1.9, 0)])
    wall(arrest, [(0, 0), (0, 0.3)], slip=True)
    length(arrest, (0, -0.08), (1, -0.08), "1", (0, -8))
    length(arrest, (1.1, 0), (1.1, 0.1), "0.1", (10, 0))
    arrest.set(ylim=(-0.8, 0.8))

    solid(rod, box(0, 0, 1, 0.02))
    wall(rod, [(0, -0.1), (0, 0.12)])
    rod.annotate("", (1, -0.2), (1, 0), arrowprops={"arrowstyle": "->", "color": INK})
    length(rod, (0, -0.15), (0.95, -0.15), "1", (0, -8))
    rod.set(ylim=(-0.5, 0.4))

    solid(barrier, box(0, 0, 0.012, 0.08))
    wall(barrier, [(-0.02, 0), (0.032, 0)])
    length(barrier, (0.02, 0), (0.02, 0.08), "0.08", (12, 0))
    length(barrier, (0, -0.006), (0.012, -0.006), "0.012", (0, -8))
    barrier.set(xlim=(-0.03, 0.045))
    yield "sketch_verification", figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="where the sketches go")
    arguments = parser.parse_args()
    use_style()
    plt.rcParams["savefig.dpi"] = 140
    for drawing in (draw_dam_breaks, draw_slumps, draw_slope, draw_first_case, draw_verification):
        for name, figure in drawing():
            save(figure, arguments.folder / f"{name}.png")
            plt.close(figure)


if __name__ == "__main__":
    run_script(main)
