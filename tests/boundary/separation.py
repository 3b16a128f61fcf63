#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test boundaries that fluid leaves where they pull: a layer hangs on a ceiling that bears its weight, and falls freely
from one that bears a little less, in the plane and in space; a plate that is lifted off a pool takes nothing along; a
resumed run is the same bit for bit, two ranks compute the same; what cannot separate is refused.

Usage: separation.py LAHAR MPIEXEC
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "contrib", "plot"))

from lahar_output import read_statistics  # noqa: E402
from program_test import check, failed, fluid, new_case, on_ranks, parts, section, wall  # noqa: E402

LAHAR, MPIEXEC = os.path.abspath(sys.argv[1]), sys.argv[2]

DENSITY, GRAVITY, STEP = 1000., 9.81, 1e-3


def water(viscosity):
    return "set Law = Newtonian\n" + section("Newtonian", f"set Density = {DENSITY:g}", f"set Viscosity = {viscosity:g}")


def separating(strength):
    return f"set Separates = true\nset Tensile strength = {strength:g}\n"


COMMON = f"""
set Output directory = out
set Time step        = {STEP:g}
set Maximum time step = {STEP:g}
set Output interval  = 0.01
set Time integration = backward Euler
"""

# In a shaft without friction, 0.2 m wide and 0.05 m deep below the ceiling: the tension is ρ g H all over it.
WIDTH, DEPTH = 0.2, 0.05
HANGING = COMMON + "set End time = 0.01\nset Mesh size = 0.0125\n" + fluid("0, 0 : 0.2, 0.05", water(1.))


def hanging(more):
    return HANGING + parts("Boundaries", {"ceiling": wall("-0.1, 0.05 : 0.3, 0.05", "free slip") + more,
                                          "left": wall("0, 0.1 : 0, -0.1", "free slip"),
                                          "right": wall("0.2, 0.1 : 0.2, -0.1", "free slip")})


# A pool, a plate in the middle of its surface that is lifted with 2 m/s².
LIFTED = COMMON + "set End time = 0.02\nset Mesh size = 0.0125\n" + fluid("0, 0 : 0.4, 0.05", water(1.))


def lifted(more):
    return LIFTED + parts("Boundaries", {
        "tank": wall("0, 0.1 : 0, 0 : 0.4, 0 : 0.4, 0.1", "free slip"),
        "plate": wall("0.1, 0.05 : 0.3, 0.05 : 0.3, 0.07 : 0.1, 0.07 : 0.1, 0.05", "free slip") + more +
        "set Motion = translation\n" + section("translation", "set Displacement = 0; t*t")})


# In space the hanging layer again.
SPACE = COMMON.replace("set Time step", "set Dimension = 3\nset Gravity = 0, 0, -9.81\nset Time step") + """
set End time  = 0.005
set Mesh size = 0.025
""" + fluid("0, 0, 0 : 0.1, 0.1, 0.05", water(1.))


def hanging_in_space(more):
    return SPACE + parts("Boundaries", {
        "ceiling": wall("-0.1, -0.1, 0.05 : 0.2, -0.1, 0.05 : 0.2, 0.2, 0.05 : -0.1, 0.2, 0.05", "free slip") + more,
        "shaft": wall("0, 0, 0.1 : 0.1, 0, 0.1 : 0.1, 0, -0.1 : 0, 0, -0.1; 0, 0.1, 0.1 : 0.1, 0.1, 0.1 : 0.1, 0.1, -0.1 : 0, 0.1, -0.1;"
                      "0, 0, 0.1 : 0, 0.1, 0.1 : 0, 0.1, -0.1 : 0, 0, -0.1; 0.1, 0, 0.1 : 0.1, 0.1, 0.1 : 0.1, 0.1, -0.1 : 0.1, 0, -0.1",
                      "free slip")})


def run(directory, *arguments, n_ranks=1):
    command, environment = on_ranks([LAHAR, *arguments, "case.prm"], MPIEXEC, n_ranks)
    return subprocess.run(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)


def statistics(parent, name, text, *arguments, n_ranks=1):
    directory = new_case(parent, name, text)
    process = run(directory, *arguments, n_ranks=n_ranks)
    check(f"{name}: the run succeeds", process.returncode == 0, process.stdout[-500:], process.stderr)
    return read_statistics(os.path.join(directory, "out", "statistics"))


