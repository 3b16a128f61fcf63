#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A block above its yield limit stands: it creeps by the regularisation alone, at a speed that is inverse to the
regularisation parameter and independent of time step and mesh. A block below its limit slumps and stops; a wedge takes few
iterations at its thin end."""

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
    creep_in_long_steps = front("Time step=1e-2")[-1]
    check.near("creep, ten times the time step", creep_in_long_steps, creep, 0.1)
    # The viscous part, in what has not yielded up to 500 Pa s, is nothing beside the plastic one.
    thinning = [f"Fluids/fluid/Herschel-Bulkley/{entry}" for entry in ("Density=1000", "Yield stress=343", "Consistency=5")]
    check.near("creep of a Herschel-Bulkley fluid of this yield stress",
               front("Time step=1e-2", "Fluids/fluid/Law=Herschel-Bulkley", *thinning)[-1], creep_in_long_steps, 0.03)
    check.near("creep, twice the mesh size", front("Time step=1e-2", "Mesh size=0.0125")[-1], creep, 0.2)
    # Stress and its distribution stay, so that m times the strain rate does.
    creep_of_2000 = front("Fluids/fluid/Bingham/Regularization parameter=2000")[-1]
    check.near("twice the creep with twice the regularisation parameter", 2. * creep_of_2000, creep, 0.1)

    slump = front("Fluids/fluid/Bingham/Yield stress=245", "Time step=5e-3", "End time=1")
    check.below("a twentieth of the width over the way of the front, 0.25 rho g H", 0.05 * WIDTH / slump[-1], 1.)
    check.below("... its way since 0.5 s over the width", (slump[-1] - slump[len(slump) // 2]) / WIDTH, 5e-3)

    # A layer that tapers off is thinner than the mesh at its end: what gives way to the bed there must not come back.
    wedge = read_run(check.run("../bentonite_slope/case_a_2d.prm", "Fluids/fluid/Shape=polygon", "End time=0.05",
                               "Fluids/fluid/polygon/Corners=-0.3024, 0 : 0, 0 : 0, 0.0756",
                               "Fluids/fluid/Bingham/Yield stress=21.1"))
    check.below("iterations a step of a wedge, mean", wedge["Nonlinear iterations"].mean(), 5.5)
    check.finish()


run_check(main)
