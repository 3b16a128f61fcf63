#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The L-box in the plane: a column of concrete flows into a channel when the gate is lifted; the heights at both ends late in
the flow, against a thin layer at rest, h² = h_1² − 2 τ0 x/(ρ g).

    l_box.py --lahar PROGRAM --output DIRECTORY [--full]
"""

import math
import sys

import numpy as np

from verification import ROOT, Check, at_time, read_run, run_check, volume_changes

DENSITY, GRAVITY, YIELD_STRESS = 2300., 9.81, 50.
LENGTH, VOLUME = 0.8, 0.06
full = "--full" in sys.argv
if full:
    sys.argv.remove("--full")


def heights_at_rest():
    """h at both ends, by bisection for h_1: the integral of h is (h_1³ − h_2³)/(3 l), l = τ0/(ρ g)."""
    length = YIELD_STRESS / (DENSITY * GRAVITY)
    low, high = math.sqrt(2. * length * LENGTH), 1.
    for _ in range(100):
        first = 0.5 * (low + high)
        last = math.sqrt(first**2 - 2. * length * LENGTH)
        low, high = (first, high) if (first**3 - last**3) / (3. * length) < VOLUME else (low, first)
    return first, last


def main():
    check = Check(__doc__)
    first, last = heights_at_rest()
    end = 40. if full else 10.
    settings = [f"End time={end}"] if full else [f"End time={end}", "Mesh size=0.02"]
    statistics = read_run(check.run(ROOT / "prm" / "l_box" / "l_box_2d.prm", *settings))
    # It comes to rest as 1/t.
    back, front = at_time(statistics, "back (m)", end), at_time(statistics, "end (m)", end)
    check.near(f"height at the back at {end:g} s, at rest (m)", back, first, 0.03 if full else 0.08)
    check.near(f"height at the end at {end:g} s, at rest (m)", front, last, 0.07 if full else 0.2)
    if full:
        earlier = 0.5 * end
        check.near("height at the back, extrapolated to rest (m)", 2. * back - at_time(statistics, "back (m)", earlier), first, 0.02)
        check.near("height at the end, extrapolated to rest (m)", 2. * front - at_time(statistics, "end (m)", earlier), last, 0.03)
    reached = float(np.interp(0.5, statistics["front (m)"], statistics["Time (s)"]))
    check.near("t_40, against the mesh of 10 mm (s)", reached, 1.529, 0.05)
    check.below("volume change by the solver", volume_changes(statistics)[0], 1e-5)
    check.below("volume change by remeshing", volume_changes(statistics)[1], 5e-3)
    check.below("repeated steps", statistics["Rejected steps"][-1], 5)
    check.finish()


run_check(main)
