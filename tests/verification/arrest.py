#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A block above its yield limit stands: it creeps by the regularisation alone, at a speed that is inverse to the
regularisation parameter and independent of time step and mesh. A block below its limit slumps and stops."""

from verification import Check, read_run, run_check

WIDTH = 0.1
CASE = "arrest/standing_block.prm"


def main():
    check = Check(__doc__)

    def front(*settings):
        return read_run(check.run(CASE, *settings))["front (m)"] - WIDTH

    creep = front()[-1]
    # Papanastasiou's stress is 0.95 of the yield stress at the strain rate 3/m.
    check.below("creep in 0.2 s over the width", creep / WIDTH, 0.2 * 3. / 1000.)
    check.near("creep, ten times the time step", front("Time step=1e-2")[-1], creep, 0.1)
    check.near("creep, twice the mesh size", front("Time step=1e-2", "Mesh size=0.0125")[-1], creep, 0.2)
    # Stress and its distribution stay, so that m times the strain rate does.
    creep_of_2000 = front("Fluids/fluid/Bingham/Regularization parameter=2000")[-1]
    check.near("twice the creep with twice the regularisation parameter", 2. * creep_of_2000, creep, 0.1)

    slump = front("Fluids/fluid/Bingham/Yield stress=245", "Time step=5e-3", "End time=1")
    check.below("a twentieth of the width over the way of the front, 0.25 rho g H", 0.05 * WIDTH / slump[-1], 1.)
    check.below("... its way since 0.5 s over the width", (slump[-1] - slump[len(slump) // 2]) / WIDTH, 5e-3)
    check.finish()


run_check(main)
