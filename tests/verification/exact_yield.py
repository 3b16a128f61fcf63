#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid with an exact yield stress. A block above its yield limit comes to rest, whatever the time step and the augmentation
parameter are, and then stands to the last digit, one iteration a step; the regularised one creeps on. A block below its
limit slumps and stops."""

import numpy as np

from verification import Check, read_run, run_check

CASE = "arrest/standing_block.prm"
MASS = 10.
SETTINGS = ("Time integration=backward Euler", "Nonlinear solver/Maximum iterations=60")
EXACT = (*SETTINGS, "Fluids/fluid/Bingham/Yield=exact")


def main():
    check = Check(__doc__)

    def run(*settings):
        return read_run(check.run(CASE, *settings))

    def speed(statistics, mass=MASS):
        return np.sqrt(2. * statistics["Kinetic energy (J)"] / mass)

    def check_rest(name, statistics, n_steps, mass=MASS):
        check.below(f"{name}: root mean square of the last {n_steps} steps' velocities (m/s)",
                    speed(statistics, mass)[-n_steps:].max(), 1e-10)
        front = statistics["front (m)"][-n_steps:]
        check.below("... change of the front in them", front.max() - front.min(), 0.)
        check.below("... iterations a step", statistics["Nonlinear iterations"][-n_steps:].max(), 1)

    for ratio in (0.35, 0.5):
        stress = f"Fluids/fluid/Bingham/Yield stress={ratio * 981.:g}"
        for augmentation in (1000, 4000):
            check_rest(f"{ratio:g} rho g H, steps of 10 ms, r = {augmentation} s",
                       run(*EXACT, stress, "Time step=1e-2", "End time=0.3",
                           f"Fluids/fluid/Bingham/Augmentation parameter={augmentation}"), 10)
    check_rest("0.4 rho g H, steps of 1 ms",
               run(*EXACT, "Fluids/fluid/Bingham/Yield stress=392.4", "End time=0.03"), 10)

    # A mass of 10 m with a step in which 1000 s are too few: r τ0 is 7 times μ + ρ H²/Δt.
    large = ("Mesh size=0.7", "Boundaries/walls/polyline/Points=-30, 0 : 80, 0", "Fluids/fluid/box/Corners=0, 0 : 10, 10",
             "Fluids/fluid/Bingham/Density=2000", "Fluids/fluid/Bingham/Plastic viscosity=100",
             "Fluids/fluid/Bingham/Yield stress=68670", "Fluids/fluid/Bingham/Augmentation parameter=auto")
    large_block = run(*EXACT, *large, "Time step=0.02", "End time=1", "Output interval=1")
    check_rest("0.35 rho g H, H = 10 m, r chosen", large_block, 10, mass=2e5)
    check.below("... steps repeated", large_block["Rejected steps"][-1], 0)

    creeps = speed(run(*SETTINGS, "Time step=1e-2", "End time=0.3"))
    check.below("0.35 rho g H, regularised: 1e-5 m/s over the velocities of the last steps", 1e-5 / creeps[-10:].min(), 1.)

    slump = ("Fluids/fluid/Bingham/Yield stress=200", "Time step=5e-3", "End time=1", "Mesh size=0.0083")
    exact = run(*EXACT, *slump)
    check_rest("0.2 rho g H", exact, 20)
    way = exact["front (m)"][-1] - 0.1
    check.near("... way of the front, that of the regularised fluid", way, run(*SETTINGS, *slump)["front (m)"][-1] - 0.1, 0.05)
    check.finish()


run_check(main)
