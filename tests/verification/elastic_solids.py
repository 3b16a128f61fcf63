#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""V8 (in space too), V9 and V2 of elastic solids: cantilevers, vibrations, free flight, hydrostatic load, a floating block."""

import numpy as np

from verification import Check, read_run, run_check

# The barrier of the dam breaks, plane strain with nu = 0: E, rho, height, thickness.
YOUNG, DENSITY, HEIGHT, THICKNESS = 1e6, 2500., 0.08, 0.012
SHEAR_FACTOR = 5. / 6.
# Bisshopp & Drucker 1945, P L^2/(E I) = 2: transverse displacement and shortening of the tip over the length.
ELASTICA = (0.493457, 0.160642)


def timoshenko_frequency(young, density, length, thickness):
    """First frequency of a clamped-free Timoshenko beam, nu = 0 (Huang, J. Appl. Mech. 28 (1961) 579-584), and that of
    Euler and Bernoulli, Hz."""
    r2 = thickness**2 / (12. * length**2)
    s2 = r2 * 2. / SHEAR_FACTOR
    scale = np.sqrt(young * thickness**2 / (12. * density * length**4))

    def equation(b):
        root = np.sqrt((r2 - s2)**2 + 4. / b**2)
        alpha, beta = np.sqrt((root - r2 - s2) / 2.), np.sqrt((root + r2 + s2) / 2.)
        return (2. + (b**2 * (r2 - s2)**2 + 2.) * np.cosh(b * alpha) * np.cos(b * beta)
                - b * (r2 + s2) / np.sqrt(1. - b**2 * r2 * s2) * np.sinh(b * alpha) * np.sin(b * beta))

    lower, upper = 2., 3.7
    for _ in range(60):
        middle = 0.5 * (lower + upper)
        lower, upper = (middle, upper) if equation(lower) * equation(middle) > 0. else (lower, middle)
    return lower * scale / (2. * np.pi), 1.8751041**2 * scale / (2. * np.pi)


def beam_deflection(load, length, thickness, young):
    """Tip of a cantilever under a uniform load: bending and shear."""
    return load * length**4 / (8. * young * thickness**3 / 12.) + load * length**2 / (SHEAR_FACTOR * young * thickness)


def measured_frequency(time, tip):
    rising = np.flatnonzero((tip[:-1] < 0.) & (tip[1:] >= 0.))
    zeros = time[rising] - tip[rising] * (time[rising + 1] - time[rising]) / (tip[rising + 1] - tip[rising])
    return (len(zeros) - 1) / (zeros[-1] - zeros[0])


def test_cantilever(check):
    for law in ("hypoelastic", "neo-Hookean"):
        tip = read_run(check.run("elastic_solids/cantilever.prm", f"Solids/beam/Law={law}"))
        check.near(f"{law}, large deflection", tip["tip y (m)"][-1], ELASTICA[0], 0.01)
        check.near(f"{law}, shortening", -tip["tip x (m)"][-1], ELASTICA[1], 0.01)


def test_cantilever_in_space(check):
    """A square rod: with nu = 0 it bends as the plane beam under the same traction."""

    def tip(law, solver):
        return read_run(check.run("elastic_solids/cantilever.prm", f"Solids/beam/Law={law}", f"Linear solver/Type={solver}",
                                  "Dimension=3", "Gravity=0, 0, 0", "End time=1e5", "Output interval=1e5",
                                  "Solids/beam/box/Corners=0, 0, 0 : 1, 0.02, 0.02", "Solids/beam/box/Elements=30, 1, 1",
                                  "Solids/beam/Clamped=0, 0, 0 : 0, 0.02, 0.02",
                                  "Solids/beam/Loaded=1, 0, 0 : 1, 0.02, 0.02",
                                  "Solids/beam/Traction=0; 0; 100*min(1, t/1e5)",
                                  "Postprocess/Solid points/Points=tip: 1, 0.01, 0.01"))

    # Multigrid that does not know the rotations fails in the first step.
    for law, solver in (("hypoelastic", "direct"), ("neo-Hookean", "direct"), ("hypoelastic", "iterative")):
        run, name = tip(law, solver), f"{law} in space, {solver} solver"
        check.near(f"{name}, large deflection", run["tip z (m)"][-1], ELASTICA[0], 0.01)
        check.near(f"{name}, shortening", -run["tip x (m)"][-1], ELASTICA[1], 0.01)
        check.below(f"{name}, deflection sideways (m)", abs(run["tip y (m)"][-1]), 1e-3)


