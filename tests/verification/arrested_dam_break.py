#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""V7: a shallow pile of Bingham fluid comes to rest where lubrication theory says, the nearer to it the finer the mesh."""

import numpy as np

from verification import Check, last_mesh, read_reference, read_run, run_check, volume_changes

LENGTH, HEIGHT, B = 1., 0.1, 0.2
MESH_SIZES = 0.02, 0.01, 0.005


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


def front_of_next_order():
    """The arrested front with the stress along the flow, m.

    The bed yields and so does the fluid above it, s_xx = sqrt(tau0^2 - s_xy^2), s_xy = tau0 (1 - y/h). A slice then
    carries N = -rho g h^2/2 + pi tau0 h/2 and N' = tau0, so that with b = pi tau0/(2 rho g)

        h = b + sqrt(b^2 + 2 tau0/(rho g) (X - x)),

    and X follows from the volume. Compare Dubash et al., J. Non-Newtonian Fluid Mech. 158 (2009) 91-100.
    """
    slope = B * HEIGHT**2 / LENGTH  # tau0/(rho g)
    b = 0.5 * np.pi * slope
    lower, upper = LENGTH, 3. * LENGTH
    for _ in range(60):
        front = 0.5 * (lower + upper)
        volume = b * front + ((b**2 + 2. * slope * front)**1.5 - b**3) / (3. * slope)
        lower, upper = (front, upper) if volume < LENGTH * HEIGHT else (lower, front)
    return front


def main():
    check = Check(__doc__)
    reference = read_reference("arrested_dam_break/bingham_1d_arrested_dambreak_analytic.csv")
    exact_front = LENGTH * float(np.interp(B, reference["B"], reference["X_over_L"]))

    fronts = []
    for size in MESH_SIZES:
        # The collapse is over after 5 s.
        check.run("arrested_dam_break/arrested_dam_break.prm", f"Mesh size={size}", "End time=5")
        directory = check.run("arrested_dam_break/arrested_dam_break.prm", f"Mesh size={size}", "Time step=0.1", resume=True)
        statistics = read_run(directory)
        time, front = statistics["Time (s)"], statistics["front (m)"]
        fronts.append(front[-1])
        print(f"  h = {1000. * size:g} mm: {front[-1]:.4f} m, {statistics['Nonlinear iterations'].sum():.0f} iterations")
        check.below("volume change by solver", volume_changes(statistics)[0], 0.001)
        check.below("repeated steps", statistics["Rejected steps"][-1], 10)
    # What is thinner than a cell is missing at the front: an error of first order, 0.5, and chance, half a cell.
    first, second = np.diff(fronts)
    print(f"  order of the front in the mesh: {np.log2(first / second):.1f}")
    check.below("second difference of the meshes' fronts over the first one", abs(second / first), 0.7)
    check.near("front (m), lubrication theory", fronts[-1], exact_front, 0.05)
    check.near("front (m), with the stress along the flow", fronts[-1], front_of_next_order(), 0.02)
    last_fifth = time > 0.8 * time[-1]
    print(f"  advance of the front in the last fifth of the run: {100. * np.ptp(front[last_fifth]) / exact_front:.2f} %")
    stations = np.linspace(0.05, 0.9, 18) * exact_front
    exact = HEIGHT * np.sqrt(2. * B * (exact_front - stations) / LENGTH)
    error = np.abs(surface(last_mesh(directory), stations) - exact).max() / HEIGHT
    print(f"  surface up to 0.9 X, largest error over H: {100. * error:.1f} %")
    print(f"  volume change by remeshing: {volume_changes(statistics)[1]:.1e}")
    check.finish()


run_check(main)
