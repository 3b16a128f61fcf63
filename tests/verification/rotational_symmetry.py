#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotational symmetry in the half plane (r, z): fluid at rest in a cylinder and in free fall, an inviscid drop that
becomes an ellipsoid, a plug that slides down a pipe, a viscous gravity current, and the mini slump cone against the theory
of thin layers.

H. E. Huppert's current (J. Fluid Mech. 121 (1982) 43-58) of the volume V has the radius 0.894 (g V³ t/(3 nu))^(1/8), and
the depth on the axis is 4 V/(3 pi r²) by its profile (1 - s²)^(1/3).
"""

import math

import numpy as np

from ellipsoidal_drop import check_axes, exact_axes
from verification import ROOT, Check, read_run, run_check, volume_changes  # adds contrib/plot to the path

from thin_layer import Cone, spread

GRAVITY = 9.81
RADIUS, HEIGHT, WEIGHT = 0.1, 0.2, 9810.  # of the column at rest; the last one per volume
GAUGES = {"a": 0.002, "b": 0.05, "c": 0.0973, "d": 0.15, "e": 0.195}  # name in the .prm file, height in m


def check_volume(check, name, statistics, largest):
    for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
        check.below(f"{name}, volume change by {cause}", change, largest)


def check_rest(check):
    statistics = read_run(check.run("rotational_symmetry/hydrostatic.prm"))
    volume = math.pi * RADIUS**2 * HEIGHT
    error = max(abs(statistics[f"{gauge} pressure (Pa)"] + WEIGHT * (HEIGHT - z)).max() for gauge, z in GAUGES.items())
    speed = max(abs(statistics[f"{gauge} velocity {d} (m/s)"]).max() for gauge in GAUGES for d in "xy")
    check.near("rest, volume", statistics["Fluid volume (m^dim)"][-1], volume, 1e-8)
    check.below("rest, pressure over that at the bottom", error / (WEIGHT * HEIGHT), 1e-8)
    check.below("rest, speed at the gauges (m/s)", speed, 1e-10)
    check.near("rest, force on the floor", statistics["floor force y (N)"][-1], -WEIGHT * volume, 1e-7)
    check.near("rest, potential energy", statistics["Potential energy (J)"][-1], 0.5 * HEIGHT * WEIGHT * volume, 1e-7)
    check_volume(check, "rest", statistics, 1e-12)


def check_fall(check):
    """A cylinder of 0.2 m radius and height: the case of the plane, whose square is its section."""
    statistics = read_run(check.run("free_motion/free_fall.prm", "Geometry=rotational symmetry"))
    mass = 1000. * math.pi * 0.2**3
    kinetic_energy = 0.5 * mass * (GRAVITY * statistics["Time (s)"])**2
    energy = statistics["Kinetic energy (J)"] + statistics["Potential energy (J)"]
    check.below("fall, kinetic energy, relative error",
                np.abs(statistics["Kinetic energy (J)"] / kinetic_energy - 1.).max(), 1e-9)
    check.below("fall, change of energy over the final kinetic energy", np.ptp(energy) / kinetic_energy[-1], 1e-9)
    check.below("fall, change of the radius", np.ptp(statistics["right (m)"]) / 0.2, 1e-9)
    check_volume(check, "fall", statistics, 1e-12)


def check_drop(check):
    statistics = read_run(check.run("rotational_symmetry/ellipsoidal_drop.prm"))
    check_axes(check, statistics, dict(zip("rz", exact_axes(statistics["Time (s)"]))), "drop, ")
    check_volume(check, "drop", statistics, 1e-4)


def check_plug(check):
    statistics = read_run(check.run("rotational_symmetry/plug.prm"))
    for name in ("axis", "middle", "wall"):
        speed = statistics[f"{name} velocity y (m/s)"][-1]
        check.near(f"plug, velocity, {name} (m/s)", speed, -WEIGHT * 0.05 / 4e4, 1e-3)
    check.near("plug, friction (N)", statistics["side force y (N)"][-1], -WEIGHT * math.pi * 0.05**2 * 0.1, 1e-4)
    check_volume(check, "plug", statistics, 1e-8)


def check_current(check):
    statistics = read_run(check.run("rotational_symmetry/gravity_current.prm"))
    time, volume, viscosity = 20., math.pi * 0.1**2 * 0.02, 0.01
    radius = 0.894 * (GRAVITY * volume**3 * time / (3. * viscosity))**0.125
    check.near(f"current, radius at {time:g} s (m)", statistics["front (m)"][-1], radius, 0.01)
    check.near(f"current, depth at {time:g} s (m)", statistics["height (m)"][-1],
               4. * volume / (3. * math.pi * radius**2), 0.02)
    check_volume(check, "current", statistics, 1e-4)


def check_cone(check):
    end = 1.
    statistics = read_run(check.run(ROOT / "prm" / "slump" / "mini_cone_rz.prm", f"End time={end}"))
    last = statistics["Time (s)"] > end - 0.06
    theory = spread(Cone(0.05, 0.05, 0.035, 2252., 4.018, 18.0182), [end - 0.03], rings_until=0.12)[0]
    check.near(f"cone, spread at {end - 0.03:.2f} s (m)", 2. * statistics["front (m)"][last].mean(), theory, 0.02)
    check_volume(check, "cone", statistics, 5e-3)


def main():
    check = Check(__doc__)
    check_rest(check)
    check_fall(check)
    check_drop(check)
    check_plug(check)
    check_current(check)
    check_cone(check)
    check.finish()


if __name__ == "__main__":
    run_check(main)
