#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in space: fluid at rest stays at rest with the hydrostatic pressure (V1), water in a tank and in a tilted one too,
whose hollow corners the particles fill before the first step; a plane flow is that of the plane."""

from itertools import product
from math import cos, radians, sin

from verification import Check, read_run, run_check, volume_changes

LEVEL, WEIGHT = 0.12, 9810.
GAUGES = {"a": 0.0123, "b": 0.06, "c": 0.11}  # name in the .prm file, height in m
TANK = (0.2, 0.15, 0.3)  # edges of the tilted tank, m
SIZE, WIDTH = 0.005, 0.015  # mesh size of the collapse and width of the slab, m


def test_rest(check):
    run = read_run(check.run("three_dimensions/hydrostatic_box.prm"))
    error = max(abs(run[f"{gauge} pressure (Pa)"] + WEIGHT * (LEVEL - z)).max() for gauge, z in GAUGES.items())
    speed = max(abs(run[f"{gauge} velocity {d} (m/s)"]).max() for gauge in GAUGES for d in "xyz")
    check.below("at rest, pressure over that at the bottom", error / (WEIGHT * LEVEL), 1e-8)
    check.below("at rest, speed at the gauges (m/s)", speed, 1e-10)
    low = 0.07 - run["low (m)"]
    check.below("at rest, extent within a box, below its top over the mesh size", abs(low / 0.02 - 0.5).max(), 0.5)
    check.below("at rest, steps with an extent in a box without fluid", sum(run["above (m)"] == run["above (m)"]), 0)
    for cause, change in zip(("solver", "remeshing"), volume_changes(run)):
        check.below(f"at rest, volume change by {cause}", change, 1e-12)


def tilted_tank(angle, level):
    """Entries for a tank turned about the y axis by @p angle and the fluid in it up to @p level."""
    def place(x, y, z):
        return x * cos(angle) + z * sin(angle), y, z * cos(angle) - x * sin(angle)

    def line(points):
        return " : ".join(f"{x:.9g}, {y:.9g}, {z:.9g}" for x, y, z in points)

    corners = {bits: place(*(bit * edge for bit, edge in zip(bits, TANK))) for bits in product((0, 1), repeat=3)}
    fluid = [corner for corner in corners.values() if corner[2] <= level]
    for bits, low in corners.items():
        for d in range(3):
            high = corners[bits[:d] + (1,) + bits[d + 1:]]
            if bits[d] == 0 and (low[2] - level) * (high[2] - level) < 0.:
                part = (level - low[2]) / (high[2] - low[2])
                fluid.append(tuple(a + part * (b - a) for a, b in zip(low, high)))
    faces = [[bits for bits in corners if bits[d] == side] for d, side in ((2, 0), (1, 0), (1, 1), (0, 0), (0, 1))]
    walls = [line([corners[face[k]] for k in (0, 1, 3, 2)]) for face in faces]
    return ("Fluids/fluid/Shape=convex", f"Fluids/fluid/convex/Corners={line(fluid)}",
            f"Boundaries/walls/polygon/Corners={'; '.join(walls)}")


def test_still_tanks(check):
    for name, entries in (("tank", ()), ("tilted tank", tilted_tank(radians(20.), 0.12))):
        run = read_run(check.run("three_dimensions/still_tank.prm", *entries))
        mass = 1000. * run["Fluid volume (m^dim)"][0]
        speed = (2. * run["Kinetic energy (J)"].max() / mass) ** 0.5
        check.below(f"{name} at rest, mean speed (m/s)", speed, 1e-8)
        check.below(f"{name} at rest, steps in which the mesh changed", run["Remeshed"].max(), 0)
        for cause, change in zip(("solver", "remeshing"), volume_changes(run)):
            check.below(f"{name} at rest, volume change by {cause}", change, 1e-10)


def test_plane_flow(check):
    space = read_run(check.run("three_dimensions/plane_collapse.prm"))
    plane = read_run(check.run("three_dimensions/plane_collapse_2d.prm", f"Mesh size={0.5 * SIZE}"))
    # The front jumps by up to a mesh size when a particle lands before it: it is compared in the mean over the second half.
    half = space["Time (s)"] > 0.06
    for name in ("front (m)", "height (m)"):
        difference = abs(space[name] - plane[name])[half].mean()
        check.below(f"slab in space against the plane, {name[:-4]}, mean over the mesh size", difference / SIZE, 0.25)
    beyond = max((-space["left (m)"]).max(), (space["right (m)"] - WIDTH).max(), (-space["low (m)"]).max())
    check.below("slab in space, fluid beyond walls and floor over the mesh size", beyond / SIZE, 1e-9)
    for cause, change, limit in zip(("solver", "remeshing"), volume_changes(space), (0.003, 0.01)):
        check.below(f"slab in space, volume change by {cause}", change, limit)


def main():
    check = Check(__doc__)
    test_rest(check)
    test_still_tanks(check)
    test_plane_flow(check)
    check.finish()


run_check(main)
