#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces of the fluid: at rest the walls carry its weight, each boundary its part of it; in a dam break against an elastic
barrier all forces, the weight and the account of what remeshing changes sum up to the change of momentum; columns of
means are the means.
"""

import numpy as np

from verification import Check, read_pvd, read_run, run_check

GRAVITY, DENSITY = 9.81, 1000.


def columns(statistics, text, directions="xy"):
    return np.array([statistics[text % d] for d in directions])


def check_rest(check):
    statistics = read_run(check.run("hydrostatic_column/newtonian_no_slip.prm",
                                    "Postprocess/Wall forces/Boxes=all: -1, -1 : 1, 1"))
    force = columns(statistics, "all force %s (N)")
    weight = DENSITY * GRAVITY * statistics["Fluid volume (m^dim)"]
    check.below("rest, force on all walls less the weight, over it", np.abs(force[1] / -weight - 1.).max(), 1e-8)
    check.below("rest, force along x over the weight", np.abs(force[0] / weight).max(), 1e-8)
    difference = np.abs(columns(statistics, "walls force %s (N)") - force).max()
    check.below("rest, force on the boundary less that on all walls, over the weight", difference / weight.max(), 1e-8)


def check_boundaries(check):
    """Between a floor and two sides without friction each has the force of the pressure on it, the corners' parts too."""
    sides = [f"Boundaries/{name}/{entry}" for name, x in (("left", "0"), ("right", "0.1"))
             for entry in ("Shape=polyline", f"polyline/Points={x}, 0 : {x}, 0.25", "Law=free slip")]
    statistics = read_run(check.run("hydrostatic_column/newtonian_slip.prm", "Boundaries=slip walls, left, right",
                                    "Boundaries/slip walls/polyline/Points=0, 0 : 0.1, 0", *sides))
    weight, thrust = DENSITY * GRAVITY * 0.1 * 0.2, 0.5 * DENSITY * GRAVITY * 0.2**2
    for name, exact in (("slip walls", (0., -weight)), ("left", (-thrust, 0.)), ("right", (thrust, 0.))):
        error = np.abs(columns(statistics, name + " force %s (N)") - np.array([exact]).T).max()
        check.below(f"rest, force on the boundary '{name}' over the weight", error / weight, 1e-8)


def check_dam_break(check):
    directory = check.run("forces/dam_break.prm")
    statistics = read_run(directory)
    time, step = statistics["Time (s)"], statistics["Time step size (s)"]
    check.below("dam break, difference of the steps' lengths", np.ptp(step), 1e-12)
    walls = columns(statistics, "walls force %s (N)")
    in_box = columns(statistics, "everywhere force %s (N)")
    check.below("dam break, force on the boundary less that on walls in a box around it, over the largest",
                np.abs(walls - in_box).max() / np.abs(in_box).max(), 1e-7)
    barrier = columns(statistics, "barrier fluid force %s (N)")
    weight = np.array([np.zeros(len(time)), -DENSITY * GRAVITY * statistics["Fluid volume (m^dim)"]])
    impulse = np.cumsum((weight - walls - barrier) * step, axis=1)
    momentum = columns(statistics, "Momentum %s (N s)")
    by_remeshing = columns(statistics, "Momentum change by remeshing %s (N s)")
    by_solver = columns(statistics, "Momentum change by solver %s (N s)")
    by_lag = columns(statistics, "Momentum change by lag %s (N s)")
    of_a_step = (np.abs(walls + barrier) * step).max()
    error = np.abs(momentum - impulse - by_remeshing - by_solver - by_lag).max(axis=1) / of_a_step
    print(f"  momentum at most {np.abs(momentum).max():.4g} N s, impulse of a step at most {of_a_step:.3g} N s, by remeshing x {by_remeshing[0][-1]:.4g}, y {by_remeshing[1][-1]:.4g} N s, "
          f"impulse on the barrier {(barrier[0] * step).sum():.4g} N s")
    for d in range(2):
        check.below(f"dam break, momentum less impulses and changes along {'xy'[d]} over a step's impulse", error[d], 0.03)
    check.below("dam break, pull on the barrier over the largest force", -barrier[0].min() / barrier[0].max(), 0.01)

    # The mean since the last snapshot, at the snapshots.
    outputs = [t for t, _ in read_pvd(directory / "solution.pvd")]
    total = np.r_[0., np.cumsum(barrier[0] * step)]
    at = [0] + [int(np.argmin(abs(time - t))) + 1 for t in outputs[1:]]
    means = np.array([(total[b] - total[a]) / (time[b - 1] - (time[a - 1] if a else 0.)) for a, b in zip(at, at[1:])])
    given = statistics["barrier mean fluid force x (N)"][np.array(at[1:]) - 1]
    check.below("dam break, mean columns at the snapshots over the largest", np.abs(given - means).max() / np.abs(means).max(),
                1e-7)


def main():
    check = Check(__doc__)
    check_rest(check)
    check_boundaries(check)
    check_dam_break(check)
    check.finish()


run_check(main)
