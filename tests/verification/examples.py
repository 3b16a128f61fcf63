#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of prm/examples begin as doc/examples.md says, and the force of a squeezed disc is that of a thin layer."""

import numpy as np

from verification import CASES, Check, read_run, run_check, volume_changes

YIELD_STRESS, VISCOSITY, SPEED = 200., 5., 0.01  # of squeeze_flow.prm, Pa, Pa s, m/s
GAP, RADIUS = 0.02, 0.05                         # at the start, m


def thin_layer(time):
    """Force (N) on the plate without inertia, weight and the stress at the rim: at the radius r a thin layer flows as
    between plates at rest, with the stress τ0/φ at the plates: τ0 h/(6μφ) (1 − 3φ/2 + φ³/2) = U r/(2h)."""
    gap = GAP - SPEED * time
    radius = np.linspace(0., RADIUS * np.sqrt(GAP / gap), 2001)
    lower, upper = np.full_like(radius, 1e-9), np.ones_like(radius)
    for _ in range(60):
        middle = 0.5 * (lower + upper)
        is_fast = (YIELD_STRESS * gap / (6. * VISCOSITY * middle) * (1. - 1.5 * middle + 0.5 * middle**3)
                   > SPEED * radius / (2. * gap))
        lower, upper = np.where(is_fast, middle, lower), np.where(is_fast, upper, middle)
    return np.trapz(2. * YIELD_STRESS / (middle * gap) * np.pi * radius**2, radius)


def main():
    check = Check(__doc__)
    examples = sorted((CASES.parent / "examples").glob("*.prm"))
    check.below("examples that are missing", 7 - len(examples), 0.5)
    for path in examples:
        statistics = read_run(check.run(f"../examples/{path.name}", "End time=0.012", "Time step=4e-3", "Output interval=0.012"))
        for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
            check.below(f"{path.name}, volume change by {cause}", change, {"solver": 1e-6, "remeshing": 1e-3}[cause])
        check.below(f"{path.name}, repeated steps", statistics["Rejected steps"][-1], 0.5)

    statistics = read_run(check.run("../examples/squeeze_flow.prm", "End time=0.85"))
    # The rim resists, too, as if some 0.3 τ0 pressed on all of the plate: the less so the thinner the disc is.
    for time, tolerance in ((0.4, 0.15), (0.8, 0.05)):
        force = np.mean(statistics["plate force y (N)"][abs(statistics["Time (s)"] - time) < 0.026])
        check.near(f"squeeze flow: force at {time:g} s", force, thin_layer(time), tolerance)
    check.finish()


run_check(main)
