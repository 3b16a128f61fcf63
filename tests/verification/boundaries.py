#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundaries that resist and boundaries that move: a stiff block slides and stops by each law of friction as a mass point
does, a bore runs before a piston, a drum takes its fluid along; with a gate that is lifted over a floor with friction a
resumed run goes on bit for bit."""

import math
import shutil
import signal
import subprocess
import time

import numpy as np

from verification import CASES, Check, CheckError, at_time, on_ranks, read_run, run_check, volume_changes

DENSITY, HEIGHT, WIDTH = 1000., 0.05, 0.2
MASS = DENSITY * HEIGHT * WIDTH
ALONG, ACROSS = 4.905, 8.4957  # gravity, m/s²
# The zeros of the Bessel function J1, and J0 there.
BESSEL = [(3.83170597, -0.40275940), (7.01558667, 0.30011575), (10.1734681, -0.24970488), (13.3236919, 0.21835941),
          (16.4706301, -0.19646537), (19.6158585, 0.18006338), (22.7600844, -0.16718460), (25.9036721, 0.15672499)]


def bessel_1(x):
    """J1(x) by its integral."""
    angle = (np.arange(2000) + 0.5) * math.pi / 2000.
    return float(np.cos(angle - x * np.sin(angle)).mean())


def check_friction(check):
    """The block's velocity v obeys m dv/dt = m g_x − A (β v + τ_c)."""
    def velocity(law, *settings):
        statistics = read_run(check.run("boundaries/sliding_block.prm", f"Boundaries/floor/Law={law}", *settings))
        # The momentum in the middle of the step.
        time = statistics["Time (s)"] - 0.5 * statistics["Time step size (s)"]
        force = statistics["floor force x (N)"]
        return time, statistics["Momentum x (N s)"] / MASS, force, statistics["floor force y (N)"]

    time, v, force, weight = velocity("Coulomb")
    check.below("Coulomb: velocity, over the one at the start", np.abs(v - (1. + (ALONG - 0.3 * ACROSS) * time)).max(), 2e-3)
    settled = slice(20, None)
    check.near("Coulomb: mean normal force, over the weight", -weight[settled].mean() / (MASS * ACROSS), 1., 1e-3)
    check.near("Coulomb: mean friction over mean normal force", -force[settled].mean() / weight[settled].mean(), 0.3, 1e-3)

    # On an incline of 10 degrees it stops after v0/(g (μ cos − sin)) and stays.
    gravity = 1.7035, 9.661
    time, v, force, weight = velocity("Coulomb", "Gravity=%g, %g" % (gravity[0], -gravity[1]),
                                      "Fluids/block/Initial velocity=0.3; 0")
    exact = np.maximum(0.3 - (0.3 * gravity[1] - gravity[0]) * time, 0.)
    check.below("Coulomb: velocity until it stops, over the one at the start", np.abs(v - exact).max() / 0.3, 5e-3)
    check.below("Coulomb: velocity once it has stopped, over the one at the start", np.abs(v[exact == 0.][20:]).max() / 0.3,
                1e-4)
    check.near("Coulomb: the floor holds it", force[-10:].mean() / (MASS * gravity[0]), 1., 1e-3)

    # Grains whose lower part is full of water, on a level floor: the water's pressure below them makes no friction, except at
    # the block's ends, where the floor's is lower.
    soil = "Fluids/block/Drucker-Prager"
    time, v, force, weight = velocity("Coulomb", "Gravity=0, -9.81", "Fluids/block/Law=Drucker-Prager", f"{soil}/Viscosity=1e6",
                                      f"{soil}/Friction angle=0", f"{soil}/Pore water level=0.02", f"{soil}/Pore water density=600")
    effective = (DENSITY * HEIGHT - 600. * 0.02) / (DENSITY * HEIGHT)
    check.below("Coulomb, pore water: velocity, over the one at the start", np.abs(v - (1. - 0.3 * 9.81 * effective * time)).max(), 1e-2)
    check.near("Coulomb, pore water: mean normal force, over the weight", -weight[settled].mean() / (MASS * 9.81), 1., 1e-3)

    time, v, *rest = velocity("Navier slip")
    rate = 250. / (DENSITY * HEIGHT)
    end = ALONG / rate
    check.below("Navier slip: velocity", np.abs(v - (end + (1. - end) * np.exp(-rate * time))).max(), 5e-3)

    time, v, *rest = velocity("yield slip")
    end = (ALONG - 150. / (DENSITY * HEIGHT)) / rate
    check.below("yield slip: velocity", np.abs(v - (end + (1. - end) * np.exp(-rate * time))).max(), 5e-3)
    time, v, force, weight = velocity("yield slip", "Boundaries/floor/yield slip/Sliding yield stress=300", "End time=0.6")
    end = (ALONG - 300. / (DENSITY * HEIGHT)) / rate
    exact = np.maximum(end + (1. - end) * np.exp(-rate * time), 0.)
    check.below("yield slip: velocity until it stops", np.abs(v - exact).max(), 5e-3)
    check.below("yield slip: velocity once it has stopped", np.abs(v[exact == 0.][20:]).max(), 1e-4)