def test_pressure(check):
    exact = beam_deflection(1., HEIGHT, THICKNESS, YOUNG)

    def tip(degree, n):
        run = read_run(check.run("elastic_solids/barrier_pressure.prm", f"Solids/Degree={degree}",
                                 f"Solids/barrier/box/Elements={n}, {7 * n}"))
        return run["tip x (m)"][-1]

    check.near("quadratic elements, one through the thickness", tip(2, 1), exact, 0.01)
    check.near("quadratic elements, two", tip(2, 2), exact, 0.002)
    errors = [1. - tip(1, n) / exact for n in (2, 4, 8)]
    print(f"  linear elements, 2, 4 and 8 through the thickness: {', '.join(f'{-100. * e:.1f} %' for e in errors)}")
    order = np.log2(errors[1] / errors[2])
    check.below("linear elements, order of convergence", abs(order - 2.), 0.35, f"{order:.2f}, difference from 2: ")


def mode(coordinate):
    """The velocity of the first mode, as in the .prm file."""
    k = 23.4388
    return (f"0.02*((cosh({k}*{coordinate}) - cos({k}*{coordinate}))/2"
            f" - 0.734096*(sinh({k}*{coordinate}) - sin({k}*{coordinate}))/2)")


def test_vibration(check):
    run = read_run(check.run("elastic_solids/barrier_vibration.prm"))
    timoshenko, bernoulli = timoshenko_frequency(YOUNG, DENSITY, HEIGHT, THICKNESS)
    frequency = measured_frequency(run["Time (s)"], run["tip x (m)"])
    print(f"  frequency {frequency:.4f} Hz; beam with shear and rotary inertia {timoshenko:.4f} Hz, without {bernoulli:.4f} Hz")
    check.near("first frequency of the barrier", frequency, timoshenko, 0.01)
    energy = run["Solid kinetic energy (J)"] + run["Solid elastic energy (J)"]
    check.below("energy over ten periods", np.ptp(energy) / energy[0], 1e-3)

    # A square prism in space.
    run = read_run(check.run("elastic_solids/barrier_vibration.prm", "Dimension=3", "Gravity=0, 0, 0",
                             "Solids/barrier/box/Corners=0, 0, 0 : 0.012, 0.012, 0.08", "Solids/barrier/box/Elements=1, 1, 7",
                             "Solids/barrier/Clamped=0, 0, 0 : 0.012, 0.012, 0",
                             "Solids/barrier/Initial velocity=" + mode("z") + "; 0; 0",
                             "Postprocess/Solid points/Points=tip: 0.006, 0.006, 0.08", "End time=0.85",
                             "Time step=4e-3"))
    check.near("first frequency of a prism in space", measured_frequency(run["Time (s)"], run["tip x (m)"]), timoshenko, 0.01)
    energy = run["Solid kinetic energy (J)"] + run["Solid elastic energy (J)"]
    check.below("its energy over five periods", np.ptp(energy) / energy[0], 1e-3)

    # A slender one, to which the theory without shear applies.
    run = read_run(check.run("elastic_solids/barrier_vibration.prm", "Solids/barrier/box/Corners=0, 0 : 0.003, 0.08",
                             "Solids/barrier/box/Elements=1, 20", "Solids/barrier/Clamped=0, 0 : 0.003, 0",
                             "Postprocess/Solid points/Points=tip: 0, 0.08", "End time=3", "Time step=4e-3"))
    check.near("first frequency of a slender barrier", measured_frequency(run["Time (s)"], run["tip x (m)"]),
               timoshenko_frequency(YOUNG, DENSITY, HEIGHT, 0.003)[1], 0.01)


