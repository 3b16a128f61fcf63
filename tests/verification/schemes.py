# SPDX-License-Identifier: GPL-3.0-or-later
"""The coupled and the segregated scheme agree on front and pressure within the nonlinear tolerance."""

import numpy as np

from verification import Check, read_run, run_check


def main():
    check = Check(__doc__)
    coupled = read_run(check.run("schemes/coupled.prm"))
    segregated = read_run(check.run("schemes/segregated.prm"))
    tolerance = 2e-4  # twice that of the increments
    for column in ("front (m)", "height (m)", "inside pressure (Pa)"):
        difference = np.abs(coupled[column] - segregated[column]).max() / np.abs(coupled[column]).max()
        check.below(f"{column}, largest difference over its largest value", difference, tolerance)
    for name, run in (("coupled", coupled), ("segregated", segregated)):
        print(f"  {name}: {np.median(run['Nonlinear iterations']):.0f} iterations in the median, "
              f"{run['Nonlinear iterations'].max():.0f} at most")
    check.finish()


run_check(main)
