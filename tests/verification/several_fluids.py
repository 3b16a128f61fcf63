#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Several fluids: layers rest with the exact pressure, in the plane and in space; waves of surface and interface have the
period of linear theory; a heavy fluid sinks into a light one at the rate of linear theory; behind a lock both fluids run
with the speed of an inviscid current; mud rests under water, and slides into it while each keeps its volume; a run that is resumed goes on bit for bit, two ranks compute what one does.

    several_fluids.py --lahar PROGRAM --output DIRECTORY [--cases NAME ...]
"""

import sys

import numpy as np

from verification import Check, check_balance_of_momentum, fluid_fronts, read_run, run_check, volume_changes

GRAVITY = 9.81
names = ["layers", "surface_wave", "short_lock", "resumed"]
if "--cases" in sys.argv:
    at = sys.argv.index("--cases")
    names = sys.argv[at + 1:]
    del sys.argv[at:]


def check_volumes(check, name, run, fluids, tolerance):
    """Of all fluid by cause, of each fluid of both causes together: what the solver lets pass an interface, remeshing
    gives back."""
    for cause, change in zip(("solver", "remeshing"), volume_changes(run)):
        check.below(f"{name}: volume change by {cause}", change, tolerance)
    for fluid in fluids:
        change = sum(run[f"{fluid} volume change by {cause}"] for cause in ("solver", "remeshing"))
        check.below(f"{name}: volume change of {fluid}", np.abs(change).max(), tolerance)


def check_rest(check, name, heights, *settings):
    """Mud from 0 to 0.1 m and water from there to 0.2 m."""
    case = "several_fluids/layers_3d.prm" if "space" in name else "several_fluids/layers.prm"
    run = read_run(check.run(case, *settings))
    error = speed = 0.
    for gauge, y in heights.items():
        exact = -GRAVITY * (1000. * (0.2 - max(y, 0.1)) + 2000. * max(0.1 - y, 0.))
        error = max(error, np.abs(run[f"{gauge} pressure (Pa)"] - exact).max() / (300. * GRAVITY))
        speed = max(speed, *(np.abs(run[f"{gauge} velocity {d} (m/s)"]).max() for d in ("xyz" if "space" in name else "xy")))
    check.below(f"{name}: pressure over that at the bottom", error, 1e-10)
    check.below(f"{name}: speed at the gauges (m/s)", speed, 1e-10)
    check.below(f"{name}: mean speed from the kinetic energy (m/s)",
                (2. * run["Kinetic energy (J)"].max() / (10. if "space" not in name else 4.))**0.5, 1e-10)
    check_volumes(check, name, run, ("mud", "water"), 1e-12)
    check.below(f"{name}: volume exchanged", run["Volume exchanged between fluids"].max(), 1e-12)


def check_layers(check):
    heights = {"a": 0.002, "b": 0.05, "c": 0.0973, "d": 0.1, "e": 0.1137, "f": 0.195}
    for law in ("no slip", "free slip"):
        check_rest(check, f"layers, {law}", heights, f"Boundaries/walls/Law={law}")
    check_rest(check, "layers in space", heights)


def extrema(time, values):
    """Times of the maxima, by the parabola through each and its neighbours."""
    places = [i for i in range(1, len(values) - 1) if values[i] > values[i - 1] and values[i] >= values[i + 1]]
    result = []
    for i in places:
        c, b, a = np.polynomial.polynomial.polyfit(time[i - 1:i + 2] - time[i], values[i - 1:i + 2], 2)
        result.append(time[i] - b / (2. * a))
    return result


def check_wave(check, name, period):
    """The kinetic energy is largest a quarter and three quarters of a period after the start."""
    run = read_run(check.run(f"several_fluids/{name}.prm"))
    peaks = extrema(run["Time (s)"], run["Kinetic energy (J)"])
    check.near(f"{name}: period (s)", 2. * (peaks[1] - peaks[0]), period, 0.01)
    check_volumes(check, name, run, ("brine", "water"), 1e-4)


def growth_rate(early, late):
    """σ of an energy that grows as sinh²(σ t), from two pairs of time and energy, by bisection."""
    ratio = np.sqrt(late[1] / early[1])
    lower, upper = 1e-3, 100.
    for _ in range(60):
        middle = 0.5 * (lower + upper)
        lower, upper = (middle, upper) if np.sinh(middle * late[0]) / np.sinh(middle * early[0]) < ratio else (lower, middle)
    return lower


def rayleigh_taylor_rate():
    """Chandrasekhar, Hydrodynamic and Hydromagnetic Stability (1961), § 94, equation 113, for equal kinematic viscosities;
    the depth of the layers enters the weight only."""
    k, nu, light, heavy = np.pi, 0.01, 0.25, 0.75
    weight, contrast = 10. * np.tanh(k), (light - heavy) * nu

    def relation(n):
        q = np.sqrt(k**2 + n / nu)
        return (-(weight * k / n**2 * (light - heavy) + 1.) * (q - k) - 4. * k * light * heavy
                + 4. * k**2 / n * contrast * (heavy - light) * (q - k) + 4. * k**3 / n**2 * contrast**2 * (q - k)**2)

    lower, upper = 1., np.sqrt(weight * k * (heavy - light))
    for _ in range(60):
        middle = 0.5 * (lower + upper)
        lower, upper = (middle, upper) if relation(middle) * relation(upper) < 0. else (lower, middle)
    return lower


def check_rayleigh_taylor(check):
    """While the amplitude is small it grows as cosh(σ t), the velocity as sinh(σ t)."""
    run = read_run(check.run("several_fluids/rayleigh_taylor.prm"))
    early, late = ((t, float(np.interp(t, run["Time (s)"], run["Kinetic energy (J)"]))) for t in (0.4, 0.8))
    check.near("heavy on light: growth rate (1/s)", growth_rate(early, late), rayleigh_taylor_rate(), 0.02)
    check_volumes(check, "heavy on light", run, ("light", "heavy"), 1e-4)


def check_lock(check, name, times, symmetry, *settings):
    """The fronts' mean speeds between two times, of the heavy fluid at the bottom and of the light one at the top, against
    that of a current that keeps its energy in a tank of the same depth (Benjamin 1968), and against each other."""
    directory = check.run("several_fluids/lock_exchange.prm", *settings)
    time, fronts = fluid_fronts(directory)
    begin, end = (int(np.argmin(abs(time - t))) for t in times)
    heavy = (fronts[end, 0, 1] - fronts[begin, 0, 1]) / (time[end] - time[begin])
    light = (fronts[begin, 1, 0] - fronts[end, 1, 0]) / (time[end] - time[begin])
    check.near(f"{name}: mean speed of the fronts (m/s)", 0.5 * (heavy + light), 0.5, 0.05)
    check.below(f"{name}: difference of the two over it", abs(heavy - light) / 0.5, symmetry, f"{heavy:.4f}, {light:.4f}, ")
    check_volumes(check, name, read_run(directory), ("heavy", "light"), 1e-3)


SHORT_LOCK = ["Mesh size=0.1", "Time step=0.05", "End time=3.5",
              "Fluids/heavy/box/Corners=0, 0 : 2.5, 1", "Fluids/light/box/Corners=2.5, 0 : 5, 1",
              "Boundaries/walls/polyline/Points=0, 0 : 5, 0 : 5, 1 : 0, 1 : 0, 0"]


def check_heap(check):
    run = read_run(check.run("several_fluids/heap.prm"))
    mass = 1800. * 0.5 * 0.12 * 0.06 + 1000. * (0.025 - 0.0036)
    check.below("heap: mean speed at the end (m/s)", (2. * run["Kinetic energy (J)"][-1] / mass)**0.5, 1e-4)
    check_volumes(check, "heap", run, ("mud", "water"), 1e-4)


def check_momentum(check, name, run, tolerance):
    check_balance_of_momentum(check, name, run, {"mud": 1600., "water": 1000.}, ["ground"], tolerance)


def check_slide(check):
    run = read_run(check.run("several_fluids/mud_slide.prm"))
    check_volumes(check, "slide", run, ("mud", "water"), 1e-3)
    check_momentum(check, "slide", run, 1e-4)


COLUMNS = ("Fluid volume (m^dim)", "Kinetic energy (J)", "Potential energy (J)", "mud volume (m^dim)", "water volume (m^dim)",
           "Volume exchanged between fluids")
SHORT = ["Mesh size=0.03", "Time step=5e-3"]


def compare(check, name, runs, tolerance):
    for column in COLUMNS:
        scale = max(np.abs(runs[0][column]).max(), 1e-300) if "exchanged" not in column else 1.
        check.below(f"{name}: '{column}'", np.abs(runs[0][column] - runs[1][column]).max() / scale, tolerance)


def check_resumed(check):
    """The slide in two parts, the second one from a checkpoint."""
    settings = [*SHORT, "Checkpoint/Steps between=10"]
    whole = read_run(check.run("several_fluids/mud_slide.prm", *settings, "End time=0.3"))
    check.run("several_fluids/mud_slide.prm", *settings, "End time=0.2")
    resumed = read_run(check.run("several_fluids/mud_slide.prm", *settings, "End time=0.3", resume=True))
    compare(check, "resumed", (whole, resumed), 0. if check.n_ranks == 1 else 1e-6)
    check_momentum(check, "resumed", resumed, 1e-4)


def check_ranks(check):
    """Two ranks and one, with a tight tolerance: rounding is all that may differ."""
    n_ranks, runs = check.n_ranks, []
    for check.n_ranks in (1, n_ranks):
        runs.append(read_run(check.run("several_fluids/mud_slide.prm", *SHORT, "End time=0.3",
                                       "Nonlinear solver/Tolerance=1e-9")))
    compare(check, f"{n_ranks} ranks", runs, 1e-6)


def main():
    check = Check(__doc__)
    checks = {"layers": check_layers, "surface_wave": lambda c: check_wave(c, "surface_wave", 1.1882),
              "interface_wave": lambda c: check_wave(c, "interface_wave", 4.6934),
              "rayleigh_taylor": check_rayleigh_taylor, "heap": check_heap,
              "short_lock": lambda c: check_lock(c, "short lock", (1.5, 3.5), 0.05, *SHORT_LOCK),
              "lock": lambda c: check_lock(c, "lock", (2., 5.), 0.05), "slide": check_slide,
              "resumed": check_resumed, "ranks": check_ranks}
    for name in names:
        checks[name](check)
    check.finish()


run_check(main)