def test_driven_foot(check):
    """A foot that is accelerated from rest: the tip lags behind by the deflection under the weight rho a."""
    acceleration, period = 0.1, 1. / timoshenko_frequency(YOUNG, DENSITY, HEIGHT, THICKNESS)[0]
    run = read_run(check.run("elastic_solids/barrier_vibration.prm", "Solids/barrier/Clamped=",
                             "Solids/barrier/Driven=0, 0 : 0.012, 0", "Solids/barrier/Initial velocity=1; 0",
                             f"Solids/barrier/Driving velocity=1 + {acceleration}*t; 0",
                             f"End time={6. * period:.6g}", f"Time step={period / 100.:.6g}",
                             f"Output interval={6. * period:.6g}",
                             "Postprocess/Solid points/Points=tip: 0.006, 0.08; foot: 0.006, 0"))
    time = run["Time (s)"]
    foot = time + 0.5 * acceleration * time**2
    check.below("path of a driven foot (m)", np.abs(run["foot x (m)"] - foot).max(), 2e-9)  # nine digits are written
    lag = (foot - run["tip x (m)"]).mean()  # over whole periods of the only mode of weight
    check.near("lag of the tip of an accelerated barrier", lag,
               beam_deflection(DENSITY * THICKNESS * acceleration, HEIGHT, THICKNESS, YOUNG), 0.01)


def test_flight(check):
    for law in ("hypoelastic", "neo-Hookean"):
        run = read_run(check.run("elastic_solids/flying_block.prm", f"Solids/block/Law={law}"))
        time = run["Time (s)"]
        # The rule is exact for constant acceleration; the node in the middle vibrates a little about the centre of mass.
        path = np.hypot(run["centre x (m)"] - time, run["centre y (m)"] - (2. * time - 4.905 * time**2))
        check.below(f"{law}, path of the centre (m)", path.max(), 1e-6)
        energy = sum(run[f"Solid {kind} energy (J)"] for kind in ("kinetic", "potential", "elastic"))
        spin = 0.5 * 1000. * 100. * 0.1 * 0.04 * (0.1**2 + 0.04**2) / 12.
        check.below(f"{law}, energy over that of the spin", np.ptp(energy) / spin, 2e-3)


def test_hydrostatic_wall(check):
    young, thickness, depth, weight = 1e8, 0.01, 0.1, 9810.
    stiffness = young * thickness**3 / 12.
    bottom = weight * depth
    level = bottom * depth**4 / (30. * stiffness) + bottom * depth**2 / (6. * SHEAR_FACTOR * 0.5 * young * thickness)
    forces = []
    for h, n in ((0.01, 12), (0.005, 24)):
        run = read_run(check.run("elastic_solids/hydrostatic_wall.prm", f"Mesh size={h}",
                                 f"Solids/wall/box/Elements=1, {n}"))
        forces.append(-run["wall support force x (N)"][-1])
    check.near("deflection at the water's level", run["level x (m)"][-1], level, 0.01)
    print(f"  force {forces[0]:.2f} and {forces[1]:.2f} N; without the cell in the corner below, first order in h")
    check.near("force on the wall, extrapolated", 2. * forces[1] - forces[0], 0.5 * bottom * depth, 0.01)
    check.below("support and fluid balance (N)", abs(forces[1] - run["wall fluid force x (N)"][-1]), 0.05)


def test_floating_block(check):
    # At rest to 1 % from 1.3 s on.
    run = read_run(check.run("elastic_solids/floating_block.prm", "Time step=4e-3", "End time=1.8"))
    weight, height, length, width, h = 500. * 0.1 * 0.05 * 9.81, 0.05, 0.1, 0.4, 0.01
    force = run["block fluid force y (N)"][-25:]
    check.near("buoyancy of a floating block against its weight", force.mean(), weight, 0.01)
    # The fluid's volume (and the two corners without a cell) and half of the block fill the tank up to the level.
    level = (run["Fluid volume (m^dim)"][-1] + 2. * 0.5 * h**2 + 0.5 * length * height) / width
    draught = level - (0.225 + run["centre y (m)"][-1] - 0.5 * height)
    check.near("its draught", draught, 0.5 * height, 0.05)


def main():
    check = Check(__doc__)
    for test in (test_cantilever, test_cantilever_in_space, test_pressure, test_vibration, test_driven_foot, test_flight,
                 test_hydrostatic_wall, test_floating_block):
        test(check)
    check.finish()


run_check(main)