def test_hanging(parent):
    mass, tension = DENSITY * WIDTH * DEPTH, DENSITY * GRAVITY * DEPTH
    for name, more in [("pulled", ""), ("strong", separating(1.01 * tension))]:
        held = statistics(parent, name, hanging(more))
        check(f"{name}: the ceiling bears the weight",
              np.abs(held["ceiling force y (N)"] / (mass * GRAVITY) + 1.)[:3].max() < 1e-3, held["ceiling force y (N)"])
    free = statistics(parent, "weak", hanging(separating(0.99 * tension)))
    time, momentum = free["Time (s)"], free["Momentum y (N s)"]
    check("weak: the ceiling bears the weight in the first step", abs(free["ceiling force y (N)"][0] / (mass * GRAVITY) + 1.) < 1e-3)
    check("weak: no force afterwards", np.all(free["ceiling force y (N)"][1:] == 0.), free["ceiling force y (N)"])
    check("weak: falls freely", np.abs(momentum / (mass * GRAVITY) + (time - STEP)).max() < 1e-6,
          momentum / (mass * GRAVITY) + (time - STEP))


def test_lifted(parent):
    pulled = statistics(parent, "suction", lifted(""))
    check("suction: without separation the pool pulls the plate", pulled["plate force y (N)"][3:].max() < -10.,
          pulled["plate force y (N)"])
    free = statistics(parent, "lifted", lifted(separating(0.)))
    check("lifted: no force on the plate after the first step", np.all(free["plate force y (N)"][1:] == 0.),
          free["plate force y (N)"])
    weight = DENSITY * GRAVITY * 0.4 * 0.05
    check("lifted: the pool stays", np.abs(free["tank force y (N)"][-5:] / weight + 1.).max() < 0.02, free["tank force y (N)"])
    check("lifted: the volume stays", abs(free["Fluid volume (m^dim)"][-1] / 0.02 - 1.) < 1e-3)


def test_space(parent):
    weight = DENSITY * GRAVITY * 0.1 * 0.1 * 0.05
    text = hanging_in_space(separating(0.3 * DENSITY * GRAVITY * 0.05))
    one = statistics(parent, "space", text)
    momentum, time = one["Momentum z (N s)"], one["Time (s)"]
    # The first step on the first mesh in space does not hold it at rest to the last digit.
    fallen = (momentum - momentum[0]) / weight
    # 1e-3 of g Δt, the iteration's tolerance in the first step of the fall.
    check("space: falls freely", np.abs(fallen + (time - STEP)).max() < 2e-6, fallen + (time - STEP))
    check("space: no force after the first step", np.all(one["ceiling force z (N)"][1:] == 0.), one["ceiling force z (N)"])
    two = statistics(parent, "space_2", text, n_ranks=2)
    check("space: two ranks compute the same", np.abs(momentum - two["Momentum z (N s)"]).max() < 1e-8 * np.abs(momentum).max())


def test_resumed(parent):
    whole = statistics(parent, "whole", lifted(separating(0.)))
    directory = new_case(parent, "parts", lifted(separating(0.)))
    check("the first part succeeds", run(directory, "--set", "End time=0.01").returncode == 0)
    check("the second part succeeds", run(directory, "--resume").returncode == 0)
    found = read_statistics(os.path.join(directory, "out", "statistics"))
    check("the resumed run is the same bit for bit",
          all(np.array_equal(whole[name], found[name]) for name in whole if name != "Wall time (s)"))


def test_refused(parent):
    for name, text, words in [
            ("particles", hanging(separating(0.)).replace("free slip", "wall particles"),
             ["Boundaries/ceiling/Separates", "'wall particles'"]),
            ("alone", hanging("set Tensile strength = 5\n"), ["Boundaries/ceiling/Tensile strength", "'5'"]),
            ("negative", hanging(separating(-1.)), ["Tensile strength", "-1"])]:
        process = run(new_case(parent, "refused_" + name, text))
        check(f"refused: {name}", process.returncode == 2 and all(word in process.stderr for word in words),
              process.returncode, process.stderr)


with tempfile.TemporaryDirectory() as parent_directory:
    test_hanging(parent_directory)
    test_lifted(parent_directory)
    test_space(parent_directory)
    test_resumed(parent_directory)
    test_refused(parent_directory)
sys.exit(1 if failed else 0)
