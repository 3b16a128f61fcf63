#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""B2, the mini slump cone, on a coarse mesh: spread and height after the collapse against the theory of thin layers.

Theory: contrib/plot/thin_layer.py, with the radial stress above the bed. It has no inertia, so it counts from the time on at
which the collapse is over. Its own limits are checked, too: rest, lubrication theory's closed form D = 2 (225 V²/(128 pi²
l))^(1/5) with l = tau0/(rho g) (N. Roussel, P. Coussot, J. Rheol. 49 (2005) 705-718); no yield stress, H. E. Huppert's
D = 1.788 (rho g V³ t/(3 mu))^(1/8) (J. Fluid Mech. 121 (1982) 43-58).
"""

import dataclasses
import math

import numpy as np

from verification import ROOT, Check, read_pvd, read_run, read_vtu, run_check, volume_changes  # adds contrib/plot to the path

from mesh_geometry import rim_radius
from thin_layer import GRAVITY, Cone, arrested_spread, spread

MINI = Cone(0.05, 0.05, 0.035, 2252., 4.018, 18.0182)
ABRAMS = Cone(0.3, 0.1, 0.05, 2200., 255., 32.)
END = 0.5
SIZE = 0.01


def check_theory(check):
    for cone in (MINI, ABRAMS):
        length = cone.yield_stress / (cone.density * GRAVITY)
        check.near("theory, at rest", arrested_spread(cone, order=0.),
                   2. * (225. * cone.volume**2 / (128. * math.pi**2 * length))**0.2, 1e-3)
    newtonian = dataclasses.replace(ABRAMS, yield_stress=1e-9)
    time = 20.
    check.near("theory, without yield stress", spread(newtonian, [time], order=0., n_rings=300, rings_until=0.4)[0],
               1.788 * (2200. * GRAVITY * newtonian.volume**3 * time / (3. * newtonian.viscosity))**0.125, 0.01)


def main():
    check = Check(__doc__)
    check_theory(check)
    directory = check.run(ROOT / "prm" / "slump" / "mini_cone.prm", f"Mesh size={SIZE}", f"End time={END}")
    statistics = read_run(directory)
    # The front flickers by a part of the mesh size: the mean of four directions and of some time.
    last = statistics["Time (s)"] > END - 0.06
    measured = np.mean([statistics[f"spread{direction} (m)"][last].mean() for direction in ("", " 45", " 90", " 135")])
    check.near(f"spread at {END - 0.03:.2f} s (m)", measured, spread(MINI, [END - 0.03], rings_until=0.12)[0], 0.03)
    # The rim: what of the flow is farthest from the axis, by sectors of 1.5 mesh sizes.
    mesh = read_vtu(read_pvd(directory / "solution.pvd")[-1][1], 3)
    rim = rim_radius(mesh.points, SIZE)
    check.below("standard deviation of the rim over the angle, over the mesh size", rim.std() / SIZE, 0.25)
    for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
        check.below(f"volume change by {cause}", change, 5e-3)
    check.finish()


run_check(main)