def check_slab(check):
    """The same block on an elastic slab, along which it slides by the same laws."""
    def velocity(law, *settings):
        statistics = read_run(check.run("boundaries/block_on_slab.prm", f"Solids/slab/Surface/Law={law}", *settings))
        time = statistics["Time (s)"] - 0.5 * statistics["Time step size (s)"]
        solver, remeshing = volume_changes(statistics)
        check.below(f"slab, {law}: volume change by the solver", solver, 1e-7)
        check.below(f"slab, {law}: volume change by remeshing", remeshing, 1e-5)
        momentum = statistics["Momentum x (N s)"]
        force = statistics["slab fluid force x (N)"]
        balance = np.diff(momentum) / statistics["Time step size (s)"][1:] - MASS * ALONG + force[1:]
        # The first step counts half.
        check.below(f"slab, {law}: balance of momentum, over the weight", np.abs(balance[1:]).max() / (MASS * ACROSS), 1e-3)
        return time, momentum / MASS, force, statistics["slab fluid force y (N)"]

    settled = slice(20, None)
    time, v, force, weight = velocity("free slip")
    check.below("slab, free slip: velocity", np.abs(v - (1. + ALONG * time))[1:].max(), 2e-3)
    check.near("slab, free slip: mean normal force, over the weight", -weight[settled].mean() / (MASS * ACROSS), 1., 1e-3)

    time, v, force, weight = velocity("Coulomb")
    check.below("slab, Coulomb: velocity", np.abs(v - (1. + (ALONG - 0.3 * ACROSS) * time)).max(), 2e-3)
    check.near("slab, Coulomb: mean normal force, over the weight", -weight[settled].mean() / (MASS * ACROSS), 1., 1e-3)
    check.near("slab, Coulomb: mean friction over mean normal force", -force[settled].mean() / weight[settled].mean(), 0.3, 1e-3)

    time, v, *rest = velocity("Navier slip", "Solids/slab/Clamped=", "Solids/slab/Driven=-0.1, -0.025 : 0.6, -0.025",
                              "Solids/slab/Driving velocity=0.5; 0", "Solids/slab/Initial velocity=0.5; 0")
    rate = 250. / (DENSITY * HEIGHT)
    end = 0.5 + ALONG / rate
    check.below("driven slab, Navier slip: velocity", np.abs(v - (end + (1. - end) * np.exp(-rate * time))).max(), 5e-3)


