#!/usr/bin/python3
"""V7: a shallow pile of Bingham fluid comes to rest where lubrication theory says."""

import numpy as np

from verification import Check, last_mesh, read_reference, read_run, run_check, volume_changes

LENGTH, HEIGHT, B = 1., 0.1, 0.2


def surface(mesh, stations):
    """The highest fluid at each of @p stations (m)."""
    corners = mesh.points[mesh.triangles]
    heights = np.zeros(len(stations))
    for i, j in ((0, 1), (1, 2), (2, 0)):
        a, b = corners[:, i], corners[:, j]
        for k, x in enumerate(stations):
            cut = (a[:, 0] - x) * (b[:, 0] - x) < 0.
            if cut.any():
                weight = (x - a[cut, 0]) / (b[cut, 0] - a[cut, 0])
                heights[k] = max(heights[k], np.max(a[cut, 1] + weight * (b[cut, 1] - a[cut, 1])))
    return heights


def main():
    check = Check(__doc__)
    directory = check.run("arrested_dam_break/arrested_dam_break.prm")
    statistics = read_run(directory)
    reference = read_reference("arrested_dam_break/bingham_1d_arrested_dambreak_analytic.csv")
    exact_front = LENGTH * float(np.interp(B, reference["B"], reference["X_over_L"]))

    time, front = statistics["Time (s)"], statistics["front (m)"]
    check.near("front (m)", front[-1], exact_front, 0.05)
    last_fifth = time > 0.8 * time[-1]
    print(f"  advance of the front in the last fifth of the run: {100. * np.ptp(front[last_fifth]) / exact_front:.2f} %")
    stations = np.linspace(0.05, 0.9, 18) * exact_front
    exact = HEIGHT * np.sqrt(2. * B * (exact_front - stations) / LENGTH)
    error = np.abs(surface(last_mesh(directory), stations) - exact).max() / HEIGHT
    print(f"  surface up to 0.9 X, largest error over H: {100. * error:.1f} %")
    by_solver, by_remeshing = volume_changes(statistics)
    print(f"  volume change by remeshing: {100. * by_remeshing:.1f} %")
    check.below("volume change by solver", by_solver, 0.001)
    check.finish()


run_check(main)
