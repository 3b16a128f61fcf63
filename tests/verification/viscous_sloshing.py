#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""V4: the standing wave has the period and the decay of Prosperetti's solution."""

import numpy as np

from verification import Check, read_reference, read_run, run_check, volume_changes


def peak(time, elevation, near):
    """Time and height of the parabola through the three highest values around the time @p near."""
    window = np.flatnonzero(abs(time - near) < 0.6)
    i = window[np.argmax(elevation[window])]
    c, b, a = np.polynomial.polynomial.polyfit(time[i - 2:i + 3] - time[i], elevation[i - 2:i + 3], 2)
    return time[i] - b / (2. * a), c - b * b / (4. * a)


def main():
    check = Check(__doc__)
    statistics = read_run(check.run("viscous_sloshing/viscous_sloshing.prm"))
    exact = read_reference("viscous_sloshing/viscous_sloshing_prosperetti.csv")
    # The highest point of the surface is at the left wall while the wave is up there, as it is around the peaks.
    time, elevation = statistics["Time (s)"], statistics["height (m)"] - 1.

    peaks, exact_peaks = ([peak(t, a, near) for near in (3.6, 7.15)]
                          for t, a in ((time, elevation), (exact["t"], exact["a"])))
    for n, (found, expected) in enumerate(zip(peaks, exact_peaks), start=1):
        check.near(f"amplitude of peak {n} (m)", found[1], expected[1], 0.05)
        check.near(f"time of peak {n} (s)", found[0], expected[0], 0.01)
    check.near("period (s)", peaks[1][0] - peaks[0][0], exact_peaks[1][0] - exact_peaks[0][0], 0.01)
    for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
        check.below(f"volume change by {cause}", change, 1e-4)
    check.finish()


run_check(main)