def check_piston(check):
    """Shallow water: c² = g h1 (h1 + h0)/(2 h0), U = c (1 − h0/h1)."""
    statistics = read_run(check.run("boundaries/piston.prm"))
    low, high = 0.1, 0.3
    for _ in range(60):
        h1 = 0.5 * (low + high)
        c = math.sqrt(9.81 * h1 * (h1 + 0.1) / 0.2)
        low, high = (h1, high) if c * (1. - 0.1 / h1) < 0.3 else (low, h1)
    solver, remeshing = volume_changes(statistics)
    check.below("piston: volume change by the solver", solver, 1e-7)
    check.below("piston: volume change by remeshing", remeshing, 2e-3)
    late = statistics["Time (s)"] > 0.3
    check.near("piston: force", -statistics["piston force x (N)"][late].mean(), 0.5 * DENSITY * 9.81 * h1**2, 0.02)
    momentum = statistics["Momentum x (N s)"]
    rate = (momentum[-1] - momentum[len(momentum) // 2]) / (statistics["Time (s)"][-1] -
                                                          statistics["Time (s)"][len(momentum) // 2])
    check.near("piston: momentum in a second", rate, DENSITY * h1 * 0.3 * (c - 0.3), 0.03)


def check_drum(check):
    """v = ω r + 2 ω R Σ J1(j r/R)/(j J0(j)) exp(−ν j² t/R²), J1(j) = 0."""
    statistics = read_run(check.run("boundaries/drum.prm"))
    omega, radius, nu, r = 2., 0.1, 0.01, 0.05
    for instant in (0.04, 0.1, 0.2):
        exact = omega * r + 2. * omega * radius * sum(
            bessel_1(j * r / radius) / (j * j0) * math.exp(-nu * j**2 * instant / radius**2) for j, j0 in BESSEL)
        # The velocity is that of the middle of the step.
        check.near(f"drum: velocity at half the radius at {instant} s",
                   at_time(statistics, "half velocity y (m/s)", instant + 1e-3), exact, 0.02)
    check.below("drum: volume change by the solver", volume_changes(statistics)[0], 1e-7)


def interrupt(check, prm, n_steps, *settings):
    """Run the case until it has made some steps, as check.run() would, and stop it by a signal."""
    directory = (check.output / "interrupted").resolve()
    shutil.rmtree(directory, ignore_errors=True)
    command = [str(check.lahar)]
    for setting in (f"Output directory={directory}", *settings):
        command += ["--set", setting]
    command, environment = on_ranks([*command, str(CASES / prm)], check.mpiexec, check.n_ranks)
    run = subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    while run.poll() is None:
        time.sleep(0.02)
        try:
            n = sum(not line.startswith("#") for line in (directory / "statistics").read_text().splitlines())
        except OSError:
            continue
        if n >= n_steps:
            run.send_signal(signal.SIGTERM)
            break
    run.wait()
    n = len(read_run(directory)["Time (s)"])
    command.insert(command.index("--set"), "--resume")
    if subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL).returncode != 0:
        raise CheckError(f"{prm}: the resumed run fails")
    return n, directory


def check_gate(check):
    # On several ranks MUMPS does not sum in the same order twice: with friction the iteration may then end elsewhere within
    # its tolerance, which has to be small against what is compared.
    settings = ("Nonlinear solver/Tolerance=1e-7", "Nonlinear solver/Maximum iterations=60") if check.n_ranks > 1 else ()
    whole = read_run(check.run("boundaries/lifted_gate.prm", *settings))
    check.below("gate: volume change by the solver", volume_changes(whole)[0], 1e-7)
    check.below("gate: volume change by remeshing", volume_changes(whole)[1], 5e-3)
    n, directory = interrupt(check, "boundaries/lifted_gate.prm", 30, *settings)
    check.below("gate: where the run was interrupted, over its steps", n / len(whole["Time (s)"]), 0.99)
    resumed = read_run(directory)
    tolerance = 0. if check.n_ranks == 1 else 1e-6
    for name in ("Fluid volume (m^dim)", "Kinetic energy (J)", "gate force x (N)", "floor force x (N)", "back force x (N)"):
        difference = np.abs(whole[name] - resumed[name]).max() / np.abs(whole[name]).max()
        check.below(f"gate: '{name}' of the resumed run", difference, tolerance)


def main():
    check = Check(__doc__)
    check_friction(check)
    check_slab(check)
    check_drum(check)
    check_piston(check)
    check_gate(check)
    check.finish()


run_check(main)
