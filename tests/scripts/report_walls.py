#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls that move in the pages of contrib/report/lahar-report: a gate that rises and a plate that turns are in every
snapshot where their motion has them, in the page's data and, where there is Chromium, in what it draws; others stay.

Usage: report_walls.py LAHAR CHROMIUM. Exit status 77 (skipped) without numpy, matplotlib or plotly.
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from report import RUN, compute, run_tests, show, write_report  # noqa: E402
from program_test import check, fluid, parts, section, wall  # noqa: E402

SPEED, TURN = 0.5, 6.  # m/s, 1/s
# The gate begins where the wall before it ends, and leaves it.
PLANE = RUN % (2, 0.048, "0, -9.81") + fluid("0, 0 : 0.1, 0.1") + parts("Boundaries", {
    "ground": wall("0, 0.2 : 0, 0 : 0.5, 0"), "shelf": wall("0.5, 0.1 : 0.3, 0.1"),
    "gate": wall("0.3, 0.1 : 0.3, 0.02 : 0.32, 0.02 : 0.32, 0.1 : 0.3, 0.1") + "set Motion = translation\n"
    + section("translation", f"set Displacement = 0; {SPEED}*t")})
# A plate that turns about the z axis, over a floor.
SPACE = RUN % (3, 0.024, "0, 0, -9.81") + fluid("0, 0, 0 : 0.06, 0.06, 0.06") + parts("Boundaries", {
    "floor": wall("-0.1, -0.1, 0 : 0.2, -0.1, 0 : 0.2, 0.2, 0 : -0.1, 0.2, 0"),
    "plate": wall("0.12, 0, 0 : 0.12, 0.08, 0 : 0.12, 0.08, 0.08 : 0.12, 0, 0.08") + "set Motion = rotation\n"
    + section("rotation", "set Centre = 0.12, 0, 0", "set Axis = 0, 0, 1", f"set Angle = -{TURN}*t")})


def risen(point, t):
    return point[0], point[1] + SPEED * t


def turned(point, t):
    return 0.12 + math.sin(TURN * t) * point[1], math.cos(TURN * t) * point[1], point[2]


def largest_distance(points, others):
    return max(math.dist(a, b) for a, b in zip(points, others)) if len(points) == len(others) else math.inf


def test_page(page, name, motion, moving, browser, path, drawn):
    """The points with the numbers @p moving are where motion(point, time) puts them, and all others stay."""
    snapshots, start = page.data["runs"][0]["flow"]["snapshots"], page.walls(0, 0)
    wanted = [[motion(point, snapshot["time"]) if i in moving else point for i, point in enumerate(start)]
              for snapshot in snapshots]
    distances = [largest_distance(page.walls(0, k), places) for k, places in enumerate(wanted)]
    check(f"{name}: the walls are where their motion has them, in all snapshots", len(snapshots) > 2
          and 0 < len(moving) < len(start) and max(distances) < 1e-6, distances, moving)
    if browser is None:
        return
    check(f"{name}: the page opens", browser.open(path) is not None, browser.errors)
    for k in (0, len(snapshots) - 1):
        show(browser, k, "speed")
        points = rounded(browser.evaluate(drawn))
        check(f"{name}: and drawn there in snapshot {k}", points == rounded(wanted[k]), points, wanted[k])
    check(f"{name}: nobody complains", not browser.errors, browser.errors)


def rounded(points):
    return sorted({tuple(round(c, 5) + 0. for c in point) for point in points})


IN_THE_PLANE = """document.getElementById("flow-0").data.slice(2).flatMap(
  trace => Array.from(trace.x, (x, i) => [x, trace.y[i]]))"""
IN_SPACE = """(() => { const {x, y, z} = document.getElementById("flow-0").data[2];
  return Array.from(x, (_, i) => [x[i], y[i], z[i]]); })()"""


def test_walls(lahar, directory, browser):
    path = os.path.join(directory, "plane.html")
    page = write_report(directory, "plane.html", compute(lahar, directory, "plane", PLANE))
    walls = page.data["runs"][0]["walls"]
    check("the gate is a line of its own, though it touches the shelf at the start",
          [len(line) for line in walls["lines"]] == [3, 2, 5], walls["lines"])
    check("only closed bodies are filled", walls["filled"] == [False, False, True], walls["filled"])
    test_page(page, "plane", risen, set(walls["lines"][2]), browser, path, IN_THE_PLANE)

    path = os.path.join(directory, "space.html")
    page = write_report(directory, "space.html", compute(lahar, directory, "space", SPACE))
    start = page.walls(0, 0)
    check("in space triangles share their corners", len(start) == 8, start)
    plate = {i for i, point in enumerate(start) if abs(point[0] - 0.12) < 1e-6}
    test_page(page, "space", turned, plate, browser, path, IN_SPACE)


def main():
    lahar, chromium = os.path.abspath(sys.argv[1]), sys.argv[2]
    run_tests(lambda directory, browser: test_walls(lahar, directory, browser), chromium, "numpy", "matplotlib", "plotly")


if __name__ == "__main__":
    main()
