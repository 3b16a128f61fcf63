#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""V5 in space: the semi-axes of an inviscid drop follow the exact solution; volume and energy are kept.

With u = (s x, s y, −2 s z), the pressure −(ρ k/2) (1 − r²/a² − z²/c²) and the semi-axes a, a, c the equations of motion are
s' = k/a² − s², k = 6 s²/(2/a² + 1/c²), a' = s a, c' = −2 s c.
"""

import numpy as np

from verification import Check, read_run, run_check, volume_changes

RATE = -50.  # s at the start, 1/s


def exact_axes(times, n_steps=200):
    """The semi-axes a and c (m) at @p times by Runge and Kutta's method, @p n_steps from one to the next."""
    def slope(state):
        a, c, s = state
        k = 6. * s**2 / (2. / a**2 + 1. / c**2)
        return np.array([s * a, -2. * s * c, k / a**2 - s**2])

    state, now, axes = np.array([1., 1., RATE]), 0., []
    for time in times:
        h = (time - now) / n_steps
        for _ in range(n_steps):
            k1 = slope(state)
            k2 = slope(state + 0.5 * h * k1)
            k3 = slope(state + 0.5 * h * k2)
            k4 = slope(state + h * k3)
            state = state + h / 6. * (k1 + 2. * k2 + 2. * k3 + k4)
        now = time
        axes.append(state[:2])
    return np.array(axes).T


def check_axes(check, statistics, exact_by_name, prefix=""):
    """The extents of these names follow the exact semi-axes by step, and the kinetic energy is kept."""
    times = statistics["Time (s)"]
    # The particles need not stand where the axes end: extents are compared with those after the first step.
    for name, exact in exact_by_name.items():
        extent = statistics[f"{name} (m)"]
        error = extent / extent[0] / (exact / exact[0]) - 1.
        for time in (3.8e-3, 7.6e-3):
            row = int(np.argmin(abs(times - time)))
            check.below(f"{prefix}semi-axis {name} at {1e3 * time:.1f} ms, {exact[row]:.4f} m", abs(error[row]), 0.005)
    energy = statistics["Kinetic energy (J)"]
    check.below(prefix + "change of energy", abs(energy / energy[0] - 1.).max(), 1e-3)


def main():
    check = Check(__doc__)
    statistics = read_run(check.run("ellipsoidal_drop/ellipsoidal_drop.prm"))
    a, c = exact_axes(statistics["Time (s)"])
    check_axes(check, statistics, {"x": a, "y": a, "z": c})
    for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
        check.below(f"volume change by {cause}", change, 1e-4)
    check.finish()


if __name__ == "__main__":
    run_check(main)
